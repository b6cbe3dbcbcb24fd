// The item in the status bar that says which server runs.

import { MarkdownString, StatusBarAlignment, ThemeColor, languages, window, type Disposable } from "vscode";
import type { Program } from "./program";

/** Shown while a `.mech` file is in front. */
export class Status implements Disposable {
  private readonly item = window.createStatusBarItem("assur", StatusBarAlignment.Right, 100);
  private readonly watch: Disposable;

  constructor() {
    this.item.name = "assur";
    this.watch = window.onDidChangeActiveTextEditor(() => this.place());
    this.place();
  }

  show(program: Program): void {
    if ("problem" in program) {
      this.item.text = "$(error) assur";
      this.item.tooltip = program.problem;
      this.item.command = { command: "workbench.action.openSettings", title: "Choose the program", arguments: ["assur.path"] };
      this.item.backgroundColor = new ThemeColor("statusBarItem.errorBackground");
    } else {
      this.item.text = `assur ${program.version}`;
      this.item.tooltip = new MarkdownString(`The program of \`${program.from}\`: ${program.path}\n\nPress to restart its language server.`);
      this.item.command = "assur.restart";
      this.item.backgroundColor = undefined;
    }
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
