/** What is behind the # of the address: one section and those of its controls that are not as they were at first, so that
 * a link shows the same again: `#drop?height=30&tilt=25`. Each value is checked by its control, and refused is left out. */
import type { Control } from "./controls";

/** The section and the values that an address names. */
export function parse(hash: string): { section: string; values: Map<string, string> } | null {
  const match = /^#([a-z]+)(?:\?(.*))?$/.exec(hash);
  if (!match) return null;
  return { section: match[1]!, values: new Map(new URLSearchParams(match[2] ?? "")) };
}

/** Gives controls the values of an address that they accept; all others are as at first. */
export function apply(controls: readonly Control[], values: ReadonlyMap<string, string>): void {
  for (const control of controls) {
    const text = values.get(control.key);
    if (text === undefined || !control.accept(text)) control.reset();
  }
}

export function format(section: string, controls: readonly Control[]): string {
  const parts = controls.filter((control) => !control.isDefault).map((control) => `${control.key}=${encodeURIComponent(control.text)}`);
  return parts.length > 0 ? `#${section}?${parts.join("&")}` : `#${section}`;
}

let pending = 0;
/** Puts it into the address, without a new entry in the history; browsers allow that only so often. */
export function write(section: string, controls: readonly Control[]): void {
  clearTimeout(pending);
  pending = window.setTimeout(() => history.replaceState(null, "", format(section, controls)), 250);
}
