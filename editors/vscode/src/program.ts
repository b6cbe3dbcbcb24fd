// Finds the program of `assur.path` or of PATH.

import { execFile } from "node:child_process";
import { access, constants, stat } from "node:fs/promises";
import { delimiter, join } from "node:path";
import { promisify } from "node:util";
import { workspace } from "vscode";
import { series, type Server } from "./server";

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

/** The program of the setting `assur.path`, else the one on PATH; the built-in server where there is none of this version. */
export async function findServer(own: string): Promise<Server> {
  const wanted = workspace.getConfiguration("assur").get<string>("path", "").trim();
  if (wanted !== "" && !(await isProgram(wanted))) {
    const problem = `assur.path is ${wanted}, which is not a program. Correct it, or leave it empty to use the one on PATH or the built-in server.`;
    return { kind: "none", problem };
  }
  const from = wanted === "" ? "PATH" : "assur.path";
  const path = wanted === "" ? await onPath() : wanted;
  if (path === undefined) {
    return { kind: "built in", version: own, why: "No program `assur` is on PATH." };
  }
  const version = await versionOf(path);
  if (version === undefined) {
    const why = `${path} does not answer to --version as assur does.`;
    return from === "PATH" ? { kind: "built in", version: own, why, warning: true } : { kind: "none", problem: why };
  }
  if (series(version) !== series(own)) {
    const why = `${path} is assur ${version}; this extension is for ${series(own)}.`;
    return { kind: "built in", version: own, why, warning: true };
  }
  return { kind: "program", path, version, from };
}
