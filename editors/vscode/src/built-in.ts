// The client's side of the server that is built in: its thread, and messages to and from it.

import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { promisify } from "node:util";
import { Worker } from "node:worker_threads";
import { brotliDecompress } from "node:zlib";
import { AbstractMessageReader, AbstractMessageWriter, type DataCallback, type Disposable, type Message } from "vscode-jsonrpc/node";
import type { Reply, Start } from "./worker";

/** A message may take that long, in ms; then the thread is ended, and the client starts another. */
const PATIENCE = 5000;

class Reader extends AbstractMessageReader {
  private take: DataCallback | undefined;
  private early: Message[] = [];

  listen(take: DataCallback): Disposable {
    this.take = take;
    this.early.splice(0).forEach(take);
    return { dispose: () => (this.take = undefined) };
  }

  bring(message: Message): void {
    if (this.take) this.take(message);
    else this.early.push(message);
  }

  close(): void {
    this.fireClose();
  }
}

class Writer extends AbstractMessageWriter {
  constructor(
    private readonly send: (message: Message) => void,
    private readonly stop: () => void,
  ) {
    super();
  }

  async write(message: Message): Promise<void> {
    this.send(message);
  }

  end(): void {
    this.stop();
  }

  override dispose(): void {
    super.dispose();
    this.stop();
  }
}

/** The server of a package, ready to run. */
export async function load(folder: string): Promise<WebAssembly.Module> {
  const packed = await readFile(join(folder, "assur.wasm.br"));
  return WebAssembly.compile((await promisify(brotliDecompress)(packed)) as BufferSource);
}

/** Runs it in a thread; `ended` gets the reason if it ends before its time. */
export function run(folder: string, module: WebAssembly.Module, ended: (why: string) => void): { reader: Reader; writer: Writer } {
  const thread = new Worker(join(folder, "worker.js"));
  const sent = new Int32Array(new SharedArrayBuffer(4));
  let count = 0;
  let watch: ReturnType<typeof setTimeout> | undefined;
  let isOver = false;

  const stop = (): void => {
    isOver = true;
    clearTimeout(watch);
    void thread.terminate();
  };
  const fail = (why: string): void => {
    if (isOver) return;
    stop();
    ended(why);
    reader.close();
  };
  const wait = (): void => {
    watch = setTimeout(() => fail(`It did not answer within ${PATIENCE / 1000} s.`), PATIENCE);
  };
  const reader = new Reader();
  const writer = new Writer((message) => {
    if (isOver) return;
    count += 1;
    Atomics.store(sent, 0, count);
    // as text: settings of VS Code cannot be cloned
    thread.postMessage(JSON.stringify(message));
    if (watch === undefined) wait();
  }, stop);

  thread.on("error", (error) => fail(String(error)));
  thread.on("message", (reply: Reply) => {
    if (isOver) return;
    if ("failed" in reply) return fail(reply.failed);
    clearTimeout(watch);
    watch = undefined;
    if (reply.done !== count) wait();
    reply.messages.forEach((message) => reader.bring(message as Message));
  });
  const start: Start = { module, sent };
  thread.postMessage(start);
  return { reader, writer };
}
