// <assur-mech>: a mechanism that moves in a page. Its text is inside, or at the address `src`; without a script it stands there as text.

import { encode } from "../src/link";

/** The folder of the playground: this script is in its `embed`. */
const HOME = new URL("../", import.meta.url);
/** The attributes that the playground understands. */
const PASSED = ["text", "edit", "part"];

class Mech extends HTMLElement {
  private frame: HTMLIFrameElement | undefined;

  connectedCallback(): void {
    if (this.frame === undefined) void this.show();
    addEventListener("message", this.fit);
  }

  disconnectedCallback(): void {
    removeEventListener("message", this.fit);
  }

  private async show(): Promise<void> {
    const source = this.getAttribute("src");
    const text = source === null ? unindented(this.textContent ?? "") : await (await fetch(source)).text();
    const address = new URL("index.html", HOME);
    const query = ["embed", ...PASSED.filter((name) => this.hasAttribute(name)).map((name) => `${name}=${encodeURIComponent(this.getAttribute(name) ?? "")}`)];
    address.search = query.join("&");
    address.hash = await encode(text, VERSION);
    const frame = document.createElement("iframe");
    frame.src = address.href;
    frame.loading = "lazy";
    frame.title = this.getAttribute("title") ?? "assur";
    frame.style.cssText = "width:100%;height:22rem;border:0;color-scheme:normal";
    this.frame = frame;
    this.replaceChildren(frame);
  }

  /** The playground inside says how high it is; nobody else is listened to. */
  private readonly fit = (event: MessageEvent): void => {
    if (event.source !== this.frame?.contentWindow || event.origin !== HOME.origin) return;
    const height = (event.data as { assur?: unknown }).assur;
    if (this.frame && typeof height === "number" && height > 0) this.frame.style.height = `${Math.min(height, 4000)}px`;
  };
}

/** A text without the blanks that its page puts before every line. */
function unindented(text: string): string {
  const lines = text.replace(/^\s*\n/, "").trimEnd().split("\n");
  const blanks = lines.filter((line) => line.trim() !== "").map((line) => line.length - line.trimStart().length);
  const least = Math.min(...blanks, 80);
  return lines.map((line) => line.slice(least)).join("\n") + "\n";
}

customElements.define("assur-mech", Mech);
