// The picture with its player: what is shown is the last good motion, with the pose where it was.

import { player } from "../../crates/assur-picture/src/animation/player.js";
import type { Declared, Moving } from "./asked";
import { find, make } from "./dom";

export interface Hooks {
  moved(part: number, playing: boolean): void;
  /** A part of the picture was clicked: the line of its statement. */
  line(line: number): void;
  /** Arrows that the motion does not have. */
  show(kind: string): void;
}

export class Picture {
  private readonly root = find("picture");
  private played: ReturnType<typeof player> | undefined;
  private declared: Declared[] = [];
  private arrows = "";

  constructor(private readonly hooks: Hooks) {}

  get shown(): string {
    return this.played?.shown ?? this.arrows;
  }

  /** A motion in place of the one before; it goes on where that was. */
  take(moving: Moving, part: number): void {
    const playing = this.played?.playing ?? false;
    const arrows = moving.motion?.shown ?? this.shown;
    this.end();
    this.declared = moving.declared;
    this.root.innerHTML = moving.markup;
    this.room();
    if (moving.motion === null) return;
    const motion = { ...moving.motion, shown: moving.motion.arrows.some((one) => one.kind === arrows) ? arrows : null };
    const { moved, show } = this.hooks;
    this.played = player(this.root, motion, { moved, show, clicked: (name, kind) => this.clicked(name, kind) }, this.root);
    this.played.at(part);
    if (playing) this.played.play(true);
  }

  /** Picture and plot side by side are of one height, and values that once needed a line keep it: nothing jumps while it moves. */
  private room(): void {
    const parts = this.root.querySelector<HTMLElement>(".motion-parts"), values = this.root.querySelector<HTMLElement>(".motion-values");
    const shapes = [...this.root.querySelectorAll("svg")].map(({ viewBox: { baseVal } }) => `minmax(0,${(baseVal.width / baseVal.height).toFixed(3)}fr)`);
    parts?.style.setProperty("--columns", shapes.join(" "));
    let width = 0;
    const sized = new ResizeObserver(([{ contentRect: now }]) => {
      if (!values?.isConnected) return sized.disconnect();
      values.style.minHeight = now.width === width ? `${now.height}px` : "";
      width = now.width;
    });
    if (values) sized.observe(values);
  }

  /** One position, before its motion is there: the picture in place of the one that moves. */
  still(svg: string): void {
    const now = this.root.querySelector("svg");
    if (now === null || this.played?.playing) return;
    const next = new DOMParser().parseFromString(svg, "image/svg+xml").documentElement;
    if (next.tagName === "svg") now.replaceWith(document.importNode(next, true));
  }

  /** Other pictures where there is no motion; a sentence where there is none. */
  others(svg: string[], says: string): void {
    this.end();
    this.root.replaceChildren(...(svg.length > 0 ? [] : [make("p", { class: "soft" }, says)]));
    for (const one of svg) this.root.insertAdjacentHTML("beforeend", one);
  }

  /** Shows a sentence below the picture. */
  says(text: string): void {
    this.root.querySelector(".motion-scale")?.replaceChildren(text);
    const choice = this.root.querySelector<HTMLSelectElement>(".motion-show");
    if (choice) choice.value = this.played ? (this.arrows = "") : "";
  }

  mark(what: { class: string; name: string } | null): void {
    this.played?.mark(what);
  }

  private clicked(name: string, kind: string): void {
    const all = this.declared.filter((one) => one.name === name);
    const one = all.find((found) => found.class === kind) ?? all[0];
    if (one) this.hooks.line(one.line);
  }

  private end(): void {
    this.played?.end();
    this.played = undefined;
  }
}
