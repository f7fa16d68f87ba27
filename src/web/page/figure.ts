/** A place that is drawn: its scene, its camera and what a hand can do with it. */
import { PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, type WebGLRenderer } from "three";
import { el } from "./dom";

/** A view of a point [mm]: turned about the vertical and raised over the horizon [rad], from a distance [mm]. */
export interface View {
  target: readonly [number, number, number];
  azimuth: number;
  elevation: number;
  distance: number;
}

/** What follows a hand that holds something: the ray of the pointer in mm, and the movement in pixels since it began. */
export interface Grip {
  move(ray: Raycaster["ray"], dx: number, dy: number): void;
  end(): void;
}

export interface FigureOptions {
  /** What is seen, for those who do not see it. */
  label: string;
  view: View;
  /** The view may be raised from … to [rad]. */
  elevations?: readonly [number, number];
  /** What stands still is drawn once per view. */
  still?: Scene;
  /** Something to hold where the ray meets it; null: the view turns. */
  grip?: (caster: Raycaster) => Grip | null;
  /** Pressed and let go without a movement. */
  click?: (caster: Raycaster) => void;
  /** Called before each picture. */
  before?: () => void;
}

const fov = 26;

export class Figure {
  readonly element: HTMLElement;
  /** For captions over the picture. */
  readonly overlay: HTMLElement;
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(fov, 1, 1, 4000);
  readonly view: View;
  readonly invalidate: () => void;
  visible = false;

  readonly #options: FigureOptions;
  readonly #first: View;
  readonly #below = document.createElement("canvas");
  readonly #copy = document.createElement("canvas");
  readonly #pins = new Map<HTMLElement, readonly [number, number, number]>();
  #width = 0;
  #height = 0;
  #drawn = "";   // the view of the last picture
  #under = "";   // and of what stands still below it

  constructor(host: HTMLElement, options: FigureOptions, invalidate: () => void, drawable: boolean) {
    this.#options = options;
    this.invalidate = invalidate;
    this.view = { ...options.view };
    this.#first = { ...options.view };
    this.camera.up.set(0, 0, 1);
    this.element = el("div", "picture", { tabindex: 0, role: "img", "aria-label": options.label });
    this.overlay = el("div", "overlay");
    for (const canvas of [this.#below, this.#copy]) canvas.setAttribute("aria-hidden", "true");
    this.element.append(this.#below, this.#copy);
    if (!drawable) this.element.append(el("p", "no-gl", {}, "This browser offers no WebGL, so nothing is drawn here; the numbers and graphs are right."));
    host.append(el("div", "frame", {}, this.element, this.overlay));
    this.#listen();
  }

  /** Says what is seen now. Only when things have come to a stop: a screen reader would read each. */
  set label(text: string) {
    this.element.setAttribute("aria-label", text);
  }

  /** The view that Home goes back to; from as near as it shows these points [mm], too. */
  frame(view: Partial<View>, points: readonly (readonly [number, number, number])[] = []): void {
    Object.assign(this.view, view);
    const inside = () => {
      this.#place();
      return points.every((point) => {
        const seen = new Vector3(...point).project(this.camera);
        return Math.abs(seen.x) < 0.85 && Math.abs(seen.y) < 0.8;
      });
    };
    for (let i = 0; i < 60 && !inside(); ++i) this.view.distance *= 1.06;
    Object.assign(this.#first, this.view);
    this.invalidate();
  }

  /** Keeps an element of the overlay where a point [mm] is seen; null hides it. */
  pin(element: HTMLElement, point: readonly [number, number, number] | null): void {
    element.hidden = point === null;
    if (point) this.#pins.set(element, point);
    else this.#pins.delete(element);
    this.invalidate();
  }

  get aspect(): number {
    return this.#height > 0 ? this.#width / this.#height : 16 / 9;
  }

  resize(width: number, height: number): boolean {
    if (width === this.#width && height === this.#height) return false;
    [this.#width, this.#height] = [width, height];
    return width > 0 && height > 0;
  }

  /** The theme or the context is another one: nothing of what was drawn can stay. */
  forget(): void {
    this.#under = "";
  }

  /** The canvas of the context comes here … */
  take(renderer: WebGLRenderer): void {
    this.element.append(renderer.domElement);
    this.#copy.hidden = true;
  }

  /** … and leaves a copy of its picture. */
  keep(renderer: WebGLRenderer): void {
    this.draw(renderer, 2);
    copy(renderer.domElement, this.#copy);
    this.#copy.hidden = false;
  }

  draw(renderer: WebGLRenderer, scale: number): void {
    if (this.#width === 0 || this.#height === 0) return;
    this.#options.before?.();
    this.#place();
    for (const [element, point] of this.#pins) {
      const { x, y } = this.#seen(point);
      element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    }
    const size = renderer.getSize(new Vector2());
    const width = Math.round(this.#width * scale), height = Math.round(this.#height * scale);
    if (size.x !== width || size.y !== height) renderer.setSize(width, height, false);
    const still = this.#options.still;
    const view = [...this.camera.matrixWorld.elements, this.#width, this.#height].join(" ");
    const turning = view !== this.#drawn; // then what stands still is drawn with the rest
    this.#drawn = view;
    this.scene.userData["scale"] = scale;
    renderer.clear();
    if (still && (this.#under !== view || this.#below.width < width)) {
      renderer.render(still, this.camera);
      if (!turning || scale === 2) {
        copy(renderer.domElement, this.#below);
        this.#under = view;
      }
    }
    this.#below.hidden = this.#under !== view;
    renderer.render(this.scene, this.camera);
  }

  #place(): void {
    const { target, azimuth, elevation, distance } = this.view;
    const c = Math.cos(elevation);
    this.camera.position.set(target[0] + distance * c * Math.cos(azimuth), target[1] + distance * c * Math.sin(azimuth),
      target[2] + distance * Math.sin(elevation));
    this.camera.lookAt(...target);
    // A narrow picture sees as much to the sides as one of 5 : 4.
    const narrow = Math.max(1, 1.25 / this.aspect);
    this.camera.fov = 2 * Math.atan(Math.tan(fov * Math.PI / 360) * narrow) * 180 / Math.PI;
    this.camera.aspect = this.aspect;
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
  }

  /** Where a point [mm] is in the picture, in pixels. */
  project(point: readonly [number, number, number]): { x: number; y: number } {
    this.#place();
    return this.#seen(point);
  }

  #seen(point: readonly [number, number, number]): { x: number; y: number } {
    const seen = new Vector3(...point).project(this.camera);
    return { x: (seen.x + 1) / 2 * this.#width, y: (1 - seen.y) / 2 * this.#height };
  }

  #turn(azimuth: number, elevation: number): void {
    const [lowest, highest] = this.#options.elevations ?? [0.05, 1.5];
    this.view.azimuth += azimuth;
    this.view.elevation = Math.min(highest, Math.max(lowest, this.view.elevation + elevation));
    this.invalidate();
  }

  #caster(x: number, y: number): Raycaster {
    const box = this.element.getBoundingClientRect();
    const caster = new Raycaster();
    caster.setFromCamera(new Vector2(2 * (x - box.left) / box.width - 1, 1 - 2 * (y - box.top) / box.height), this.camera);
    return caster;
  }

  #listen(): void {
    const { element } = this;
    let grip: Grip | null = null, startX = 0, startY = 0, lastX = 0, lastY = 0, held = -1, still = true;
    element.addEventListener("pointerdown", (event) => {
      if (event.button !== 0 || held !== -1) return;
      held = event.pointerId;
      element.setPointerCapture(held);
      [startX, startY] = [lastX, lastY] = [event.clientX, event.clientY];
      still = true;
      grip = this.#options.grip?.(this.#caster(startX, startY)) ?? null;
      element.classList.toggle("held", grip !== null);
    });
    element.addEventListener("pointermove", (event) => {
      if (event.pointerId !== held) return;
      const [x, y] = [event.clientX, event.clientY];
      still &&= Math.hypot(x - startX, y - startY) < 4;
      if (this.#options.click && still) return; // it may become a click
      if (grip) grip.move(this.#caster(x, y).ray, x - startX, y - startY);
      else this.#turn(-(x - lastX) * 0.008, (y - lastY) * 0.006);
      [lastX, lastY] = [x, y];
    });
    const end = (event: PointerEvent) => {
      if (event.pointerId !== held) return;
      held = -1;
      grip?.end();
      grip = null;
      if (still && event.type === "pointerup") this.#options.click?.(this.#caster(event.clientX, event.clientY));
      element.classList.remove("held");
    };
    element.addEventListener("pointerup", end);
    element.addEventListener("pointercancel", end);
    // A finger on what can be held does not scroll the page; decided here, for in pointerdown it is too late.
    element.addEventListener("touchstart", (event) => {
      const touch = event.touches[0];
      if (!touch || !this.#options.grip) return;
      const seized = this.#options.grip(this.#caster(touch.clientX, touch.clientY));
      if (seized) event.preventDefault();
    }, { passive: false });
    element.addEventListener("keydown", (event) => {
      const step = 0.12;
      if (event.altKey || event.ctrlKey || event.metaKey) return;
      switch (event.key) {
        case "ArrowLeft": this.#turn(step, 0); break;
        case "ArrowRight": this.#turn(-step, 0); break;
        case "ArrowUp": this.#turn(0, step); break;
        case "ArrowDown": this.#turn(0, -step); break;
        case "Home": Object.assign(this.view, this.#first); this.invalidate(); break;
        default: return;
      }
      event.preventDefault();
    });
  }
}

/** As a picture that is handed over: a canvas that is drawn in costs its copy in each frame. */
function copy(from: HTMLCanvasElement, to: HTMLCanvasElement): void {
  [to.width, to.height] = [from.width, from.height];
  const picture = new OffscreenCanvas(from.width, from.height);
  picture.getContext("2d")!.drawImage(from, 0, 0);
  to.getContext("bitmaprenderer")!.transferFromImageBitmap(picture.transferToImageBitmap());
}
