// What the page knows: one object, one way to change it, those who look at it.

import type { Diagnostic } from "vscode-languageserver-protocol";
import type { Language } from "./words";

export type Tab = "text" | "answers" | "worked" | "pictures" | "problems" | "tutorial";

export interface State {
  language: Language;
  tab: Tab;
  /** Counts the answers that were shown; 0 where there are none yet. */
  shown: number;
  /** The newest text has no answers: what is shown is the last good one. */
  old: boolean;
  busy: boolean;
  /** The text took too long. */
  late: boolean;
  /** The module cannot be loaded, in words. */
  failed: string;
  part: number;
  problems: Diagnostic[];
}

type Look = (state: State, before: State) => void;

export class Store {
  private looks: Look[] = [];

  constructor(private state: State) {}

  get now(): Readonly<State> {
    return this.state;
  }

  set(patch: Partial<State>): void {
    const before = this.state;
    this.state = { ...before, ...patch };
    for (const look of this.looks) look(this.state, before);
  }

  look(look: Look): void {
    this.looks.push(look);
    look(this.state, this.state);
  }
}

/** Kept between visits, where the browser keeps anything. */
export const kept = {
  get(key: string): string | null {
    try {
      return localStorage.getItem(`assur-${key}`);
    } catch {
      return null;
    }
  },
  set(key: string, value: string): void {
    try {
      localStorage.setItem(`assur-${key}`, value);
    } catch {
      // a page without storage works and says nothing
    }
  },
};
