// Which `assur` runs, and why.

import { execFile } from "node:child_process";
import { access, constants, stat } from "node:fs/promises";
import { delimiter, join } from "node:path";
import { promisify } from "node:util";
import { workspace } from "vscode";

/** A program that can be started, or the reason why there is none. */
export type Program = { path: string; version: string; from: "assur.path" | "PATH" } | { problem: string };

const run = promisify(execFile);

async function isProgram(path: string): Promise<boolean> {
  try {
    await access(path, constants.X_OK);
    return (await stat(path)).isFile();
  } catch {
    return false;
  }
}

async function onPath(): Promise<string | undefined> {
  const name = process.platform === "win32" ? "assur.exe" : "assur";
  for (const folder of (process.env.PATH ?? "").split(delimiter)) {
    const path = join(folder, name);
    if (folder !== "" && (await isProgram(path))) {
      return path;
    }
  }
  return undefined;
}

async function versionOf(path: string): Promise<string | undefined> {
  try {
    const { stdout } = await run(path, ["--version"], { timeout: 10_000 });
    return /^assur (\S+)/.exec(stdout)?.[1];
  } catch {
    return undefined;
  }
}

/** The program of the setting `assur.path`, or the one on PATH where that is empty: never one instead of the other. */
export async function findProgram(): Promise<Program> {
  const wanted = workspace.getConfiguration("assur").get<string>("path", "").trim();
  if (wanted !== "" && !(await isProgram(wanted))) {
    return { problem: `assur.path is ${wanted}, which is not a program. Correct it, or leave it empty to use the one on PATH.` };
  }
  const path = wanted === "" ? await onPath() : wanted;
  if (path === undefined) {
    return { problem: "No program `assur` is on PATH. Install it with `cargo install --path .` in its repository, or set assur.path." };
  }
  const version = await versionOf(path);
  if (version === undefined) {
    return { problem: `${path} does not answer to --version as assur does.` };
  }
  return { path, version, from: wanted === "" ? "PATH" : "assur.path" };
}
