// The gallery: 24 examples with pictures by chapter, and a search over all.

import { find, make } from "./dom";
import { listed } from "./parts";
import type { Store } from "./state";
import { word } from "./words";

export interface Example {
  name: string;
  title: string;
  chapter: string | null;
  picture: string | null;
  text: string;
}

let loaded: Promise<Example[]> | undefined;

/** All examples, once they are asked for. */
export function examples(): Promise<Example[]> {
  loaded ??= listed() as Promise<Example[]>;
  loaded.catch(() => (loaded = undefined));
  return loaded;
}

export class Gallery {
  private readonly dialog = find<HTMLDialogElement>("gallery");

  constructor(
    private readonly store: Store,
    private readonly texts: () => string[],
    private readonly chosen: (text: string, hash?: string) => void,
  ) {}

  async open(): Promise<void> {
    const { language } = this.store.now;
    const search = make("input", { type: "search", placeholder: word(language, "search"), "aria-label": word(language, "search") });
    const said = make("p", { class: "soft", role: "status" }), list = make("div", {});
    const close = make("button", { class: "plain", onclick: () => this.dialog.close() }, word(language, "close"));
    this.dialog.replaceChildren(make("div", { class: "bar" }, search, close), said, list);
    this.dialog.showModal();
    try {
      const own = this.texts().map((text) => ({ name: "", title: /"(.+)"/.exec(text)?.[1] ?? text.trim().slice(0, 60), chapter: word(language, "texts"), picture: null, text }));
      const all = [...own, ...(await examples())];
      const show = () => {
        const wanted = search.value.trim().toLowerCase();
        const found = wanted === "" ? [] : all.filter((one) => `${one.name} ${one.title} ${one.text}`.toLowerCase().includes(wanted));
        said.textContent = wanted === "" ? "" : word(language, "found", found.length);
        list.replaceChildren(...(wanted === "" ? this.chapters(all) : [make("ul", { class: "found" }, ...found.map((one) => make("li", {}, this.button(one))))]));
      };
      search.addEventListener("input", show);
      show();
    } catch (error) {
      said.textContent = word(language, "failed", String(error));
    }
  }

  private chapters(all: Example[]): Node[] {
    const names = [...new Set(all.flatMap((one) => one.chapter ?? []))];
    return names.map((chapter) =>
      make("section", {}, make("h3", {}, chapter), make("div", { class: "cards" }, ...all.filter((one) => one.chapter === chapter).map((one) => this.button(one)))),
    );
  }

  private button(example: Example): HTMLElement {
    const { name, title, text } = example, words = [make("b", {}, title), make("small", { class: "soft" }, name || text.trim().split("\n").at(-1)!.slice(0, 60))];
    const picture = example.picture ? [make("img", { src: example.picture, alt: "", loading: "lazy" })] : [];
    return make("button", { class: "card", onclick: () => (this.dialog.close(), this.chosen(text, name === "" ? undefined : `#x/${name}`)) }, ...picture, ...words);
  }
}
