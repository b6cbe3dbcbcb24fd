// The pages of diagnostics, as documents that cannot be changed.

import { Uri, commands } from "vscode";
import type { BaseLanguageClient } from "vscode-languageclient/node";

/** The scheme of their addresses. */
export const PAGES = "assur-page";

/** Shows the page of a code next to the text. */
export async function showPage(code: string): Promise<void> {
  await commands.executeCommand("markdown.showPreviewToSide", Uri.from({ scheme: PAGES, path: `${code}.md` }));
}

/** What is on a page. */
export async function pageOf(client: BaseLanguageClient | undefined, uri: Uri): Promise<string | undefined> {
  // false: it is shown here and not as a message
  const asked = { command: "assur.explain", arguments: [uri.path.replace(/\.md$/, ""), false] };
  return client?.sendRequest<string>("workspace/executeCommand", asked);
}
