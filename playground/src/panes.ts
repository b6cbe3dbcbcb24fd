// What stands beside the text, as tabs: answers, worked solution, pictures, problems. Each is asked for when it is seen.

import { reason, type Asked, type Block, type Report, type Table } from "./asked";
import { find, make } from "./dom";
import type { Fix } from "./lsp";
import type { State, Store, Tab } from "./state";
import { word, type Language } from "./words";

export interface Fixes {
  of(problem: State["problems"][number]): Promise<Fix[]>;
  apply(fix: Fix): void;
  go(line: number, column: number): void;
}

/** How many rows of a table are drawn at first, and at once; how many more are drawn when they are wanted. */
const ROWS = 200, MORE = 1000;
const TABS: Tab[] = ["text", "answers", "worked", "pictures", "problems", "tutorial"];

export class Panes {
  private readonly panes = Object.fromEntries(TABS.map((tab) => [tab, find(`pane-${tab}`)])) as Record<Tab, HTMLElement>;
  /** Which answers a pane shows, and in which language. */
  private readonly drawn = new Map<Tab, string>();
  private report: Report | undefined;

  constructor(
    private readonly store: Store,
    private readonly asked: Asked,
    private readonly fixes: Fixes,
  ) {
    const bar = find("tabs");
    for (const tab of TABS) {
      bar.append(make("button", { role: "tab", id: `tab-${tab}`, "aria-controls": `pane-${tab}`, onclick: () => store.set({ tab }) }));
    }
    bar.addEventListener("keydown", (event) => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (step === undefined) return;
      const seen = TABS.filter((tab) => find(`tab-${tab}`).offsetParent !== null);
      const next = seen[(seen.indexOf(store.now.tab) + step + seen.length) % seen.length];
      store.set({ tab: next });
      find(`tab-${next}`).focus();
    });
    store.look((now, before) => this.update(now, before));
  }

  /** New answers. */
  answers(report: Report): void {
    this.report = report;
  }

  /** The part of the way has rested: what shows one position is drawn anew. */
  rested(): void {
    this.drawn.delete("worked");
    this.drawn.delete("pictures");
    this.see();
  }

  private update(now: State, before: State): void {
    if (now.tab !== before.tab || now.language !== before.language || now === before) {
      for (const tab of TABS) {
        const is = tab === now.tab, button = find(`tab-${tab}`);
        this.panes[tab].hidden = !is;
        button.setAttribute("aria-selected", String(is));
        button.tabIndex = is ? 0 : -1;
        button.textContent = word(now.language, tab);
      }
      document.body.dataset.tab = now.tab;
    }
    if (now.problems !== before.problems || now.language !== before.language) void this.problems(now);
    this.see();
  }

  private see(): void {
    const { tab, shown, language, problems } = this.store.now;
    const count = problems.filter((one) => (one.severity ?? 1) <= 3).length;
    find("tab-problems").dataset.count = count > 0 ? String(count) : "";
    const key = `${shown} ${language}`;
    if (shown === 0) {
      for (const empty of ["answers", "worked", "pictures"] as const) this.panes[empty].replaceChildren(make("p", { class: "soft" }, word(language, "nothing")));
      this.drawn.clear();
    }
    if (shown === 0 || this.drawn.get(tab) === key) return;
    this.drawn.set(tab, key);
    if (tab === "answers" && this.report) this.panes.answers.replaceChildren(...sections(this.report, language));
    if (tab === "worked") void this.worked();
    if (tab === "pictures") void this.pictures();
  }

  private async worked(): Promise<void> {
    const pane = this.panes.worked, { language, part } = this.store.now;
    try {
      const { text } = await this.asked.write("worked.html", part > 0 ? part : undefined);
      const frame = make("iframe", { title: word(language, "worked"), sandbox: "allow-same-origin allow-modals", srcdoc: text });
      const print = make("button", { class: "plain", onclick: () => frame.contentWindow?.print() }, word(language, "print"));
      pane.replaceChildren(make("div", { class: "bar" }, print), frame);
    } catch (error) {
      pane.replaceChildren(make("p", { class: "soft" }, reason(error)));
    }
  }

  /** The kinds of pictures, each drawn when it is seen. */
  private async pictures(): Promise<void> {
    const pane = this.panes.pictures;
    try {
      const kinds = await this.asked.kinds();
      const draw = async (figure: Element): Promise<void> => {
        const kind = figure.getAttribute("data-kind") ?? "";
        const svg = await this.asked.draw(kind, this.store.now.part, "auto").catch((error) => [reason(error)]);
        const box = make("div", { class: "drawn" });
        for (const one of svg) one.startsWith("<svg") ? box.insertAdjacentHTML("beforeend", one) : box.append(one);
        figure.append(box);
      };
      const seen = new IntersectionObserver((entries) => {
        for (const { isIntersecting, target } of entries) {
          if (!isIntersecting) continue;
          seen.unobserve(target);
          void draw(target);
        }
      });
      pane.replaceChildren(
        ...kinds.map((kind) => {
          const figure = make("figure", { "data-kind": kind }, make("figcaption", {}, kind));
          seen.observe(figure);
          return figure;
        }),
      );
    } catch (error) {
      pane.replaceChildren(make("p", { class: "soft" }, reason(error)));
    }
  }

  private async problems({ problems, language }: State): Promise<void> {
    const shown = problems.filter((one) => (one.severity ?? 1) <= 3);
    const items = shown.map((one) => {
      const { line, character } = one.range.start;
      const text = typeof one.message === "string" ? one.message : "";
      const go = make("button", { class: "plain", onclick: () => this.fixes.go(line + 1, character) }, word(language, "line", line + 1));
      const item = make("li", { class: ["", "error", "warning", "info"][one.severity ?? 1] }, go, make("p", {}, text));
      void this.fixes.of(one).then((all) => {
        for (const fix of all) item.append(make("button", { class: "fix", onclick: () => this.fixes.apply(fix) }, fix.title));
      }, () => undefined);
      return item;
    });
    this.panes.problems.replaceChildren(items.length > 0 ? make("ol", {}, ...items) : make("p", { class: "soft" }, word(language, "none")));
    const first = items[0]?.cloneNode(true);
    find("first").replaceChildren(...(first ? [first] : []));
    this.wire(items[0]);
  }

  /** On a phone the first problem stands above the keyboard, with its fix. */
  private wire(first: HTMLElement | undefined): void {
    const bar = find("first");
    if (!first) return;
    const copy = () => {
      bar.replaceChildren(...[...first.children].map((child) => {
        const twin = child.cloneNode(true) as HTMLElement;
        twin.addEventListener("click", () => (child as HTMLElement).click());
        return twin;
      }));
    };
    copy();
    new MutationObserver(copy).observe(first, { childList: true });
  }
}

function sections(report: Report, language: Language): Node[] {
  const notes = report.notes.map((note) => make("p", {}, note));
  return [...notes, ...report.sections.flatMap(({ heading, blocks }) => [make("h2", {}, heading), ...blocks.map((one) => block(one, language))])];
}

function block(one: Block, language: Language): Node {
  if ("text" in one) return make("p", {}, one.text);
  if ("list" in one) return make("ul", {}, ...one.list.map((item) => make("li", {}, item)));
  if ("facts" in one) return make("dl", {}, ...one.facts.flatMap(([name, said]) => [make("dt", {}, name), make("dd", {}, said)]));
  return table(one.table, language);
}

/** A table; of a long one the first rows, as a page with all of them answers no key for seconds. */
function table({ columns, rows }: Table, language: Language): Node {
  const head = make("tr", {}, ...columns.map(({ header, align }) => make("th", { scope: "col", class: align }, header)));
  const body = make("tbody", {}), shown = make("span", { class: "soft" }), more = make("button", { class: "plain" });
  const draw = (end: number): void => {
    const from = body.rows.length, next = rows.slice(from, Math.min(from + ROWS, end));
    body.append(...next.map((row) => make("tr", {}, ...row.map((cell, i) => make("td", { class: columns[i]?.align ?? "left" }, ...decimals(cell, columns[i]?.align))))));
    const count = body.rows.length, left = rows.length - count;
    shown.textContent = word(language, "rows", count, rows.length);
    more.textContent = word(language, "more", Math.min(MORE, left));
    more.hidden = left === 0;
    if ((more.disabled = count < Math.min(end, rows.length))) setTimeout(() => body.isConnected && draw(end));
  };
  draw(ROWS);
  more.addEventListener("click", () => draw(body.rows.length + MORE));
  const foot = rows.length > ROWS ? [make("div", { class: "rows" }, shown, more)] : [];
  return make("div", { class: "table" }, make("table", {}, make("thead", {}, head), body), ...foot);
}

/** A number with its decimals apart, so that points stand below each other. */
function decimals(cell: string, align: string | undefined): (Node | string)[] {
  const found = align === "decimal" ? /^(.*?)([.,].*)?$/.exec(cell) : null;
  return found ? [found[1], make("span", { class: "part" }, found[2] ?? "")] : [cell];
}
