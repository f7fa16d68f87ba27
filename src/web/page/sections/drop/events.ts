/** Every event of a drop as a table; its times lead there. */
import { C } from "../../core";
import { el } from "../../dom";
import { fixed } from "../../numbers";
import { tiltOf, type Run } from "./run";
import { impulseOf, say } from "./words";

const most = 400; // rows

export function eventTable(host: HTMLElement, run: () => Run | null, seek: (time: number) => void): { fill(): void } {
  const body = el("tbody"), note = el("p", "remark");
  host.append(el("div", "scroll", { tabindex: 0, role: "region", "aria-label": "events" }, el("table", "", {}, el("thead", "", {}, el("tr", "", {},
    ...["time [s]", "event", "height [mm]", "tilt [°]", "impulse [mN s]", "energy [µJ]"].map((title, i) => el("th", i === 1 ? "" : "r", { scope: "col" }, title)))),
    body)), note);
  const fill = () => {
    const now = run();
    if (!now) return;
    const impacts = now.events.filter((event) => event[C.EVENT_KIND] === C.KIND_IMPACT).length;
    let nth = 0;
    body.replaceChildren(...now.events.slice(0, most).map((event) => {
      const { great } = say(event, event[C.EVENT_KIND] === C.KIND_IMPACT ? ++nth : nth, impacts);
      const time = event[C.EVENT_TIME]!, after = event.subarray(C.EVENT_AFTER), impulse = impulseOf(event);
      const go = el("button", "", { type: "button" }, fixed(time, 6));
      go.addEventListener("click", () => seek(time));
      return el("tr", "", {}, el("td", "r", {}, go), el("td", "", {}, great), el("td", "r", {}, fixed(1e3 * after[C.POSITION + 2]!, 4)),
        el("td", "r", {}, fixed(tiltOf(after), 2)), el("td", "r", {}, impulse > 0 ? fixed(1e3 * impulse, 4) : ""),
        el("td", "r", {}, fixed(1e6 * (event[C.EVENT_ENERGY]! - now.lying), 2)));
    }));
    note.textContent = now.events.length > most ? `The first ${most} of ${now.events.length}.` : "";
  };
  fill();
  return { fill };
}
