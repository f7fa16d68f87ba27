/** The sections in their order. */
import type { Section } from "../section";
import { drop } from "./drop";
import { support } from "./support";

export const sections: readonly { number: number; section: Section }[] = [
  { number: 5, section: support },
  { number: 7, section: drop },
];
