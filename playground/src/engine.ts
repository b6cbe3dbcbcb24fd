// The worker as the page sees it: messages go in and come out, the newest text wins, and nothing takes for ever.

import type { Transport } from "@codemirror/lsp-client";
import type { Reply, Start } from "./worker";

/** What a text may take, ms; what a newer text waits for a busy worker; beyond its limit a worker is ended. */
const LIMIT = 5000, WAIT = 250, GRACE = 500;

export interface Hooks {
  /** A new worker: the client connects again, which opens the newest text in it. */
  restarted(): void;
  /** The text takes too long. */
  late(): void;
  busy(on: boolean): void;
  failed(why: string): void;
}

export class Engine {
  private worker: Worker | undefined;
  private handlers: ((message: string) => void)[] = [];
  /** Messages that were sent and not answered; whether a text waits. */
  private open = 0;
  private limit = LIMIT;
  private patience: ReturnType<typeof setTimeout> | undefined;
  private wait: ReturnType<typeof setTimeout> | undefined;
  /** How often the module ended by an error of its own. */
  private ends = 0;

  constructor(
    private readonly module: WebAssembly.Module,
    private readonly address: string,
    private readonly hooks: Hooks,
  ) {
    this.start(false);
  }

  readonly transport: Transport = {
    send: (message) => this.send(message),
    subscribe: (handler) => void this.handlers.push(handler),
    unsubscribe: (handler) => void (this.handlers = this.handlers.filter((one) => one !== handler)),
  };

  /** Once more, with more time. */
  again(limit: number): void {
    this.limit = limit;
    this.restart(false);
  }

  /** A newer text: the limit is the usual one, and a worker that is busy with an older one is not waited for. */
  changed(): void {
    this.limit = LIMIT;
    if (this.patience !== undefined) this.wait ??= setTimeout(() => this.restart(false), WAIT);
  }

  private start(rests: boolean): void {
    const worker = new Worker(this.address);
    this.worker = worker;
    worker.onmessage = ({ data }: MessageEvent<Reply>) => {
      if (worker === this.worker) this.take(data);
    };
    worker.onerror = (event) => {
      if (worker === this.worker) this.broken(event.message);
    };
    worker.postMessage({ module: this.module, limit: this.limit, rests } satisfies Start);
  }

  private send(message: string): void {
    this.open += 1;
    this.works();
    this.worker?.postMessage(message);
  }

  /** From now on the worker is busy; every answer begins a new count. */
  private works(): void {
    clearTimeout(this.patience);
    this.patience = setTimeout(() => {
      this.hooks.late();
      this.restart(true);
    }, this.limit + GRACE);
    this.hooks.busy(true);
  }

  private take({ messages, answered, more, late, failed }: Reply): void {
    if (answered) this.open -= 1;
    clearTimeout(this.wait);
    this.wait = undefined;
    if (failed !== undefined) return this.broken(failed);
    if (this.open > 0 || more) this.works();
    else {
      clearTimeout(this.patience);
      this.patience = undefined;
      this.hooks.busy(false);
    }
    if (late) this.hooks.late();
    for (const message of messages) for (const handler of this.handlers) handler(message);
  }

  /** The module ended by an error of its own: its text is not solved again until it changes. */
  private broken(why: string): void {
    this.ends += 1;
    if (this.ends > 3) return this.hooks.failed(why);
    this.hooks.late();
    this.restart(true);
  }

  private restart(rests: boolean): void {
    clearTimeout(this.patience);
    clearTimeout(this.wait);
    this.patience = this.wait = undefined;
    this.open = 0;
    this.worker?.terminate();
    this.start(rests);
    this.hooks.restarted();
  }
}
