// The editor: CodeMirror with the language server.

import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { bracketMatching, indentUnit } from "@codemirror/language";
import { lintGutter, lintKeymap } from "@codemirror/lint";
import { findReferencesKeymap, formatKeymap, jumpToDefinitionKeymap, renameKeymap, serverCompletion, signatureHelp, type LSPClient } from "@codemirror/lsp-client";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { EditorState, type Extension } from "@codemirror/state";
import { EditorView, drawSelection, highlightActiveLine, highlightSpecialChars, keymap, lineNumbers } from "@codemirror/view";
import { hovers, shades, synced } from "./lsp";

export const URI = "untitled:mechanism.mech";

/** How the editor looks: colours are variables of the style sheet. */
const LOOK = EditorView.theme({
  "&": { height: "100%", fontSize: "var(--code)" },
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.5" },
  ".cm-content": { caretColor: "var(--ink)" },
  ".cm-gutters": { background: "transparent", color: "var(--soft)", border: "none" },
  ".cm-activeLine": { background: "var(--tint)" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  "&.cm-focused .cm-selectionBackground, .cm-selectionBackground": { background: "var(--select) !important" },
  "&.cm-focused": { outline: "none" },
  ".cm-tooltip": { background: "var(--paper)", color: "var(--ink)", border: "1px solid var(--line)", borderRadius: "4px", maxWidth: "36rem" },
  ".cm-tooltip-autocomplete ul li[aria-selected]": { background: "var(--accent)", color: "#fff" },
  ".cm-diagnosticAction": { background: "var(--accent)", borderRadius: "4px", padding: "3px 8px" },
  ".cm-panels": { background: "var(--paper)", color: "var(--ink)" },
  ".cm-diagnosticText": { whiteSpace: "pre-wrap" },
});

export interface Editor {
  view: EditorView;
  /** Connects it with the server. */
  connect(client: LSPClient): void;
  text(): string;
  /** Another text in place of all. */
  replace(text: string): void;
  /** Adds lines at the end. */
  append(lines: string): void;
  go(line: number, column?: number): void;
}

export function editor(parent: HTMLElement, text: string, label: string, readOnly: boolean, changed: () => void): Editor {
  let client: LSPClient | undefined;
  const common: Extension = [
    lineNumbers(),
    highlightSpecialChars(),
    history(),
    drawSelection(),
    bracketMatching(),
    closeBrackets(),
    autocompletion(),
    highlightActiveLine(),
    highlightSelectionMatches(),
    lintGutter(),
    indentUnit.of("  "),
    EditorState.tabSize.of(2),
    EditorState.readOnly.of(readOnly),
    EditorView.lineWrapping,
    EditorView.contentAttributes.of({ "aria-label": label, spellcheck: "false", autocapitalize: "off" }),
    shades,
    synced(() => client, changed),
    keymap.of([...closeBracketsKeymap, ...defaultKeymap, ...searchKeymap, ...historyKeymap, ...completionKeymap, ...lintKeymap, ...formatKeymap, ...renameKeymap, ...jumpToDefinitionKeymap, ...findReferencesKeymap, indentWithTab]),
    LOOK,
  ];
  const view = new EditorView({ parent, doc: text, extensions: common });
  return {
    view,
    connect(own) {
      client = own;
      const plugin = own.plugin(URI, "mech");
      view.setState(EditorState.create({ doc: view.state.doc, selection: view.state.selection, extensions: [common, plugin, serverCompletion(), hovers, signatureHelp()] }));
    },
    text: () => view.state.doc.toString(),
    replace(next) {
      view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: next }, selection: { anchor: 0 }, scrollIntoView: true });
    },
    append(lines) {
      const end = view.state.doc.length, last = view.state.doc.line(view.state.doc.lines).length;
      const insert = (last > 0 ? "\n" : "") + lines + "\n";
      view.dispatch({ changes: { from: end, insert }, selection: { anchor: end + insert.length }, scrollIntoView: true });
    },
    go(line, column = 0) {
      const at = view.state.doc.line(Math.min(Math.max(line, 1), view.state.doc.lines));
      view.dispatch({ selection: { anchor: Math.min(at.from + column, at.to) }, scrollIntoView: true });
      view.focus();
    },
  };
}
