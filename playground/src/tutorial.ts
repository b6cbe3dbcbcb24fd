// The tutorial: its steps, and which of them the text has, are said by the program.

import { reason, type Asked, type Tutorial } from "./asked";
import { find, make } from "./dom";
import type { Store } from "./state";
import { word } from "./words";

export class Lesson {
  private readonly pane = find("pane-tutorial");
  private last: Tutorial | undefined;

  constructor(
    private readonly store: Store,
    private readonly asked: Asked,
    private readonly host: { append(lines: string): void; leave(): void },
  ) {
    store.look((now, before) => {
      if (now.tab === "tutorial" && (now.tab !== before.tab || now.language !== before.language)) void this.ask();
    });
  }

  /** The text has changed, or is solved. */
  changed(): void {
    if (this.store.now.tab === "tutorial") void this.ask();
  }

  private async ask(): Promise<void> {
    try {
      this.show(await this.asked.tutorial());
    } catch (error) {
      if (!this.last) this.pane.replaceChildren(make("p", { class: "soft" }, reason(error)));
    }
  }

  private show(tutorial: Tutorial): void {
    if (JSON.stringify(tutorial) === JSON.stringify(this.last) && this.pane.childElementCount > 0) return;
    this.last = tutorial;
    const { language } = this.store.now, { steps, at, title } = tutorial;
    const items = steps.map((step, i) => {
      const current = i === at;
      const item = make("li", { class: step.done ? "done" : current ? "now" : "" }, make("h3", {}, step.title));
      if (step.done) item.append(make("span", { class: "soft" }, word(language, "done")));
      if (current) {
        item.setAttribute("aria-current", "step");
        const write = make("button", { class: "fix", onclick: () => this.host.append(step.example) }, word(language, "write"));
        item.append(make("p", {}, step.text), make("pre", {}, step.example), write);
      }
      return item;
    });
    const end = at === steps.length ? [make("p", {}, word(language, "finished"))] : [];
    const leave = make("button", { class: "plain", onclick: () => this.host.leave() }, word(language, "leave"));
    this.pane.replaceChildren(make("h2", {}, title), make("ol", { class: "steps" }, ...items), ...end, leave);
  }
}
