/** The sections in their order. */
import type { Section } from "../section";
import { drop } from "./drop";
import { dynamics } from "./dynamics";

export const sections: readonly { number: number; section: Section }[] = [
  { number: 4, section: dynamics },
  { number: 7, section: drop },
];
