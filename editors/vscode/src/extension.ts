// The language server of `assur` in VS Code.

import { commands, window, workspace, type ExtensionContext } from "vscode";
import { LanguageClient, type Executable } from "vscode-languageclient/node";
import { openPreview } from "./preview";
import { findProgram, type Program } from "./program";
import { Status } from "./status";
import { runOnFile } from "./terminal";

let program: Program = { problem: "The language server is not started yet." };
let client: LanguageClient | undefined;
let status: Status | undefined;
/** Starts and stops happen one after another. */
let queue: Promise<void> = Promise.resolve();

async function stop(): Promise<void> {
  const running = client;
  client = undefined;
  await running?.dispose();
}

async function start(): Promise<void> {
  await stop();
  program = await findProgram();
  if ("path" in program) {
    const run: Executable = { command: program.path, args: ["lsp"] };
    client = new LanguageClient("assur", "assur", { run, debug: run }, { documentSelector: [{ language: "mech" }] });
    try {
      await client.start();
    } catch (error) {
      program = { problem: `The language server of ${program.path} does not start: ${String(error)}` };
    }
  }
  status?.show(program);
  if ("problem" in program) {
    void complain(program.problem);
  }
}

function restart(): Promise<void> {
  queue = queue.then(start);
  return queue;
}

async function complain(problem: string): Promise<void> {
  const choose = "Choose the program";
  const help = "How to get it";
  const answer = await window.showErrorMessage(`${problem} Colours and snippets work without it.`, choose, help);
  if (answer === choose) {
    await commands.executeCommand("workbench.action.openSettings", "assur.path");
  } else if (answer === help) {
    await commands.executeCommand("workbench.action.openWalkthrough", "assur.mech#start");
  }
}

export async function activate(context: ExtensionContext): Promise<void> {
  status = new Status();
  context.subscriptions.push(
    status,
    commands.registerCommand("assur.restart", restart),
    commands.registerCommand("assur.terminal.solve", () => runOnFile(program, "solve")),
    commands.registerCommand("assur.terminal.test", () => runOnFile(program, "test")),
    commands.registerCommand("assur.openPreview", () => openPreview(client)),
    commands.registerCommand("assur.format", () => commands.executeCommand("editor.action.formatDocument")),
    commands.registerCommand("assur.log", () => client?.outputChannel.show()),
    workspace.onDidChangeConfiguration((change) => (change.affectsConfiguration("assur.path") ? restart() : undefined)),
  );
  await restart();
}

export function deactivate(): Promise<void> {
  return stop();
}
