/** What happened, in words and colours. */
import { C, vec, type Numbers } from "../../core";
import type { Token } from "../../look";
import { fixed } from "../../numbers";

const parts: Record<number, string> = { [C.UPPER_CAP]: "its upper cap", [C.LOWER_CAP]: "its lower cap", [C.RIM]: "its rim" };
const others: Record<number, string> = { [C.ON_SURFACE]: "the board", [C.ON_SIDE]: "the board’s side", [C.ON_TOP_EDGE]: "the board’s edge",
  [C.ON_VERTICAL_EDGE]: "the board’s vertical edge", [C.ON_CORNER]: "the board’s corner" };

export interface Said {
  great: string;
  small: string;
  token: Token;
  high: boolean;
}

/** `impacts` of all, of which this may be number `nth`. */
export function say(event: Numbers, nth: number, impacts: number): Said {
  const time = `at ${fixed(event[C.EVENT_TIME]!, 4)} s`;
  const plain = (great: string, token: Token = "soft", high = false): Said => ({ great, small: time, token, high });
  switch (event[C.EVENT_KIND]) {
    case C.KIND_START: return plain("let go");
    case C.KIND_IMPACT: {
      const where = others[event[C.EVENT_OTHER_PART]!];
      return { great: `impact ${nth} of ${impacts}`, token: "impact", high: true,
        small: `impulse ${fixed(1e3 * impulseOf(event), 2)} mN s${where && where !== "the board" ? `, on ${where}` : ""}` };
    }
    case C.KIND_BOUNCES_CLOSE: return plain("the bounces have ended", "impact");
    case C.KIND_CONTACT: return plain("from here it stays in touch");
    case C.KIND_STICK: return plain("slip ends: it rolls", "stick");
    case C.KIND_SLIP: return plain("it begins to slip", "slip");
    case C.KIND_FEATURE: return plain(`onto ${parts[event[C.EVENT_PART]!] ?? "another part"}`);
    case C.KIND_JAM: return plain("friction jams it: an impact from within", "impact");
    case C.KIND_LIFT_OFF: return plain("it lifts off");
    case C.KIND_BOARD_EDGE: return plain("at the board’s edge");
    case C.KIND_SIDE: return plain("along the board’s side");
    case C.KIND_REST: return plain("at rest", "rest", true);
    default: return plain("–");
  }
}

/** [N s]. */
export const impulseOf = (event: Numbers): number => Math.hypot(...vec(event, C.EVENT_IMPULSE));

/** How a drop ended. */
export function ending(status: number): string {
  switch (status) {
    case C.REST: return "at rest after";
    case C.REST_LEANING: return "at rest, leaning, after";
    case C.MOVING: return "still moving after";
    case C.FLIES_ON: return "flies on, after";
    default: return "given up after";
  }
}
