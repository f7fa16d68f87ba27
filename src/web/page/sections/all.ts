/** The sections in their order. */
import type { Section } from "../section";
import { drop } from "./drop";
import { impact } from "./impact";
import { support } from "./support";

export const sections: readonly { number: number; section: Section }[] = [
  { number: 5, section: support },
  { number: 6, section: impact },
  { number: 7, section: drop },
];
