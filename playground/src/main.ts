// The page: wires the editor, the engine, the picture and what stands beside them.

import { LSPClient, type LSPClientExtension } from "@codemirror/lsp-client";
import type { Diagnostic } from "vscode-languageserver-protocol";
import first from "../../examples/press.mech";
import { Asked, reason } from "./asked";
import * as dialogs from "./dialogs";
import { find, make } from "./dom";
import { URI, editor } from "./editor";
import { Engine } from "./engine";
import { Gallery, examples } from "./gallery";
import { decode } from "./link";
import * as lsp from "./lsp";
import { addressOfWorker, module } from "./parts";
import { Panes } from "./panes";
import { Picture } from "./picture";
import { Store, kept } from "./state";
import { KEPT, aside, texts } from "./texts";
import { Lesson } from "./tutorial";
import { LANGUAGES, preferred, word, type Language, type Word } from "./words";

/** From the last key to the whole motion; until the last good picture is grey; from a rest of the slider to what shows one position; ms. */
const WHOLE = 150, GREY = 300, REST = 250;
/** The longest text that is opened. */
const LONGEST = 1 << 20;

const query = new URLSearchParams(location.search);
const embedded = query.has("embed");
const stored = kept.get("language");
const language = LANGUAGES.find((one) => one === stored) ?? preferred();
const store = new Store({ language, tab: "answers", shown: 0, old: false, busy: true, late: false, failed: "", part: Number(query.get("part") ?? 0) || 0, problems: [] });
const say = (key: Word, ...parts: (string | number)[]): string => word(store.now.language, key, ...parts);

let client: LSPClient | undefined;
let engine: Engine | undefined;
let typed = 0;
const timers: Record<string, ReturnType<typeof setTimeout>> = {};
const after = (name: string, pause: number, does: () => void): void => {
  clearTimeout(timers[name]);
  timers[name] = setTimeout(does, pause);
};

const own = editor(find("editor"), "", say("editor"), embedded && !query.has("edit"), () => {
  typed = performance.now();
  if (store.now.late) store.set({ late: false });
  engine?.changed();
  after("keep", 500, keep);
});

const asked = new Asked(new Proxy({} as LSPClient, { get: (_, name) => Reflect.get(client ?? {}, name, client) }), () => store.now.language);

const picture = new Picture({
  moved(part, playing) {
    store.set({ part });
    if (playing) return;
    after("rest", REST, () => {
      if (client) asked.pose(part);
      void hints();
      panes.rested();
    });
  },
  line: (line) => own.go(line),
  show: (kind) => void motion(kind),
});

const panes = new Panes(store, asked, {
  of: async (problem) => (client ? lsp.fixes(client, URI, problem) : []),
  apply: (fix) => lsp.apply(own.view, fix.edits),
  go: (line, column) => own.go(line, column),
});

const lesson = new Lesson(store, asked, {
  append: (lines) => own.append(lines),
  leave() {
    keep();
    if (before !== null) own.replace(before);
    before = null;
    store.set({ tab: "answers" });
  },
});

/** The text that the page put into the editor; any other is the author's. */
let given = "";
/** What the tutorial took the place of, while it is open. */
let before: string | null = null;

/** Keeps what was written: the tutorial's, or the author's. */
function keep(): void {
  const text = own.text();
  if (before !== null) kept.set("tutorial", text);
  else if (!embedded && text !== given && text.length < KEPT) kept.set("text", text);
}

/** Another text, with its address, or one of the author's, which has none. What the author has written is set aside. */
function take(text: string, hash?: string): void {
  keep();
  const last = before ?? own.text();
  before = null;
  aside(last === given ? "" : last, hash === undefined ? text : "");
  given = hash === undefined ? "" : text;
  own.replace(text);
  keep();
  history.replaceState(null, "", location.pathname + location.search + (hash ?? ""));
  find("mine").hidden = hash === undefined || texts().length === 0;
}

function restore(): void {
  take(texts()[0] ?? first);
  store.set({ tab: "answers" });
}

function startLesson(): void {
  if (before === null) {
    keep();
    before = own.text();
    own.replace(kept.get("tutorial") ?? "");
    picture.others([], "");
    store.set({ shown: 0, old: false });
  }
  store.set({ tab: "tutorial" });
  own.view.focus();
}

// What the server says.

function published({ version, diagnostics }: { version?: number; diagnostics: Diagnostic[] }): void {
  if (!client) return;
  store.set({ problems: diagnostics });
  void lsp.show(own.view, client, URI, diagnostics);
  void lsp.colour(own.view, client, URI).catch(() => undefined);
  lesson.changed();
  const wrong = diagnostics.some((one) => (one.severity ?? 1) === 1);
  if (wrong) after("grey", GREY, () => store.set({ old: own.text() !== "" }));
  if (!wrong && version !== undefined) void hints();
}

function solved(): void {
  clearTimeout(timers.grey);
  store.set({ old: false, late: false });
  void hints();
  lesson.changed();
  const rest = WHOLE - (performance.now() - typed);
  if (rest > 0 && store.now.shown > 0) {
    void asked.picture(store.now.part).then((one) => picture.still(one.svg), () => undefined);
  }
  after("whole", Math.max(rest, 0), () => void whole());
}

async function whole(): Promise<void> {
  await Promise.all([motion(picture.shown), report()]);
  store.set({ shown: store.now.shown + 1 });
  document.body.dataset.ready = String(store.now.shown);
  fit();
}

async function motion(show: string): Promise<void> {
  try {
    const moving = await asked.motion(show);
    picture.take(moving, store.now.part);
  } catch (error) {
    if (show !== "") {
      picture.says(reason(error));
      return;
    }
    const kinds = await asked.kinds().catch(() => []);
    const drawn = kinds.length > 0 ? await asked.draw(kinds[0], 0, "auto").catch(() => []) : [];
    picture.others(drawn, reason(error));
  }
}

async function report(): Promise<void> {
  await asked.report().then((one) => panes.answers(one), () => undefined);
}

async function hints(): Promise<void> {
  if (client) await lsp.hint(own.view, client, URI).catch(() => undefined);
}

/** Above the picture: what is wrong, or that it takes too long. */
function bar(): void {
  const { old, late, problems, shown, failed } = store.now, strip = find("strip");
  document.body.classList.toggle("old", (old || late) && shown > 0);
  strip.replaceChildren();
  if (failed !== "") return strip.append(say("failed", failed));
  if (late) return strip.append(say("late"), " ", make("button", { class: "fix", onclick: () => engine?.again(60_000) }, say("again")));
  const error = problems.find((one) => (one.severity ?? 1) === 1);
  if (!old || !error) return;
  const { line, character } = error.range.start;
  const text = String(error.message).split("\n")[0];
  strip.append(make("button", { class: "sentence", onclick: () => own.go(line + 1, character) }, `${text} (${say("line", line + 1)})`));
  if (shown > 0 && find("picture").querySelector("svg")) strip.append(make("span", { class: "soft" }, say("old")));
}

function status(): void {
  const { problems, busy, shown, failed } = store.now;
  const errors = problems.filter((one) => (one.severity ?? 1) === 1).length;
  const text = failed !== "" ? "" : errors > 0 ? say(errors === 1 ? "oneError" : "errors", errors) : busy ? say(shown === 0 && !client ? "loading" : "works") : say("ok");
  const at = find("state");
  at.textContent = text;
  at.classList.toggle("wrong", errors > 0);
  after("spoken", 700, () => {
    const first = problems.find((one) => (one.severity ?? 1) === 1);
    find("spoken").textContent = first ? `${text}: ${String(first.message).split("\n")[0]}, ${say("line", first.range.start.line + 1)}` : text;
  });
}

/** Words of the page in the language that is chosen. */
function named(): void {
  document.documentElement.lang = store.now.language;
  for (const element of document.querySelectorAll<HTMLElement>("[data-word]")) element.textContent = say(element.dataset.word as Word);
  find("picture").setAttribute("aria-label", say("picture"));
}

/** An embedded page tells its height. */
function fit(): void {
  if (embedded) parent.postMessage({ assur: document.documentElement.scrollHeight }, "*");
}

// How the page begins.

function connect(compiled: WebAssembly.Module): void {
  const handlers: LSPClientExtension = {
    notificationHandlers: {
      "textDocument/publishDiagnostics": (_, params) => (published(params as Parameters<typeof published>[0]), true),
      "assur/solved": () => (solved(), true),
      "window/logMessage": () => true,
    },
  };
  const made = new LSPClient({
    timeout: 120_000,
    initializationOptions: { solved: true },
    sanitizeHTML: lsp.sanitized,
    extensions: [lsp.capabilities, handlers],
  });
  engine = new Engine(compiled, addressOfWorker(), {
    restarted: () => {
      made.disconnect();
      made.connect(engine!.transport);
    },
    // a text with errors has no answers, and says why
    late: () => store.set({ late: !store.now.problems.some((one) => (one.severity ?? 1) === 1) }),
    busy: (busy) => {
      if (busy) after("busy", 200, () => store.set({ busy: true }));
      else {
        clearTimeout(timers.busy);
        if (store.now.busy) store.set({ busy: false });
      }
    },
    failed: (failed) => store.set({ failed }),
  });
  client = made;
  made.connect(engine.transport);
  own.connect(made);
}

/** The text of the address, else that of the last visit, else the first example. */
async function begin(last: string | null): Promise<string> {
  const link = await decode(location.hash), notice = find("notice");
  notice.textContent = "";
  if (link.kind === "text") {
    if (link.version !== VERSION) notice.textContent = say("version", link.version, VERSION);
    return link.text;
  }
  if (link.kind === "example") {
    const found = (await examples().catch(() => [])).find((one) => one.name === link.name);
    if (!found) notice.textContent = say("missing");
    return found?.text ?? "";
  }
  if (link.kind === "none") return last ?? first;
  notice.textContent = say(link.kind);
  return "";
}

/** The page is at an address; what was written meanwhile is the author's. */
async function arrive(takes: () => boolean): Promise<void> {
  keep();
  const last = embedded ? null : kept.get("text");
  if (last !== null) aside(last);
  const text = await begin(last);
  if (takes()) take(text, text === last ? undefined : location.hash);
}

function controls(): void {
  const gallery = new Gallery(store, texts, take);
  const actions: Record<string, () => void> = {
    examples: () => void gallery.open(),
    tutorial: startLesson,
    share: () => void dialogs.share(store, own.text()),
    save: () => dialogs.save(store, asked, own.text),
    open: () => find<HTMLInputElement>("file").click(),
    keys: () => dialogs.keys(store),
    mine: restore,
  };
  for (const [id, does] of Object.entries(actions)) find(id).addEventListener("click", does);
  const languages = find<HTMLSelectElement>("language");
  languages.append(...LANGUAGES.map((one) => make("option", { value: one }, word(one, "name"))));
  languages.value = store.now.language;
  languages.addEventListener("change", () => {
    store.set({ language: languages.value as Language });
    kept.set("language", languages.value);
    if (store.now.shown > 0) void whole();
  });
  const opened = async (file: File | undefined) => {
    if (!file) return;
    if (file.size > LONGEST) find("notice").textContent = say("dropped");
    else take(await file.text());
  };
  find<HTMLInputElement>("file").addEventListener("change", (event) => void opened((event.target as HTMLInputElement).files?.[0]));
  addEventListener("dragover", (event) => event.preventDefault());
  addEventListener("drop", (event) => {
    event.preventDefault();
    void opened(event.dataTransfer?.files[0]);
  });
  addEventListener("keydown", (event) => {
    const control = event.ctrlKey || event.metaKey;
    const tabs = ["answers", "worked", "pictures", "problems", "tutorial"] as const;
    const at = event.target as HTMLElement;
    const writes = at.isContentEditable || ["INPUT", "TEXTAREA", "SELECT"].includes(at.tagName);
    if (control && event.key === "k") actions.examples();
    else if (control && event.key === "s") actions.save();
    else if (control && event.key === ".") {
      store.set({ tab: "problems" });
      find("pane-problems").querySelector<HTMLElement>(".fix, button")?.focus();
    } else if (event.altKey && !control && /^[1-5]$/.test(event.key)) {
      const tab = tabs[Number(event.key) - 1];
      if (tab === "tutorial") startLesson();
      else store.set({ tab });
    } else if (event.key === "?" && !writes) actions.keys();
    else return;
    event.preventDefault();
  });
  divider();
}

/** The border between the halves is dragged, and remembered. */
function divider(): void {
  const line = find("divider"), half = (share: number) => document.body.style.setProperty("--half", `${Math.min(Math.max(share, 20), 75)}%`);
  const last = Number(kept.get("half"));
  if (last > 0) half(last);
  let share = last || 46;
  const move = (event: PointerEvent) => half((share = (100 * event.clientX) / innerWidth));
  line.addEventListener("pointerdown", (event) => {
    line.setPointerCapture(event.pointerId);
    line.addEventListener("pointermove", move);
  });
  line.addEventListener("pointerup", () => {
    line.removeEventListener("pointermove", move);
    kept.set("half", String(share));
  });
  line.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -2, ArrowRight: 2 }[event.key];
    if (step) half((share += step));
  });
}

async function start(): Promise<void> {
  document.body.classList.toggle("embed", embedded);
  controls();
  if (embedded) {
    const text = find<HTMLDetailsElement>("text");
    text.open = query.has("text");
    text.addEventListener("toggle", fit);
    new ResizeObserver(fit).observe(document.body);
    find("playground").setAttribute("href", dialogs.home() + location.hash);
  }
  store.look((now, before) => {
    bar();
    status();
    if (now.language !== before.language || now === before) named();
  });
  const loads = module().then((compiled) => ({ compiled }), (why: unknown) => ({ failed: reason(why) }));
  await arrive(() => own.text() === "");
  addEventListener("pagehide", keep);
  addEventListener("hashchange", () => void arrive(() => true));
  const loaded = await loads;
  if ("failed" in loaded) return store.set({ failed: loaded.failed });
  connect(loaded.compiled);
}

void start();
