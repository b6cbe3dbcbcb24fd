// The mechanism in motion, next to its text: the page of the server's command `assur.preview`, or a panel that gets what it shows.

import { Position, Selection, UIKind, Uri, ViewColumn, commands, env, window, type Disposable, type WebviewPanel } from "vscode";
import type { BaseLanguageClient, State } from "vscode-languageclient/node";
import style from "../../../crates/assur-picture/src/animation/player.css" with { type: "text" };
import player from "../../../crates/assur-picture/src/animation/player.js" with { type: "text" };
import shell from "../../../src/cli/preview/page.html";

/** The page around a picture, with the player. */
const page = shell.replace("/* PLAYER STYLE */", () => style).replace("/* PLAYER */", () => player);

/** What a text comes to, as the server tells it. */
interface Shown {
  picture: object | null;
}

export class Preview implements Disposable {
  private readonly panels = new Map<string, WebviewPanel>();
  private client: BaseLanguageClient | undefined;

  /** Opens the page of the file in front in an editor to the side. */
  async open(client: BaseLanguageClient | undefined): Promise<void> {
    const document = window.activeTextEditor?.document;
    if (document?.languageId !== "mech" || client === undefined) {
      void window.showInformationMessage("Open a .mech file first.");
      return;
    }
    const uri = client.code2ProtocolConverter.asUri(document.uri);
    const address = await addressOf(client, uri);
    if (address === null) {
      this.panel(uri).reveal(undefined, true);
      return;
    }
    const there = Uri.parse(address);
    // of another machine the port is forwarded; servers of VS Code in a browser would lose the key
    const shown = env.uiKind === UIKind.Desktop ? await env.asExternalUri(there) : there;
    await commands.executeCommand("simpleBrowser.api.open", shown, { viewColumn: ViewColumn.Beside, preserveFocus: true });
  }

  /** Shows what a server tells from now on. */
  follow(client: BaseLanguageClient): void {
    this.client = client;
    client.onNotification("assur/shown", ({ uri, shown }: { uri: string; shown: Shown }) => this.show(uri, shown));
    client.onNotification("assur/marked", ({ uri, marked }: { uri: string; marked: object | null }) => {
      void this.panels.get(uri)?.webview.postMessage({ marked });
    });
    // a server that starts again knows of no panels
    client.onDidChangeState(({ newState }) => {
      if (newState === RUNNING) void client.start().then(() => [...this.panels.keys()].map((uri) => ask(client, uri)));
    });
  }

  dispose(): void {
    this.panels.forEach((panel) => panel.dispose());
  }

  private show(uri: string, shown: Shown): void {
    void this.panels.get(uri)?.webview.postMessage({ shown });
  }

  private panel(uri: string): WebviewPanel {
    const known = this.panels.get(uri);
    if (known) return known;
    const name = decodeURIComponent(uri.split("/").at(-1) ?? uri);
    const beside = { viewColumn: ViewColumn.Beside, preserveFocus: true };
    const panel = window.createWebviewPanel("assur.preview", name, beside, { enableScripts: true, retainContextWhenHidden: true });
    this.panels.set(uri, panel);
    panel.onDidDispose(() => {
      this.panels.delete(uri);
      void this.client?.sendNotification("assur/hide", { uri }).catch(() => undefined);
    });
    panel.webview.onDidReceiveMessage(({ ready, part, line }: { ready?: true; part?: number; line?: number }) => {
      // what was sent before the panel could listen is sent again
      if (ready && this.client) ask(this.client, uri);
      if (part !== undefined) void this.client?.sendNotification("assur/pose", { uri, part });
      if (line !== undefined) void reveal(uri, line);
    });
    panel.webview.html = page.replace("<title>assur preview</title>", `<title></title>${POLICY}`).replace("assur preview</b>", `${escaped(name)}</b>`);
    return panel;
  }
}

/** `State.Running`, without the code of the client. */
const RUNNING: State.Running = 2;

/** Asks a server to tell what to show of a text; of one that is closed it tells nothing. */
function ask(client: BaseLanguageClient, uri: string): void {
  void addressOf(client, uri).catch(() => undefined);
}

/** The line of a statement that was clicked. */
async function reveal(uri: string, line: number): Promise<void> {
  const at = new Position(line - 1, 0);
  const beside = window.visibleTextEditors.find((editor) => editor.document.uri.toString() === Uri.parse(uri).toString());
  const editor = beside ?? (await window.showTextDocument(Uri.parse(uri), { preserveFocus: true }));
  editor.selection = new Selection(at, at);
  editor.revealRange(editor.selection);
}

/** Nothing is loaded from elsewhere. */
const POLICY = `<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'">`;

function escaped(text: string): string {
  return text.replace(/&/g, "&amp;").replace(/</g, "&lt;");
}

/** The address of the page of a text; nothing where the server has none and tells what to show. */
async function addressOf(client: BaseLanguageClient, uri: string): Promise<string | null> {
  // false: it is shown here and not in a browser
  const asked = { command: "assur.preview", arguments: [uri, false] };
  return (await client.sendRequest<{ address: string | null }>("workspace/executeCommand", asked)).address;
}
