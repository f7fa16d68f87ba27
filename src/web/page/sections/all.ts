/** The sections in their order. */
import type { Section } from "../section";
import { drop } from "./drop";

export const sections: readonly { number: number; section: Section }[] = [
  { number: 7, section: drop },
];
