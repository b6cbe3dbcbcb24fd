// The host of the module, in a thread of its own: messages of the protocol in, messages out.

/** What the worker is given first. */
export interface Start {
  module: WebAssembly.Module;
  /** What a text may take, ms. */
  limit: number;
  /** The text took too long before: it is not solved until it changes. */
  rests: boolean;
}

/** What comes back. */
export interface Reply {
  /** As texts: the page copies and reads a long one faster. */
  messages: string[];
  /** A message of the page was answered; else this came from a pause. */
  answered: boolean;
  /** More comes by itself: a text is to be solved. */
  more: boolean;
  /** The text was given up, or has more positions than are solved here. */
  late: boolean;
  failed?: string;
}

interface Exports {
  memory: WebAssembly.Memory;
  reserve(length: number): number;
  free(at: number, length: number): void;
  handle(at: number, length: number): number;
}

/** The notification of a text that is solved. */
const SOLVED = "assur/solved";
const PUBLISH = '{"jsonrpc":"2.0","method":"assur/publish"}';
const SOLVE = '{"jsonrpc":"2.0","method":"assur/solve"}';
/** From the last key to solving; while keys come a text is solved no longer than this; a rest of the author; ms. */
const PAUSE = 16, SHORT = 100, REST = 500;

let exports: Exports | undefined;
let limit = 5000, rests = false, begun = 0, changed = 0, later = false, late = false;
let timer: ReturnType<typeof setTimeout> | undefined;

/** Asked again and again while a text is solved: 1 as its author still types, 2 as it takes too long. */
function stop(): number {
  const spent = performance.now() - begun;
  late = spent > limit;
  later = !late && spent > SHORT && performance.now() - changed < REST;
  return late ? 2 : later ? 1 : 0;
}

function answers({ memory, reserve, free, handle }: Exports, message: string): object[] {
  const bytes = new TextEncoder().encode(message);
  const at = reserve(bytes.length) >>> 0;
  new Uint8Array(memory.buffer, at, bytes.length).set(bytes);
  begun = performance.now();
  later = late = false;
  const back = handle(at, bytes.length) >>> 0;
  const length = new DataView(memory.buffer).getUint32(back, true);
  const text = new TextDecoder().decode(new Uint8Array(memory.buffer, back + 4, length));
  free(back, length + 4);
  return JSON.parse(text) as object[];
}

function answer(message: string, answered: boolean, more: () => boolean, unsolved: (messages: object[]) => boolean = () => false): void {
  if (exports === undefined) return;
  try {
    const messages = answers(exports, message);
    const again = more();
    postMessage({ messages: messages.map((one) => JSON.stringify(one)), answered, more: again, late: late || (!again && unsolved(messages)) } satisfies Reply);
  } catch (error) {
    // an error of the module ends it: its memory is not to be trusted any more
    exports = undefined;
    postMessage({ messages: [], answered, more: false, late: false, failed: String(error) } satisfies Reply);
  }
}

function solve(): void {
  timer = undefined;
  answer(SOLVE, false, () => later, (messages) => !messages.some((one) => "method" in one && one.method === SOLVED));
  if (later) timer = setTimeout(solve, Math.max(REST - (performance.now() - changed), 1));
}

function publish(): void {
  timer = undefined;
  answer(PUBLISH, false, () => !rests);
  if (!rests) timer = setTimeout(solve, PAUSE);
}

onmessage = ({ data }: MessageEvent<Start | string>) => {
  if (typeof data !== "string") {
    ({ limit, rests } = data);
    exports = new WebAssembly.Instance(data.module, { assur: { stop } }).exports as unknown as Exports;
    return;
  }
  const is = (method: string) => data.includes(`"method":"textDocument/${method}"`);
  const opens = is("didChange") || is("didOpen");
  answer(data, true, () => opens || timer !== undefined);
  if (!opens) return;
  if (is("didChange")) rests = false;
  changed = performance.now();
  clearTimeout(timer);
  // a message to itself: changes that have come already are taken first
  timer = setTimeout(publish, 0);
};
