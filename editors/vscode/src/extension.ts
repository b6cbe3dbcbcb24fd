// The language server of `assur` in VS Code: a program, or the server that is built in.

import { Uri, commands, window, workspace, type ExtensionContext } from "vscode";
import { LanguageClient, type LanguageClientOptions, type MessageTransports } from "vscode-languageclient/node";
import { load, run } from "./built-in";
import { Preview } from "./preview";
import { PAGES, pageOf, showPage } from "./pages";
import { findServer } from "./program";
import type { Server } from "./server";
import { Status } from "./status";
import { runOnFile } from "./terminal";

class Extension {
  private server: Server = { kind: "none", problem: "The language server is not started yet." };
  private client: LanguageClient | undefined;
  private module: Promise<WebAssembly.Module> | undefined;
  private readonly status = new Status();
  private readonly preview = new Preview();
  /** Starts and stops happen one after another. */
  private queue: Promise<void> = Promise.resolve();

  constructor(private readonly context: ExtensionContext) {
    const on = (command: "solve" | "test") => (): Promise<void> => runOnFile(this.server, this.client, command);
    context.subscriptions.push(
      this.status,
      this.preview,
      commands.registerCommand("assur.restart", () => this.restart()),
      commands.registerCommand("assur.terminal.solve", on("solve")),
      commands.registerCommand("assur.terminal.test", on("test")),
      commands.registerCommand("assur.openPreview", () => this.preview.open(this.client)),
      commands.registerCommand("assur.format", () => commands.executeCommand("editor.action.formatDocument")),
      commands.registerCommand("assur.log", () => this.client?.outputChannel.show()),
      workspace.registerTextDocumentContentProvider(PAGES, { provideTextDocumentContent: (uri) => pageOf(this.client, uri) }),
      workspace.onDidChangeConfiguration((change) => (change.affectsConfiguration("assur.path") ? this.restart() : undefined)),
    );
  }

  restart(): Promise<void> {
    this.queue = this.queue.then(() => this.start());
    return this.queue;
  }

  async stop(): Promise<void> {
    const running = this.client;
    this.client = undefined;
    await running?.dispose();
  }

  private async start(): Promise<void> {
    await this.stop();
    const own = String(this.context.extension.packageJSON.version);
    this.server = await findServer(own);
    if (this.server.kind !== "none") {
      const program = this.server.kind === "program" ? this.server.path : undefined;
      const server = program === undefined ? () => this.builtIn() : { command: program, args: ["lsp"] };
      this.client = new LanguageClient("assur", "assur", server, this.options());
      this.preview.follow(this.client);
      try {
        await this.client.start();
      } catch (error) {
        this.server = { kind: "none", problem: `The language server ${program ?? "that is built in"} does not start: ${String(error)}` };
      }
    }
    this.status.show(this.server);
    if (this.server.kind === "none") {
      void complain(this.server.problem);
    } else if (this.server.kind === "built in" && this.server.warning) {
      void window.showWarningMessage(`${this.server.why} The built-in server runs instead.`);
    }
  }

  /** What the server gets, and what is done here instead of there. */
  private options(): LanguageClientOptions {
    return {
      documentSelector: [{ language: "mech" }],
      initializationOptions: { hints: workspace.getConfiguration("assur").get("hints") },
      synchronize: { configurationSection: "assur" },
      middleware: {
        executeCommand: (command, args, next) => {
          if (command === "assur.preview") return this.preview.open(this.client);
          if (command === "assur.solve") return runOnFile(this.server, this.client, "solve");
          return command === "assur.explain" ? showPage(String(args[1])) : next(command, args);
        },
      },
    };
  }

  private async builtIn(): Promise<MessageTransports> {
    const folder = Uri.joinPath(this.context.extensionUri, "out").fsPath;
    this.module ??= load(folder);
    return run(folder, await this.module, (why) => {
      this.client?.error(`The built-in server ended: ${why}`);
      void window.showWarningMessage(`The built-in server of assur ended and is started again. ${why} The program \`assur\` has no such limit.`);
    });
  }
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

let extension: Extension | undefined;

export async function activate(context: ExtensionContext): Promise<void> {
  extension = new Extension(context);
  await extension.restart();
}

export async function deactivate(): Promise<void> {
  await extension?.stop();
}
