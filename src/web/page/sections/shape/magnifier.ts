/** The rim through a magnifying glass: the sharp lens, the ball that touches both caps, and what they make. */
import { C, type Numbers } from "../../core";
import { html } from "../../dom";

const size = 168;

export class Magnifier {
  readonly element: HTMLElement;

  constructor(host: HTMLElement) {
    this.element = html(`<div class="magnifier" role="img"><svg viewBox="${-size / 2} ${-size / 2} ${size} ${size}" aria-hidden="true">
      <path class="sharp"></path><path class="body"></path><circle class="ball"></circle><circle class="joint" r="2.6"></circle><circle class="joint" r="2.6"></circle>
      </svg><span></span></div>`);
    host.append(this.element);
  }

  /** Of a stone, and of the sharp one that its lens is; profiles are rows of PROFILE_SIZE. */
  show(measures: Numbers, profile: Numbers, sharp: Numbers): void {
    const mm = (place: number) => 1e3 * measures[place]!;
    const lens = mm(C.MEASURE_WIDTH) / 2, half = Math.max(0.9, 1.05 * mm(C.MEASURE_BEVEL), 0.7 * (lens - mm(C.JOINT_RADIUS)) + 0.4);
    const scale = size / 2 / half, middle = lens - 0.45 * half;
    const x = (rho: number) => ((1e3 * rho - middle) * scale).toFixed(2), y = (z: number) => (-1e3 * z * scale).toFixed(2);
    const path = (rows: Numbers) => Array.from({ length: rows.length / C.PROFILE_SIZE }, (_, i) => i * C.PROFILE_SIZE)
      .map((at, i) => `${i === 0 ? "M" : "L"}${x(rows[at + C.RHO]!)} ${y(rows[at + C.ZETA]!)}`).join("");
    const find = <E extends Element>(selector: string) => this.element.querySelectorAll<E & Element>(selector);
    find(".sharp")[0]!.setAttribute("d", path(sharp));
    find(".body")[0]!.setAttribute("d", `${path(profile)}Z`);
    const ball = find(".ball")[0]!, r2 = mm(C.MINOR_RADIUS);
    const round = { cx: x(mm(C.MAJOR_RADIUS) / 1e3), cy: "0", r: (r2 * scale).toFixed(2), visibility: r2 > 0 ? "visible" : "hidden" };
    for (const [name, value] of Object.entries(round)) ball.setAttribute(name, value);
    find(".joint").forEach((dot, i) => {
      dot.setAttribute("cx", x(mm(C.JOINT_RADIUS) / 1e3));
      dot.setAttribute("cy", y((i === 0 ? 1 : -1) * measures[C.MEASURE_BEVEL]! / 2));
      dot.setAttribute("visibility", round.visibility);
    });
    const words = r2 > 0 ? "the rim, rounded" : "the rim, sharp";
    this.element.querySelector("span")!.textContent = words;
    this.element.setAttribute("aria-label", `${words}, in a magnifying glass`);
  }
}
