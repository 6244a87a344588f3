// SPDX-License-Identifier: MIT
// A live run: its web socket, the run that grows by it, and what the page asks of it.
import type { Head, RobotModel } from "./recording";
import { type Change, type LiveEvent, type LiveTick, Run } from "./run";

/** A number of a rule, with its meaning and bounds. */
export interface LiveNumber {
  path: string;
  value: string;
  table: string; // the rule table's own value
  help: string;
  kind: "number" | "whole" | "switch" | "text";
  lower?: number | null;
  upper?: number | null;
  lower_excluded?: boolean;
  acts_at_start: boolean;
}

export interface LiveFacts {
  label: string;
  folder: string;
  rule_tables: string[];
  species: string[];
  tags: number[];
  rules: Record<string, string>; // the policy of each slot that its table fills
  numbers: LiveNumber[];
  head: Head;
}

export interface LiveState {
  paused: boolean;
  speed: number; // 0: as fast as it goes
  over: boolean;
  steers: boolean;
  pages: number;
  name: string; // of its rules
  changes: Change[];
}

export interface LiveListener {
  begun: (live: Live) => void;
  grown: () => void;
  state: () => void;
  said: (sentence: string) => void;
}

type Message =
  | ({ kind: "run" } & LiveFacts)
  | { kind: "events"; events: LiveEvent[] }
  | { kind: "bodies"; frame: number; bodies: RobotModel[]; set_down: [number, number][] }
  | ({ kind: "tick" } & LiveTick)
  | ({ kind: "state"; changes_from: number } & LiveState) // its changes from that one on
  | { kind: "refused"; text: string };

export class Live {
  readonly run: Run;
  private known: LiveState = { paused: false, speed: 10, over: false, steers: false, pages: 1, name: "", changes: [] };
  isConnected = true;

  constructor(readonly facts: LiveFacts, private readonly socket: WebSocket) {
    const { label, species, tags, rules } = facts;
    this.run = Run.growing({ label, status: "live", species, tags, rules }, facts.head);
  }

  get state(): LiveState {
    return this.known;
  }
  set state(state: LiveState) {
    this.known = state;
    Object.assign(this.run.index, { name: state.name, changes: state.changes });
  }
  /** A state has the run's changes from a number on: those that this page has not seen. */
  hear(state: LiveState & { changes_from: number }): void {
    this.state = { ...state, changes: [...this.changes.slice(0, state.changes_from), ...state.changes] };
  }
  get changes(): Change[] {
    return this.known.changes;
  }
  /** The values that changed parameters have now. */
  get changed(): Map<string, string> {
    return new Map(this.changes.map(({ number, value }) => [number, value]));
  }

  /** The newest moment of which robots are known. */
  get newest(): number {
    const { agents, recording } = this.run;
    return Math.min(recording.lastTime, (agents.firstTick + agents.ticks - 1) * recording.head.tick_s);
  }
  /** Whether something of it can be shown. */
  get isVisible(): boolean {
    return !this.run.recording.isEmpty && this.run.agents.ticks > 0;
  }

  play(playing: boolean): void {
    this.ask({ do: playing ? "play" : "pause" });
  }
  tick(): void {
    this.ask({ do: "tick" });
  }
  setSpeed(value: number): void {
    this.ask({ do: "speed", value });
  }
  set(number: string, value: string): void {
    this.ask({ do: "set", number, value });
  }
  restart(seed: number, rules: string): void {
    this.ask({ do: "restart", seed, rules });
  }
  private ask(wish: object): void {
    if (this.isConnected) this.socket.send(JSON.stringify(wish));
  }
}

/** Connects the page to its run. Each run that begins is a new `Live`. */
export function connect(listener: LiveListener): void {
  const socket = new WebSocket(`ws://${location.host}/live${location.search}`);
  socket.binaryType = "arraybuffer";
  let live: Live | null = null;
  let isShown = false;
  const grow = (): void => {
    if (!live?.isVisible) return;
    if (!isShown) {
      isShown = true;
      listener.begun(live);
    }
    listener.grown();
  };
  const take = (message: Message): void => {
    if (message.kind === "run") {
      const before = live?.state;
      live = new Live(message, socket);
      if (before) live.state = { ...before, over: false, name: message.head.rule_table, changes: [] };
      isShown = false;
      return;
    }
    if (message.kind === "refused") return listener.said(message.text); // also before a run
    if (!live) return;
    switch (message.kind) {
      case "events":
        live.run.addEvents(message.events);
        return grow();
      case "bodies":
        live.run.recording.bodies.push(...message.bodies);
        return live.run.recording.setDown(message.frame, message.set_down);
      case "tick":
        live.run.addTick(message);
        return grow();
      case "state":
        live.hear(message);
        return listener.state();
    }
  };
  socket.addEventListener("message", ({ data }: MessageEvent<string | ArrayBuffer>) => {
    if (typeof data === "string") take(JSON.parse(data) as Message);
    else live?.run.recording.append(new Uint8Array(data));
  });
  socket.addEventListener("close", () => {
    if (live) live.isConnected = false;
    listener.said("The program has ended. The page still shows the run, and its folder has the files.");
    listener.state();
  });
}
