// Sharing, saving, the list of keys.

import { reason, type Asked, type File } from "./asked";
import { download, find, make } from "./dom";
import { encode } from "./link";
import type { Store } from "./state";
import { KEYS, LANGUAGES, word, type Word } from "./words";

const dialog = find<HTMLDialogElement>("dialog");

function opened(store: Store, title: Word, ...content: Node[]): void {
  const { language } = store.now;
  const close = make("button", { class: "plain", onclick: () => dialog.close() }, word(language, "close"));
  dialog.replaceChildren(make("div", { class: "bar" }, make("h2", {}, word(language, title)), close), ...content);
  dialog.showModal();
}

/** Up to these lengths links fit everywhere, or in most programs. */
const SHORT = 2000, LONG = 8000;

/** The address of the page without its own link; of a page on a disk too. */
export const home = (): string => location.href.replace(/[?#].*$/, "");

export async function share(store: Store, text: string): Promise<void> {
  const { language, part } = store.now;
  const hash = await encode(text, VERSION), address = home() + hash;
  const says = address.length <= SHORT ? "short" : address.length <= LONG ? "long" : "huge";
  const frame = `${home()}?embed${part > 0 ? `&part=${part.toFixed(3)}` : ""}${hash}`;
  const row = (label: string, content: string) => {
    const field = make("input", { readonly: true, value: content, "aria-label": label, onfocus: () => field.select() });
    const copy = make("button", { class: "plain", onclick: () => void copied(copy, content, store) }, word(language, "copy"));
    return make("label", { class: "row" }, make("span", {}, label), field, copy);
  };
  const file = make("button", { class: "fix", onclick: () => download("mechanism.mech", "text/plain", text) }, word(language, "file"));
  opened(
    store,
    "share",
    make("p", { class: "soft" }, word(language, says, address.length)),
    row(word(language, "link"), address),
    row("Markdown", `[assur](${address})`),
    row(word(language, "page"), `<iframe src="${frame}" title="assur" loading="lazy" style="width:100%;height:36rem;border:0"></iframe>`),
    ...(says === "huge" ? [file] : []),
  );
}

async function copied(button: HTMLElement, text: string, store: Store): Promise<void> {
  await navigator.clipboard.writeText(text).catch(() => undefined);
  button.textContent = word(store.now.language, "copied");
}

export function save(store: Store, asked: Asked, text: () => string): void {
  const { language, part } = store.now;
  const said = make("p", { role: "status" });
  const item = (key: Word, made: () => Promise<void> | void) => {
    const run = async () => {
      said.textContent = "";
      try {
        await made();
      } catch (error) {
        said.textContent = reason(error);
      }
    };
    return make("li", {}, make("button", { class: "plain wide", onclick: () => void run() }, word(language, key)));
  };
  const written = (what: File) => async () => {
    const { name, type, text: content } = await asked.write(what, part > 0 ? part : undefined);
    download(name, type, content);
  };
  const picture = async () => (await asked.draw("scheme", part, "light")).join("");
  opened(
    store,
    "save",
    make(
      "ul",
      { class: "list" },
      item("file", () => download("mechanism.mech", "text/plain", text())),
      item("svg", async () => download("mechanism.svg", "image/svg+xml", await picture())),
      item("png", async () => download("mechanism.png", "image/png", await pixels(await picture()))),
      item("csv", written("poses.csv")),
      item("json", written("solution.json")),
      item("html", written("worked.html")),
      item("sheet", written("sheet.html")),
      item("key", written("key.html")),
      item("motion", written("motion.html")),
    ),
    said,
  );
}

/** A picture in pixels, three for each of the screen. */
async function pixels(svg: string): Promise<Blob> {
  const image = new Image(), address = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  image.src = address;
  await image.decode();
  const canvas = make("canvas", {});
  [canvas.width, canvas.height] = [3 * image.naturalWidth, 3 * image.naturalHeight];
  canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
  URL.revokeObjectURL(address);
  return new Promise((resolve, reject) => canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("PNG")))));
}

export function keys(store: Store): void {
  const at = LANGUAGES.indexOf(store.now.language);
  opened(store, "help", make("dl", { class: "keys" }, ...KEYS.flatMap(([key, does]) => [make("dt", {}, make("kbd", {}, key)), make("dd", {}, does[at])])));
}
