// A text as a link: `#1/VERSION/DATA`, format 1, the version that made it, base64url of the deflated text. No page here.

/** What a link may unfold to, bytes. */
const MOST = 1 << 20;

export type Link =
  | { kind: "text"; text: string; version: string }
  | { kind: "example"; name: string }
  | { kind: "newer" }
  | { kind: "broken" }
  | { kind: "none" };

export async function encode(text: string, version: string): Promise<string> {
  const packed = new Blob([text]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(packed).arrayBuffer());
  let letters = "";
  for (const byte of bytes) letters += String.fromCharCode(byte);
  return `#1/${version}/${btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`;
}

export async function decode(hash: string): Promise<Link> {
  const inner = hash.replace(/^#/, "");
  if (inner === "") return { kind: "none" };
  const example = /^x\/([\w/.-]+)$/.exec(inner);
  if (example) return { kind: "example", name: example[1] };
  const parts = /^(\d+)\/([\w.+-]{1,40})\/([\w-]*)$/.exec(inner);
  if (!parts) return { kind: "broken" };
  const [, format, version, data] = parts;
  if (format !== "1") return Number(format) > 1 ? { kind: "newer" } : { kind: "broken" };
  try {
    return { kind: "text", version, text: await unfolded(data) };
  } catch {
    return { kind: "broken" };
  }
}

async function unfolded(data: string): Promise<string> {
  const letters = atob(data.replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw")).getReader();
  const pieces: Uint8Array<ArrayBuffer>[] = [];
  for (let length = 0; ; ) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > MOST) {
      void reader.cancel();
      throw new Error("too long");
    }
    pieces.push(value);
  }
  return new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(await new Blob(pieces).arrayBuffer());
}
