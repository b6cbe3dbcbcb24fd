// Which server runs, and why.

/** A program, the server that is built in, or the reason why there is none. */
export type Server =
  | { kind: "program"; path: string; version: string; from: "assur.path" | "PATH" }
  | { kind: "built in"; version: string; why: string; warning?: boolean }
  | { kind: "none"; problem: string };

/** The part of a version that must be equal: major and minor. */
export function series(version: string): string {
  return version.split(".").slice(0, 2).join(".");
}
