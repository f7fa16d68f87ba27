/** The talk's program, put together of the library's copies of its parts: 60 times a second a step of its scheme, then, if the
 * stone is inside the board, push it out along the contact normal and give it the impulse of the talk's law. */
import { C, Refused, vec, type Goishi, type Numbers } from "../../core";
import type { Run } from "./run";

export const frame = 1 / 60; // [s]

export interface Loop {
  /** One for each frame, from the start on. */
  motions: Numbers[];
}

/** As long as the drop that it is compared with. */
export function publishedLoop(goishi: Goishi, run: Run): Loop {
  const gravity = vec(run.settings, C.GRAVITY), { restitution, friction } = run.start;
  const frames = Math.ceil(run.end / frame);
  const motions: Numbers[] = [];
  let state = run.state.slice();
  for (let i = 0; i <= frames; ++i) {
    const { rows, count } = goishi.flight(run.stone, state, gravity, C.BOTH, C.PUBLISHED, frame, 1, 2);
    if (count < 2) break; // it has diverged
    motions.push(rows.slice(C.STEPPED, C.STEPPED + C.MOTION_SIZE));
    state = rows.slice(C.FLIGHT_SIZE + C.STEPPED, C.FLIGHT_SIZE + C.STEPPED + C.STATE_SIZE);
    const touch = goishi.separation(run.stone, state.subarray(0, C.POSE_SIZE), run.board);
    if (touch[C.GAP]! >= 0) continue;
    for (let k = 0; k < 3; ++k) state[C.POSITION + k]! -= touch[C.GAP]! * touch[C.NORMAL + k]!;
    try {
      const impact = goishi.impact(run.stone, state, C.PUBLISHED_LAW, restitution, friction,
        vec(touch, C.OTHER_POINT), vec(touch, C.NORMAL));
      state.set(impact.subarray(C.NEW_VELOCITY, C.NEW_VELOCITY + 3), C.VELOCITY);
      state.set(impact.subarray(C.NEW_MOMENTUM, C.NEW_MOMENTUM + 3), C.MOMENTUM);
    } catch (error) {
      if (!(error instanceof Refused)) throw error;
      break;
    }
  }
  return { motions };
}
