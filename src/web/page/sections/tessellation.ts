/** 2 Tessellation. */
import { ChoiceControl, iconButton, NumberControl, panel, type Control } from "../controls";
import { C, type Numbers } from "../core";
import { el } from "../dom";
import { evidence } from "../evidence";
import { movesByItself, onTheme } from "../look";
import { digits, fixed, Shown } from "../numbers";
import { Plot } from "../plot";
import { Readout } from "../readout";
import { Refusal } from "../refusal";
import { remember, type Section } from "../section";
import { MeshShape, type Look } from "../shapes/mesh";

type Method = "rings" | "subdivision";

const most = 5;          // levels; the next takes a second for the graph
const pause = 0.42;      // [s] for each level, while it refines by itself
const view = { target: [0, 0, 0], azimuth: -1.1, elevation: 0.62, distance: 50 } as const;

const levels = Array.from({ length: most + 1 }, (_, i) => i);

const grouped = (count: number) => String(count).replace(/(\d)(?=(\d{3})+$)/g, "$1\u202f");

export const tessellation: Section = {
  id: "tessellation",
  title: "Tessellation",
  lead: `A computer draws triangles, so the stone is cut into them: naively, by
    <b class="c-published">longitude and latitude</b>, as on a globe; or by <b class="c-exact">subdivision</b>, which halves the
    edges of a few again and again, and leaves them near equilateral. Each level has about four times as many triangles, and is
    four times as close to the stone.`,

  start(place) {
    const { goishi, stage, wide, text } = place;
    const figure = stage.figure(wide, { label: "A Go stone as triangles.", view, elevations: [-1.5, 1.5] });
    const shape = new MeshShape();
    figure.scene.add(shape);
    const great = new Shown("triangles"), off = new Shown("deviation"), sure = el("div", "small");
    const again = el("div", "corner");
    figure.overlay.append(
      el("div", "caption left", { "aria-hidden": "true" }, el("div", "great", {}, great.element), sure),
      el("div", "caption right", { "aria-hidden": "true" }, el("div", "great", {}, off.element), el("div", "small", {}, "from the stone, at most")), again);
    again.hidden = !movesByItself();
    iconButton(again, "restart", "refine it again", () => refine());
    const refused = new Refusal(wide);
    const numbers = new Readout(wide, [
      { name: "unwelded", symbol: "", label: "vertices, three for each triangle" },
      { name: "welded", symbol: "", label: "welded where place and normal agree" },
      { name: "points", symbol: "", label: "welded where the place agrees" },
      { name: "loose", symbol: "", label: "edges that are not of two triangles" },
      { name: "mesh-volume", symbol: "V", label: "volume that it encloses" },
      { name: "volume-low", symbol: "", label: "less than the stone’s" },
    ]);
    const plots = el("div", "plots");
    wide.append(plots);
    const graph = new Plot(plots, { title: "How far from the stone, by how many triangles", unit: "µm; drag to a level", veiled: false, log: { least: 1e-3 },
      lines: [{ label: "by longitude and latitude", token: "published", joined: true }, { label: "by subdivision", token: "exact", joined: true }],
      height: 150, range: () => [0.1, 3000], splits: [0.1, 1, 10, 100, 1000], tick: (value) => (value >= 1 ? String(value) : "0.1"),
      tickAcross: (value) => (Number.isInteger(value) ? grouped(10 ** value) : ""), scrub: (at) => choose(at) });

    // --- controls
    const [left, right] = panel(wide, "The cut", "The stone") as [HTMLElement, HTMLElement];
    const changed = () => {
      settle();
      renew();
      remember(place, controls);
    };
    const methods = el("div", "choices"), looks = el("div", "choices");
    const level = new NumberControl(left, { key: "level", label: "level", least: 0, greatest: most, step: 1, value: 3, whole: true }, changed);
    left.append(methods);
    const method = new ChoiceControl<Method>(methods, { key: "by", label: "cut by", value: "subdivision", choices: [
      { value: "rings", label: "longitude and latitude", token: "published" }, { value: "subdivision", label: "subdivision", token: "exact" }] }, changed);
    const bevel = new NumberControl(right, { key: "bevel", label: "bevel, its height", unit: "mm", least: 0, greatest: 6, step: 0.1, value: 1 }, changed);
    right.append(looks);
    const look = new ChoiceControl<Look>(looks, { key: "look", label: "drawn", value: "flat", choices: [
      { value: "wire", label: "as wires" }, { value: "flat", label: "shaded flat" }, { value: "smooth", label: "shaded by the surface’s normals" }] }, changed);
    const controls: Control[] = [level, method, bevel, look];

    const says = el("p", "remark", { "aria-live": "polite" });
    text.append(says);
    evidence(text, "Why it is right",
      `Each corner lies on the exact surface and has its normal, so smooth shading looks right long before the outline does. The
       distance that is shown is that of the worst point of any triangle, in closed form, and not of a sample. Corners that several
       triangles share are found by welding: by place alone, every edge belongs to two triangles, and the mesh is watertight.`, [
        ["MESH-1", "The corners lie on the surface, with its normals."],
        ["MESH-2", "The meshes are closed, each triangle faces outwards; welding finds what is shared."],
        ["MESH-3", "The distance is what is stated."],
        ["MESH-5", "Asked for a tolerance, the library keeps it by few triangles."],
        ["MESH-7", "Refined, volume and moments tend to the closed forms."],
        ["MESH-8", "At second order: halve the edges, and the error is a quarter."],
      ]);

    // --- what it is about
    interface Cut { fineness: Int32Array; figures: Numbers }
    let moving: object | null = null, stone: Numbers | null = null, cuts = new Map<string, Cut>();
    const how = (of: Method) => (of === "rings" ? C.RINGS : C.SUBDIVISION);

    function cut(of: Method, at: number): Cut {
      const key = `${of}${at}`, known = cuts.get(key);
      if (known) return known;
      const fineness = goishi.fineness(stone!, how(of), at);
      const figures = goishi.meshFigures(stone!, how(of), fineness, C.WELDED_BY_POSITION);
      const found = { fineness, figures };
      cuts.set(key, found);
      return found;
    }

    function renew(at = level.value): void {
      refused.takes(() => {
        const next = goishi.catalogueStone(33, C.WHITE, bevel.value / 1e3);
        if (!stone || next.some((value, i) => value !== stone![i])) {
          stone = next;
          cuts = new Map();
        }
        show(at);
      });
    }

    function show(at: number): void {
      const { fineness, figures } = cut(method.value, at), measures = goishi.measures(stone!);
      const [unwelded, welded] = [C.UNWELDED, C.WELDED].map((weld) =>
        goishi.meshCounts(stone!, how(method.value), fineness, weld).vertices) as [number, number];
      shape.reshape(goishi.mesh(stone!, how(method.value), fineness, C.UNWELDED));
      shape.show(look.value);
      const triangles = figures[C.MESH_TRIANGLES]!, deviation = figures[C.MESH_DEVIATION]!, loose = figures[C.MESH_LOOSE_EDGES]!;
      great.set(triangles, `${grouped(triangles)} triangles`);
      sure.textContent = `level ${at}, ${method.value === "rings" ? "longitude and latitude" : "subdivision"}`;
      off.set(deviation, `${digits(1e6 * deviation, 3)} µm`);
      numbers.set("unwelded", unwelded, grouped(unwelded));
      numbers.set("welded", welded, grouped(welded));
      numbers.set("points", figures[C.MESH_POINTS]!, grouped(figures[C.MESH_POINTS]!));
      numbers.set("loose", loose, loose === 0 ? "0: watertight" : String(loose));
      numbers.set("mesh-volume", figures[C.MESH_VOLUME]!, `${digits(1e6 * figures[C.MESH_VOLUME]!, 6)} cm³`);
      const low = 1 - figures[C.MESH_VOLUME]! / measures[C.VOLUME]!;
      numbers.set("volume-low", low, `${digits(100 * low, 3)} %`);
      graph.now(Math.log10(triangles));
      if (moving === null) {
        const all = (["rings", "subdivision"] as const).map((of) => levels.map((i) => cut(of, i).figures));
        const decades = all.map((of) => of.map((each) => Math.log10(each[C.MESH_TRIANGLES]!)));
        const x = [...new Set(decades.flat())].sort((a, b) => a - b);
        graph.set(x, all.map((of, i) => x.map((value) => {
          const which = decades[i]!.indexOf(value);
          return which < 0 ? null : 1e6 * of[which]![C.MESH_DEVIATION]!;
        })), 1, 4.45);
        graph.now(Math.log10(triangles));
        const other: Method = method.value === "rings" ? "subdivision" : "rings", them = cut(other, at).figures;
        const share = triangles / them[C.MESH_TRIANGLES]!, worse = deviation / them[C.MESH_DEVIATION]!;
        says.textContent = `By ${other === "rings" ? "longitude and latitude" : "subdivision"} the same level has ${grouped(them[C.MESH_TRIANGLES]!)} triangles, ${digits(1e6 * them[C.MESH_DEVIATION]!, 3)} µm from the stone. ` +
          (method.value === "rings" ? "The triangles of the globe crowd at the poles, where they are needed least" : "Near equilateral triangles are spread evenly") +
          `: ${fixed(share, 2)} times as many triangles, ${fixed(worse, 2)} times the distance.`;
        figure.label = `A Go stone of ${triangles} triangles, ${fixed(1e6 * deviation, 1)} micrometres from the stone at most.`;
      }
      figure.invalidate();
    }

    /** The level with a number of triangles near to a power of ten. */
    function choose(decade: number): void {
      const off = (at: number) => Math.abs(Math.log10(cut(method.value, at).figures[C.MESH_TRIANGLES]!) - decade);
      const next = levels.reduce((best, at) => (off(at) < off(best) ? at : best));
      if (next === level.value && moving === null) return;
      level.value = next;
      changed();
    }

    /** Level by level, up to that of the control. */
    function refine(): void {
      if (!movesByItself()) return;
      const owner = moving = {};
      let time = 0, seen = -1;
      stage.animate(owner, (dt) => {
        if (moving !== owner) return false;
        time += dt;
        figure.view.azimuth = view.azimuth - 0.5 * Math.max(0, 1 - time / (pause * (level.value + 1))) ** 2;
        figure.invalidate();
        const at = Math.floor(time / pause);
        if (at > level.value) {
          settle();
          return false;
        }
        if (at !== seen) renew(seen = at);
        return true;
      });
    }
    function settle(): void {
      if (!moving) return;
      stage.stop(moving);
      moving = null;
      if (stone) renew();
    }

    for (const event of ["pointerdown", "keydown"] as const) figure.element.addEventListener(event, () => settle());
    onTheme(() => {
      shape.paint();
      figure.invalidate();
    });
    let entered = false;
    return {
      controls,
      update() {
        settle();
        renew();
      },
      enter() {
        if (!entered) refine();
        entered = true;
      },
      leave() {
        settle();
      },
    };
  },
};
