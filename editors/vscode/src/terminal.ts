// Runs the program on the file in front, in the terminal.

import { ProcessExecution, Task, TaskPanelKind, TaskRevealKind, TaskScope, tasks, window } from "vscode";
import type { Program } from "./program";

/** `assur solve FILE` and its like, on the file as it is in the editor. */
export async function runOnFile(program: Program, command: "solve" | "test"): Promise<void> {
  const document = window.activeTextEditor?.document;
  if (document?.languageId !== "mech") {
    void window.showInformationMessage("Open a .mech file first.");
    return;
  }
  if ("problem" in program) {
    void window.showErrorMessage(program.problem);
    return;
  }
  const saved = document.isUntitled || document.isDirty ? await document.save() : true;
  if (!saved || document.uri.scheme !== "file") {
    void window.showInformationMessage(`Save the file first: assur ${command} reads it from the disk.`);
    return;
  }
  const execution = new ProcessExecution(program.path, [command, document.uri.fsPath]);
  const task = new Task({ type: "assur", command }, TaskScope.Workspace, `${command} ${document.uri.path.split("/").at(-1)}`, "assur", execution);
  task.presentationOptions = { reveal: TaskRevealKind.Always, panel: TaskPanelKind.Shared, clear: true, echo: false };
  await tasks.executeTask(task);
}
