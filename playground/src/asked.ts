// The messages of the server that the page asks by: src/lsp/documents.rs of the program answers them.

import type { LSPClient } from "@codemirror/lsp-client";
import type { Range } from "vscode-languageserver-protocol";
import type { Motion } from "../../crates/assur-picture/src/animation/player.js";
import { URI } from "./editor";
import type { Language } from "./words";

export interface Declared {
  name: string;
  class: string;
  line: number;
  range: Range;
}

export interface Moving {
  version: number;
  title: string;
  markup: string;
  motion: Motion | null;
  declared: Declared[];
}

export type Align = "left" | "right" | "decimal";
export interface Table {
  columns: { header: string; align: Align }[];
  rows: string[][];
  keys: number;
}
export type Block = { text: string } | { list: string[] } | { facts: [string, string][] } | { table: Table };
export interface Report {
  version: number;
  title: string;
  notes: string[];
  sections: { heading: string; blocks: Block[] }[];
}

export interface Step {
  title: string;
  text: string;
  example: string;
  done: boolean;
}
export interface Tutorial {
  title: string;
  steps: Step[];
  at: number;
}

export interface Written {
  name: string;
  type: string;
  text: string;
}

export type File = "solution.json" | "poses.csv" | "worked.html" | "sheet.html" | "key.html" | "motion.html" | "motion.svg";

/** The questions about the text that is open. */
export class Asked {
  constructor(
    private readonly client: LSPClient,
    private readonly language: () => Language,
  ) {}

  private ask<T>(method: string, more: object = {}): Promise<T> {
    this.client.sync();
    return this.client.request<object, T>(`assur/${method}`, { uri: URI, language: this.language(), ...more });
  }

  motion(show: string): Promise<Moving> {
    return this.ask("motion", { show: show || "none" });
  }

  picture(part: number): Promise<{ version: number; svg: string }> {
    return this.ask("picture", { part });
  }

  report(): Promise<Report> {
    return this.ask("report");
  }

  async kinds(): Promise<string[]> {
    return (await this.ask<{ kinds: string[] }>("kinds")).kinds;
  }

  async draw(kind: string, part: number, theme: "auto" | "light"): Promise<string[]> {
    return (await this.ask<{ svg: string[] }>("draw", { kind, part, theme })).svg;
  }

  write(what: File, part?: number): Promise<Written> {
    return this.ask("write", { what, part });
  }

  tutorial(): Promise<Tutorial> {
    return this.ask("tutorial");
  }

  pose(part: number): void {
    this.client.notification("assur/pose", { uri: URI, part });
  }
}

/** What an answer that is an error says. */
export function reason(error: unknown): string {
  if (typeof error === "object" && error !== null && "message" in error) return String(error.message);
  return String(error);
}
