/** One WebGL context for the whole page. Its canvas stands in the figure that is drawn; each other figure keeps a copy of
 * its last picture. Nothing is drawn when nothing moves, and nothing where nobody looks. */
import { Color, ColorManagement, LinearSRGBColorSpace, WebGLRenderer } from "three";
import { Figure, type FigureOptions } from "./figure";
import { onTheme } from "./look";

const scales = [0.7, 1, 1.5, 2] as const; // pixels per CSS pixel while something moves: below 1 where no graphics card draws
const slow = 20, fast = 17.5;        // [ms] of a frame: five slow ones lower the scale, ninety fast ones raise it
const settle = 140;                  // [ms] after the last picture until it is drawn once more, as finely as it can be

/** Called once a frame with the time since the last one [s]; false ends it. */
export type Step = (dt: number) => boolean;

export class Stage {
  readonly #renderer: WebGLRenderer | null;
  readonly #figures = new Set<Figure>();
  readonly #dirty = new Set<Figure>();
  readonly #coarse = new Set<Figure>();
  readonly #steps = new Map<object, Step>();
  readonly #byElement = new Map<Element, Figure>();
  readonly #resizes: ResizeObserver;
  readonly #views: IntersectionObserver;
  #live: Figure | null = null;
  #frame = 0;
  #last = 0;
  #drawn = 0; // when the last picture was
  #scale = 1;
  #finest = 2; // that a moving picture may become
  #slow = 0;
  #fast = 0;
  #settling = 0;

  constructor() {
    ColorManagement.enabled = false; // colours are given as they are shown
    let renderer: WebGLRenderer | null = null;
    try {
      renderer = new WebGLRenderer({ antialias: false, alpha: true, powerPreference: "low-power" });
      renderer.outputColorSpace = LinearSRGBColorSpace;
      renderer.setClearColor(new Color(0), 0);
      renderer.autoClear = false;
      renderer.domElement.className = "gl";
      if (byProcessor(renderer)) this.#finest = 1;
      renderer.domElement.addEventListener("webglcontextrestored", () => this.#redrawAll());
    } catch {
      renderer = null; // figures say so
    }
    this.#renderer = renderer;
    this.#resizes = new ResizeObserver((entries) => {
      for (const { target, contentRect } of entries) {
        const figure = this.#byElement.get(target);
        if (figure?.resize(contentRect.width, contentRect.height)) this.invalidate(figure);
      }
    });
    this.#views = new IntersectionObserver((entries) => {
      for (const { target, isIntersecting } of entries) {
        const figure = this.#byElement.get(target);
        if (!figure) continue;
        figure.visible = isIntersecting;
        if (isIntersecting && this.#dirty.has(figure)) this.#ask();
      }
    }, { rootMargin: "100px" });
    document.addEventListener("visibilitychange", () => {
      this.#last = 0;
      this.#ask();
    });
    onTheme(() => this.#redrawAll());
  }

  /** A figure in `host`. */
  figure(host: HTMLElement, options: FigureOptions): Figure {
    const figure = new Figure(host, options, () => this.invalidate(figure), this.#renderer !== null);
    this.#figures.add(figure);
    this.#byElement.set(figure.element, figure);
    this.#resizes.observe(figure.element);
    this.#views.observe(figure.element);
    this.invalidate(figure);
    return figure;
  }

  /** Draws a figure anew, soon. */
  invalidate(figure: Figure): void {
    this.#dirty.add(figure);
    this.#ask();
  }

  /** Calls `step` each frame until it says false; `owner` has one at a time. While one runs, the others rest. */
  animate(owner: object, step: Step): void {
    this.#steps.set(owner, step);
    this.#ask();
  }

  stop(owner: object): void {
    this.#steps.delete(owner);
  }

  #redrawAll(): void {
    for (const figure of this.#figures) {
      figure.forget();
      this.invalidate(figure);
    }
  }

  #ask(): void {
    if (this.#frame !== 0 || document.hidden) return;
    const drawn = [...this.#dirty].some((figure) => figure.visible);
    if (drawn || this.#steps.size > 0) this.#frame = requestAnimationFrame((now) => this.#tick(now));
  }

  #tick(now: number): void {
    this.#frame = 0;
    const between = this.#last === 0 ? 0 : now - this.#last;
    for (const [owner, step] of [...this.#steps]) {
      if (!step(Math.min(between / 1000, 0.1)) && this.#steps.get(owner) === step) this.#steps.delete(owner);
    }
    const moving = this.#steps.size > 0;
    this.#last = moving ? now : 0;
    for (const figure of [...this.#dirty]) {
      if (!figure.visible) continue;
      if (now - this.#drawn < 300) this.#adapt(now - this.#drawn); // one of several: something plays, or a hand turns it
      this.#drawn = now;
      this.#dirty.delete(figure);
      this.#draw(figure, this.#scale);
      this.#coarse.add(figure);
    }
    if (this.#coarse.size > 0) {
      clearTimeout(this.#settling);
      if (!moving) this.#settling = window.setTimeout(() => this.#settle(), settle);
    }
    this.#ask();
  }

  #settle(): void {
    if (this.#steps.size > 0) return;
    for (const figure of this.#coarse) this.#draw(figure, 2);
    this.#coarse.clear();
  }

  #adapt(between: number): void {
    this.#slow = between > slow ? this.#slow + 1 : 0;
    this.#fast = between < fast ? this.#fast + 1 : 0;
    const at = scales.indexOf(this.#scale as 1);
    if (this.#slow >= 5 && at > 0) {
      this.#scale = scales[at - 1]!;
      this.#slow = 0;
    } else if (this.#fast >= 90 && this.#scale < this.#finest) {
      this.#scale = scales[at + 1]!;
      this.#fast = 0;
    }
  }

  #draw(figure: Figure, scale: number): void {
    const renderer = this.#renderer;
    if (!renderer || renderer.getContext().isContextLost()) return;
    const previous = this.#live;
    if (previous !== figure) {
      if (previous) previous.keep(renderer);
      figure.take(renderer);
      this.#live = figure;
    }
    figure.draw(renderer, scale);
  }

  /** Whether all that is seen is drawn, as finely as it can be: tests wait for it. */
  get atRest(): boolean {
    return this.#frame === 0 && this.#steps.size === 0 && this.#coarse.size === 0;
  }

  /** Where a point [mm] is seen in the figure of an element, in its pixels: for tests. */
  where(element: Element, point: readonly [number, number, number]): { x: number; y: number } | null {
    return this.#byElement.get(element)?.project(point) ?? null;
  }

  /** What the drawings hold of the graphics memory: tests look whether it grows. */
  get memory(): { geometries: number; textures: number } {
    const { geometries, textures } = this.#renderer?.info.memory ?? { geometries: 0, textures: 0 };
    return { geometries, textures };
  }
}

/** Whether no graphics card draws: then finer pictures would only take time from other programs. */
function byProcessor(renderer: WebGLRenderer): boolean {
  const context = renderer.getContext(), extension = context.getExtension("WEBGL_debug_renderer_info");
  return extension !== null && /swiftshader|llvmpipe|software|basic render/i.test(String(context.getParameter(extension.UNMASKED_RENDERER_WEBGL)));
}
