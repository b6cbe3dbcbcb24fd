// Where the module and the worker are: beside the page, or in it where it is one file.

/** Data in the page, in base64. */
function inside(id: string): Uint8Array<ArrayBuffer> | undefined {
  const text = document.getElementById(id)?.textContent;
  return text ? Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0)) : undefined;
}

/** The module, compiled while it comes. Servers of files send `.wasm` as it is: five megabytes; so it is packed here. */
export async function module(): Promise<WebAssembly.Module> {
  const own = inside("assur-module");
  const packed = own ? new Blob([own]).stream() : await fetched("assur.wasm.gz");
  const plain = packed.pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compileStreaming(new Response(plain, { headers: { "Content-Type": "application/wasm" } }));
}

async function fetched(address: string): Promise<ReadableStream<Uint8Array<ArrayBuffer>>> {
  const answer = await fetch(address);
  if (!answer.ok || answer.body === null) throw new Error(`${address}: ${answer.status}`);
  return answer.body;
}

/** The examples, packed in the page or beside it. */
export async function listed(): Promise<unknown> {
  const own = inside("assur-examples");
  if (!own) return (await fetch("examples.json")).json();
  return new Response(new Blob([own]).stream().pipeThrough(new DecompressionStream("gzip"))).json();
}

export function addressOfWorker(): string {
  const own = document.getElementById("assur-worker")?.textContent;
  return own ? URL.createObjectURL(new Blob([own], { type: "text/javascript" })) : "worker.js";
}
