/** The page. */
import { Goishi } from "./core";
import { el } from "./dom";
import { parse } from "./address";
import { Mounted } from "./section";
import { sections } from "./sections/all";
import { Stage } from "./stage";

/** Starts it with the library's WebAssembly. */
export async function start(wasm: Uint8Array): Promise<void> {
  const goishi = await Goishi.start(wasm);
  const stage = new Stage();
  document.querySelector("#version")!.textContent = goishi.version;
  const main = document.querySelector("main")!, contents = document.querySelector(".contents")!;
  main.replaceChildren();
  const mounted = new Map<string, Mounted>();
  sections.forEach(({ number, section }) => {
    const one = new Mounted(section, number, goishi, stage);
    mounted.set(section.id, one);
    main.append(one.element);
    contents.append(el("a", "", { href: `#${section.id}` }, `${number} ${section.title}`));
  });
  const follow = (jump: boolean) => {
    const one = mounted.get(parse(location.hash)?.section ?? "");
    if (!one) return;
    one.start();
    one.follow(location.hash);
    if (jump) one.element.scrollIntoView();
  };
  window.addEventListener("hashchange", () => follow(true));
  follow(true);
  document.documentElement.dataset["ready"] = performance.now().toFixed(1); // since the page was asked for [ms]
  Object.assign(globalThis, { goishiStage: stage }); // tests ask for its memory and rest
}
