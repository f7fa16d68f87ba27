/** Elements, in short. */

type Properties = Record<string, string | number | boolean | undefined>;

/** <tag class="classes" …properties>children</tag>. */
export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K, classes = "", properties: Properties = {}, ...children: (Node | string)[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  if (classes) element.className = classes;
  for (const [name, value] of Object.entries(properties)) {
    if (value === true) element.setAttribute(name, "");
    else if (value !== undefined && value !== false) element.setAttribute(name, String(value));
  }
  element.append(...children);
  return element;
}

/** From trusted markup: what the page's own sources say. */
export function html<T extends HTMLElement = HTMLElement>(markup: string): T {
  const template = document.createElement("template");
  template.innerHTML = markup.trim();
  return template.content.firstElementChild as T;
}

let serial = 0;
/** An id that no other element has. */
export const fresh = (stem: string) => `${stem}-${++serial}`;

/** Icons, on a square of 24. */
const paths = {
  play: "M8 5v14l11-7z",
  back: "M16 5v14L5 12z",
  pause: "M7 5h4v14H7zM13 5h4v14h-4z",
  next: "M6 5v14l9-7zM16 5h3v14h-3z",
  previous: "M18 5v14l-9-7zM5 5h3v14H5z",
  restart: "M12 5V1L7 6l5 5V7a5 5 0 1 1-5 5H5a7 7 0 1 0 7-7z",
  link: "M10.6 13.4a1 1 0 0 0 1.4 0l3.5-3.5a2.5 2.5 0 0 0-3.5-3.5l-1.8 1.7-1.4-1.4 1.8-1.7a4.5 4.5 0 0 1 6.3 6.3l-3.5 3.5a3 3 0 0 1-4.2 0zM13.4 10.6a1 1 0 0 0-1.4 0l-3.5 3.5a2.5 2.5 0 0 0 3.5 3.5l1.8-1.7 1.4 1.4-1.8 1.7a4.5 4.5 0 0 1-6.3-6.3l3.5-3.5a3 3 0 0 1 4.2 0z",
} as const;
export type Icon = keyof typeof paths;

export const icon = (name: Icon): string =>
  `<svg viewBox="0 0 24 24" width="20" height="20" aria-hidden="true"><path fill="currentColor" d="${paths[name]}"/></svg>`;
