// Solves and tests the file in front: by the program in the terminal, by the built-in server beside the file.

import { ProcessExecution, Task, TaskPanelKind, TaskRevealKind, TaskScope, ViewColumn, tasks, window, workspace, type TextDocument } from "vscode";
import type { BaseLanguageClient } from "vscode-languageclient/node";
import type { Server } from "./server";

type Command = "solve" | "test";

/** `assur solve FILE` and its like, on the text as it is in the editor. */
export async function runOnFile(server: Server, client: BaseLanguageClient | undefined, command: Command): Promise<void> {
  const document = window.activeTextEditor?.document;
  if (document?.languageId !== "mech") {
    void window.showInformationMessage("Open a .mech file first.");
  } else if (server.kind === "none" || client === undefined) {
    void window.showErrorMessage(server.kind === "none" ? server.problem : "The language server is not started yet.");
  } else if (server.kind === "program") {
    await runInTerminal(server.path, command, document);
  } else {
    // false: it is shown here and not as a message
    const asked = { command: `assur.${command}`, arguments: [client.code2ProtocolConverter.asUri(document.uri), false] };
    const content = await client.sendRequest<string>("workspace/executeCommand", asked);
    const answers = await workspace.openTextDocument({ content });
    await window.showTextDocument(answers, { viewColumn: ViewColumn.Beside, preserveFocus: true });
  }
}

async function runInTerminal(program: string, command: Command, document: TextDocument): Promise<void> {
  const saved = document.isUntitled || document.isDirty ? await document.save() : true;
  if (!saved || document.uri.scheme !== "file") {
    void window.showInformationMessage(`Save the file first: assur ${command} reads it from the disk.`);
    return;
  }
  const execution = new ProcessExecution(program, [command, document.uri.fsPath]);
  const task = new Task({ type: "assur", command }, TaskScope.Workspace, `${command} ${document.uri.path.split("/").at(-1)}`, "assur", execution);
  task.presentationOptions = { reveal: TaskRevealKind.Always, panel: TaskPanelKind.Shared, clear: true, echo: false };
  await tasks.executeTask(task);
}
