// The item in the status bar that says which server runs.

import { MarkdownString, StatusBarAlignment, ThemeColor, languages, window, type Disposable } from "vscode";
import type { Server } from "./server";

/** Shown while a `.mech` file is in front. */
export class Status implements Disposable {
  private readonly item = window.createStatusBarItem("assur", StatusBarAlignment.Right, 100);
  private readonly watch: Disposable;

  constructor() {
    this.item.name = "assur";
    this.watch = window.onDidChangeActiveTextEditor(() => this.place());
    this.place();
  }

  show(server: Server): void {
    if (server.kind === "none") {
      this.item.text = "$(error) assur";
      this.item.tooltip = server.problem;
      this.item.command = { command: "workbench.action.openSettings", title: "Choose the program", arguments: ["assur.path"] };
    } else {
      const [name, of] =
        server.kind === "program"
          ? [`assur ${server.version}`, `The program of \`${server.from}\`: ${server.path}`]
          : [`assur ${server.version} (built in)`, `The server that is built in. ${server.why}`];
      this.item.text = name;
      this.item.tooltip = new MarkdownString(`${of}\n\nPress to restart the language server.`);
      this.item.command = "assur.restart";
    }
    this.item.backgroundColor = server.kind === "none" ? new ThemeColor("statusBarItem.errorBackground") : undefined;
    this.place();
  }

  dispose(): void {
    this.watch.dispose();
    this.item.dispose();
  }

  private place(): void {
    const document = window.activeTextEditor?.document;
    if (document && languages.match({ language: "mech" }, document)) {
      this.item.show();
    } else {
      this.item.hide();
    }
  }
}
