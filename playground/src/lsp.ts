// What the client of CodeMirror lacks: changes sent at once, diagnostics with their fixes, colours and hints of the server, clean
// Markdown.

import { LSPClient, LSPPlugin, type LSPClientExtension } from "@codemirror/lsp-client";
import { setDiagnostics, type Action, type Diagnostic } from "@codemirror/lint";
import { RangeSet, StateEffect, StateField, type Extension, type Range } from "@codemirror/state";
import { Decoration, EditorView, WidgetType, hoverTooltip, type DecorationSet } from "@codemirror/view";
import type * as protocol from "vscode-languageserver-protocol";

/** The pause before a change is sent, ms. */
const PAUSE = 8;

/** Sends every change after a short pause. */
export function synced(client: () => LSPClient | undefined, changed: () => void): Extension {
  let timer: ReturnType<typeof setTimeout> | undefined;
  return EditorView.updateListener.of((update) => {
    if (!update.docChanged) return;
    changed();
    clearTimeout(timer);
    timer = setTimeout(() => client()?.sync(), PAUSE);
  });
}

/** The edits of a text, as one change. */
export function apply(view: EditorView, edits: protocol.TextEdit[]): void {
  const plugin = LSPPlugin.get(view);
  if (!plugin) return;
  const changes = edits.map(({ range, newText }) => ({
    from: plugin.fromPosition(range.start),
    to: plugin.fromPosition(range.end),
    insert: newText,
  }));
  view.dispatch({ changes, userEvent: "input.fix" });
}

export interface Fix {
  title: string;
  edits: protocol.TextEdit[];
}

/** The fixes of a diagnostic. */
export async function fixes(client: LSPClient, uri: string, diagnostic: protocol.Diagnostic): Promise<Fix[]> {
  const params = { textDocument: { uri }, range: diagnostic.range, context: { diagnostics: [diagnostic] } };
  const actions = await client.request<typeof params, protocol.CodeAction[]>("textDocument/codeAction", params);
  return actions
    .filter((action) => action.kind === "quickfix" && action.edit !== undefined)
    .map((action) => ({ title: action.title, edits: editsOf(action.edit!, uri) }))
    .filter((fix) => fix.edits.length > 0);
}

function editsOf(edit: protocol.WorkspaceEdit, uri: string): protocol.TextEdit[] {
  const of = (edit.documentChanges ?? []).flatMap((change) => ("edits" in change && change.textDocument.uri === uri ? (change.edits as protocol.TextEdit[]) : []));
  return [...(edit.changes?.[uri] ?? []), ...of];
}

const SEVERITIES = ["error", "error", "warning", "info", "hint"] as const;

/** Shows the diagnostics of the server; their fixes are asked for and follow. */
export async function show(view: EditorView, client: LSPClient, uri: string, found: protocol.Diagnostic[]): Promise<void> {
  const plugin = LSPPlugin.get(view);
  if (!plugin) return;
  const text = view.state.doc;
  const of = (one: protocol.Diagnostic, actions: Action[]): Diagnostic => {
    const [from, to] = [plugin.fromPosition(one.range.start), plugin.fromPosition(one.range.end)];
    return {
      from: Math.min(from, text.length),
      to: Math.min(Math.max(to, from), text.length),
      severity: SEVERITIES[one.severity ?? 1],
      message: typeof one.message === "string" ? one.message : "",
      markClass: one.tags?.includes(1) ? "faded" : "",
      actions,
    };
  };
  view.dispatch(setDiagnostics(view.state, found.map((one) => of(one, []))));
  const all = await Promise.all(
    found.map(async (one) => {
      const fixed = one.tags?.includes(1) ? [] : await fixes(client, uri, one).catch(() => []);
      return of(one, fixed.map(({ title, edits }) => ({ name: title, apply: () => apply(view, edits) })));
    }),
  );
  if (view.state.doc.eq(text)) view.dispatch(setDiagnostics(view.state, all));
}

/** What the server says of a name under the pointer; nothing where the text has changed meanwhile. */
export const hovers: Extension = hoverTooltip(
  async (view, pos) => {
    const plugin = LSPPlugin.get(view), text = view.state.doc;
    if (!plugin) return null;
    plugin.client.sync();
    const params = { textDocument: { uri: plugin.uri }, position: plugin.toPosition(pos) };
    const said = await plugin.client.request<typeof params, protocol.Hover | null>("textDocument/hover", params).catch(() => null);
    if (said === null || !view.state.doc.eq(text)) return null;
    const create = () => {
      const dom = document.createElement("div");
      dom.className = "hover";
      dom.innerHTML = plugin.docToHTML(said.contents as protocol.MarkupContent);
      return { dom };
    };
    const range = said.range;
    return { pos: range ? plugin.fromPosition(range.start) : pos, end: range ? plugin.fromPosition(range.end) : pos, above: true, create };
  },
  { hideOnChange: true },
);

// Colours and hints: decorations that move with the text until the server says new ones.

const coloured = StateEffect.define<DecorationSet>();
const hinted = StateEffect.define<DecorationSet>();

const field = (effect: typeof coloured) =>
  StateField.define<DecorationSet>({
    create: () => Decoration.none,
    update: (now, transaction) => transaction.effects.reduce((all, one) => (one.is(effect) ? one.value : all), now.map(transaction.changes)),
    provide: (own) => EditorView.decorations.from(own),
  });

class Hint extends WidgetType {
  constructor(private readonly text: string) {
    super();
  }

  override eq(other: Hint): boolean {
    return other.text === this.text;
  }

  toDOM(): HTMLElement {
    const element = document.createElement("span");
    element.className = "hint";
    element.textContent = this.text;
    element.setAttribute("aria-hidden", "true");
    return element;
  }
}

export const shades: Extension = [field(coloured), field(hinted)];

/** Asks for the colours of the text. */
export async function colour(view: EditorView, client: LSPClient, uri: string): Promise<void> {
  // the server answers of this text and no older one
  client.sync();
  const text = view.state.doc;
  const legend = client.serverCapabilities?.semanticTokensProvider?.legend.tokenTypes ?? [];
  const params = { textDocument: { uri } };
  const { data } = await client.request<typeof params, protocol.SemanticTokens>("textDocument/semanticTokens/full", params);
  if (!view.state.doc.eq(text)) return;
  const marks: Range<Decoration>[] = [];
  for (let at = 0, line = 0, column = 0; at + 4 < data.length; at += 5) {
    if (data[at] > 0) [line, column] = [line + data[at], 0];
    column += data[at + 1];
    if (line >= text.lines) break;
    const from = Math.min(text.line(line + 1).from + column, text.length), to = Math.min(from + data[at + 2], text.length);
    if (to > from) marks.push(Decoration.mark({ class: `t-${legend[data[at + 3]] ?? "other"}` }).range(from, to));
  }
  view.dispatch({ effects: coloured.of(RangeSet.of(marks, true)) });
}

/** Asks for the hints of the text. */
export async function hint(view: EditorView, client: LSPClient, uri: string): Promise<void> {
  client.sync();
  const text = view.state.doc, plugin = LSPPlugin.get(view);
  const range = { start: { line: 0, character: 0 }, end: plugin?.toPosition(text.length) };
  const params = { textDocument: { uri }, range };
  const hints = await client.request<typeof params, protocol.InlayHint[]>("textDocument/inlayHint", params);
  if (!plugin || !view.state.doc.eq(text)) return;
  const marks = hints.map(({ position, label }) =>
    Decoration.widget({ widget: new Hint(typeof label === "string" ? label : ""), side: 1 }).range(Math.min(plugin.fromPosition(position), text.length)),
  );
  view.dispatch({ effects: hinted.of(RangeSet.of(marks, true)) });
}

/** What this client can do. */
export const capabilities: LSPClientExtension = {
  clientCapabilities: { textDocument: { publishDiagnostics: { tagSupport: { valueSet: [1] } } } },
};

const KEPT = new Set(["P", "CODE", "PRE", "EM", "STRONG", "UL", "OL", "LI", "BR", "HR", "H1", "H2", "H3", "H4", "TABLE", "THEAD", "TBODY", "TR", "TH", "TD", "BLOCKQUOTE", "SPAN", "DIV"]);

/** Markdown as HTML: names in it come from the text of a stranger. */
export function sanitized(html: string): string {
  const page = new DOMParser().parseFromString(html, "text/html");
  const clean = (node: Element): void => {
    for (const child of [...node.children]) {
      clean(child);
      if (!KEPT.has(child.tagName)) {
        child.replaceWith(child.textContent ?? "");
        continue;
      }
      for (const { name } of [...child.attributes]) if (name !== "class") child.removeAttribute(name);
    }
  };
  clean(page.body);
  return page.body.innerHTML;
}
