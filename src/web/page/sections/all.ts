/** The sections in their order. */
import type { Section } from "../section";
import { drop } from "./drop";
import { shape } from "./shape";

export const sections: readonly { number: number; section: Section }[] = [
  { number: 1, section: shape },
  { number: 7, section: drop },
];
