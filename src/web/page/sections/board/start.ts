/** How the stones begin: from what the controls say, the same stones wherever it is computed. No function is used whose last
 * bit browsers are free to choose. */
import { C, type Goishi, type Numbers } from "../../core";

export type Arrangement = "fall" | "heap" | "laid";

/** In the units of the controls. */
export interface Start {
  arrangement: Arrangement;
  stones: number;
  seed: number;
  height: number;      // [mm] up to which they fall from
  restitution: number; // on the board, and of two stones
  friction: number;
}

/** Starts that show something; what is not said is as at first. */
export const starts: Record<string, { label: string; says: string; start: Partial<Start> }> = {
  many: { label: "half a board", start: {},
    says: "Dropped over as many crossings, each leaning and turning a little: they fall on the board and on each other, and slide into the gaps." },
  full: { label: "a full board", start: { stones: 361 },
    says: "A stone for each of the 361 crossings. The stones are so wide that there is hardly room: some lie on others in the end, or have gone over the edge." },
  heap: { label: "a heap", start: { arrangement: "heap", stones: 45, height: 20 },
    says: "A column of stones falls down: each leans on others, so that all forces must be found at once. A heap has 60 at most." },
  laid: { label: "laid out", start: { arrangement: "laid", stones: 361 },
    says: "All laid down already, at rest: nothing is computed. Push one, or bump the board." },
};

/** Of them a heap has no more: each step of one that is twice as high takes ten times as long. */
export const highest = 60;

const tolerance = 1e-4; // serves a game, says the library

export interface Kinds {
  /** White and black. */
  stones: readonly [Numbers, Numbers];
  measures: readonly [Numbers, Numbers];
}

export function kindsOf(goishi: Goishi): Kinds {
  const stones = [C.WHITE, C.BLACK].map((color) => goishi.catalogueStone(33, color, 1e-3)) as [Numbers, Numbers];
  return { stones, measures: stones.map((stone) => goishi.measures(stone)) as [Numbers, Numbers] };
}

export function settingsOf(goishi: Goishi, { restitution, friction }: Start): Numbers {
  const settings = goishi.sceneSettings();
  settings[C.RESTITUTION] = settings[C.STONES_RESTITUTION] = restitution;
  settings[C.FRICTION] = settings[C.STONES_FRICTION] = friction;
  settings[C.TOLERANCE] = tolerance;
  return settings;
}

/** Where the lines of a board cross   [m]. */
export function crossingsOf(board: Numbers): (readonly [number, number])[] {
  const lines = board[C.BOARD_LINES]!, at = (k: number, spacing: number) => (k - (lines - 1) / 2) * board[spacing]!;
  return Array.from({ length: lines * lines }, (_, i) => [at(i % lines, C.BOARD_SPACING_X), at(Math.floor(i / lines), C.BOARD_SPACING_Y)] as const);
}

export interface Placed {
  color: 0 | 1;
  state: Numbers;
}

export function placedBy(goishi: Goishi, board: Numbers, kinds: Kinds, start: Start): Placed[] {
  const random = randomBy(start.seed);
  const between = (least: number, greatest: number) => least + (greatest - least) * random();
  const crossings = shuffled(crossingsOf(board), random);
  const count = start.arrangement === "heap" ? Math.min(start.stones, highest) : start.stones;
  return Array.from({ length: count }, (_, i) => {
    const color = (i % 2) as 0 | 1, stone = kinds.stones[color], high = kinds.measures[color][C.MEASURE_HEIGHT]!;
    let place: readonly [number, number, number];
    if (start.arrangement === "heap") { // a column of threes by threes
      const layer = Math.floor(i / 9), k = i % 9;
      place = [(k % 3 - 1) * 0.025, (Math.floor(k / 3) - 1) * 0.025, 1e-3 * start.height / 2 + 0.014 + 0.025 * layer];
    } else {
      place = [...crossings[i]!, start.arrangement === "laid" ? high / 2 : 0.014 + 1e-3 * start.height * random()];
    }
    const loose = start.arrangement === "laid" ? 0 : 1; // lying flat, at rest
    const turned = () => loose * between(-0.25, 0.25), pace = () => loose * between(-0.05, 0.05), spin = () => loose * between(-5, 5);
    const pose = [...place, 1, turned(), turned(), turned()];
    return { color, state: goishi.state(stone, pose, [pace(), pace(), 0], [spin(), spin(), spin()]) };
  });
}

/** Numbers from 0 to 1, by whole numbers alone (mulberry32). */
function randomBy(seed: number): () => number {
  let a = seed | 0;
  return () => {
    a = (a + 0x6d2b79f5) | 0;
    let t = Math.imul(a ^ (a >>> 15), 1 | a);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

function shuffled<T>(list: readonly T[], random: () => number): T[] {
  const all = [...list];
  for (let i = all.length - 1; i > 0; --i) {
    const k = Math.floor(random() * (i + 1));
    [all[i], all[k]] = [all[k]!, all[i]!];
  }
  return all;
}
