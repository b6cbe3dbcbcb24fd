// The author's texts that others took the place of: the newest first, kept between visits where the browser keeps anything.

import { kept } from "./state";

/** How many are kept, and the longest text that is kept. */
const MOST = 10;
export const KEPT = 200_000;

let own: string[] = [];

/** All of them, those of other windows too. */
export function texts(): string[] {
  let stored: unknown = null;
  try {
    stored = JSON.parse(kept.get("texts") ?? "[]");
  } catch {
    // not ours: as if there were none
  }
  const others = Array.isArray(stored) ? stored.filter((one): one is string => typeof one === "string") : [];
  return [...new Set([...own, ...others])].slice(0, MOST);
}

/** Sets a text aside before another takes its place; one in the editor is no longer aside. */
export function aside(text: string, again = ""): void {
  const all = texts().filter((one) => one !== text && one !== again);
  own = (text.trim() === "" ? all : [text, ...all]).slice(0, MOST);
  kept.set("texts", JSON.stringify(own.filter((one) => one.length < KEPT)));
}
