/** The sections in their order. */
import type { Section } from "../section";
import { board } from "./board";
import { drop } from "./drop";
import { dynamics } from "./dynamics";
import { impact } from "./impact";
import { inertia } from "./inertia";
import { shape } from "./shape";
import { support } from "./support";
import { tessellation } from "./tessellation";

export const sections: readonly { number: number; section: Section }[] = [
  { number: 1, section: shape },
  { number: 2, section: tessellation },
  { number: 3, section: inertia },
  { number: 4, section: dynamics },
  { number: 5, section: support },
  { number: 6, section: impact },
  { number: 7, section: drop },
  { number: 8, section: board },
];
