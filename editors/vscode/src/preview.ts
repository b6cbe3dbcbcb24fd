// The mechanism in motion, next to its text: the page of the server's command `assur.preview`.

import { UIKind, Uri, ViewColumn, commands, env, window } from "vscode";
import type { LanguageClient } from "vscode-languageclient/node";

/** Opens the page of the file in front in an editor to the side. */
export async function openPreview(client: LanguageClient | undefined): Promise<void> {
  const document = window.activeTextEditor?.document;
  if (document?.languageId !== "mech" || client === undefined) {
    void window.showInformationMessage("Open a .mech file first.");
    return;
  }
  const uri = client.code2ProtocolConverter.asUri(document.uri);
  // false: it is shown here and not in a browser
  const asked = { command: "assur.preview", arguments: [uri, false] };
  const { address } = await client.sendRequest<{ address: string }>("workspace/executeCommand", asked);
  const page = Uri.parse(address);
  // of another machine the port is forwarded; servers of VS Code in a browser would lose the key
  const shown = env.uiKind === UIKind.Desktop ? await env.asExternalUri(page) : page;
  await commands.executeCommand("simpleBrowser.api.open", shown, { viewColumn: ViewColumn.Beside, preserveFocus: true });
}
