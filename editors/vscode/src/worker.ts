// The language server in WebAssembly, in a thread of its own.

import { parentPort, type MessagePort } from "node:worker_threads";

/** What the thread is given first. */
export interface Start {
  module: WebAssembly.Module;
  /** Counts the messages that were sent: one that waits is seen while a text is solved. */
  sent: Int32Array;
}

/** What comes back: how many messages are done, and what they brought; or why the server ended. */
export type Reply = { done: number; messages: object[] } | { failed: string };

interface Exports {
  memory: WebAssembly.Memory;
  reserve(length: number): number;
  free(at: number, length: number): void;
  handle(at: number, length: number): number;
}

/** No message waits; the author pauses. */
const PUBLISH = JSON.stringify({ jsonrpc: "2.0", method: "assur/publish" });
const SOLVE = JSON.stringify({ jsonrpc: "2.0", method: "assur/solve" });
/** A pause of the author before a text is solved, in ms. */
const PAUSE = 50;
/** What a text may take to be solved, in ms. */
const LONGEST = 2000;

function serve(port: MessagePort): void {
  let exports: Exports | undefined;
  let sent: Int32Array = new Int32Array(1);
  let done = 0;
  let begun = 0;
  let timer: ReturnType<typeof setTimeout> | undefined;

  /** Asked again and again while a text is solved: 1 as a message waits, 2 as it takes too long. */
  const stop = (): number => (Atomics.load(sent, 0) !== done ? 1 : Date.now() - begun > LONGEST ? 2 : 0);
  const post = (reply: Reply): void => port.postMessage(reply);

  function handle({ memory, reserve, free, handle }: Exports, message: string): object[] {
    const bytes = new TextEncoder().encode(message);
    const at = reserve(bytes.length) >>> 0;
    new Uint8Array(memory.buffer, at, bytes.length).set(bytes);
    begun = Date.now();
    const back = handle(at, bytes.length) >>> 0;
    const length = new DataView(memory.buffer).getUint32(back, true);
    const text = new TextDecoder().decode(new Uint8Array(memory.buffer, back + 4, length));
    free(back, length + 4);
    return JSON.parse(text) as object[];
  }

  function answer(message: string): void {
    if (exports === undefined) return;
    try {
      post({ done, messages: handle(exports, message) });
    } catch (error) {
      // an error of the server ends it: its memory is not to be trusted any more
      exports = undefined;
      post({ failed: String(error) });
    }
  }

  function pause(): void {
    answer(PUBLISH);
    timer = setTimeout(() => answer(SOLVE), PAUSE);
  }

  port.on("message", (message) => {
    if (exports === undefined) {
      const start = message as Start;
      sent = start.sent;
      exports = new WebAssembly.Instance(start.module, { assur: { stop } }).exports as unknown as Exports;
      return;
    }
    done += 1;
    clearTimeout(timer);
    answer(message as string);
    timer = setTimeout(pause, 0);
  });
}

if (parentPort) serve(parentPort);
