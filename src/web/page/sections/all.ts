/** The sections in their order. */
import type { Section } from "../section";
import { drop } from "./drop";
import { dynamics } from "./dynamics";
import { inertia } from "./inertia";
import { shape } from "./shape";
import { tessellation } from "./tessellation";

export const sections: readonly { number: number; section: Section }[] = [
  { number: 1, section: shape },
  { number: 2, section: tessellation },
  { number: 3, section: inertia },
  { number: 4, section: dynamics },
  { number: 7, section: drop },
];
