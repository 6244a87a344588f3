// SPDX-License-Identifier: MIT
// One run: its recording and its tables, and their contents at a moment.
import { fromBase64, inflate } from "./bytes";
import { Table } from "./csv";
import { Food } from "./food";
import type { Curves } from "./moments";
import { type Head, Recording } from "./recording";

/** A parameter that another value replaced during the run. */
export interface Change {
  time_s: number;
  number: string;
  value: string;
  before: string;
}

export interface RunIndex {
  label: string;
  /** Name of its rules: the table, and what differs from it. */
  name?: string;
  changes?: Change[];
  status: string;
  shadow?: boolean;
  species: string[];
  tags: number[];
  /** The policy of each slot that the rule table fills. */
  rules?: Record<string, string>;
  /** The requested stretch of time; the recording's blocks are longer. */
  from_s?: number;
  to_s?: number;
  /** The sensors whose values senses.csv has, in their order. */
  inputs?: string[];
}

/** A tick of a live run: a value a body. */
export interface LiveTick {
  tick: number;
  time_s: number;
  id: number[];
  species: number[];
  active: number[];
  tag: number[];
  x: number[];
  y: number[];
  angle: number[];
  adversary: (number | null)[];
  hunger: (number | null)[];
  /** In a world with energy, J. */
  energy?: number[];
  /** Outputs of brains, by act; null if a brain was not evaluated. */
  outputs?: Record<string, (number | null)[]>;
  /** In a world with energy: of each species, and of each food in each cell of the floor, J. */
  stock?: number[];
  foods?: Record<string, number[]>;
}

/** time, kind, id, body, species, cause, other, x, y, parents as an ancestor list, origin; of a catch its scene. */
export type LiveEvent = [number, string, number, number, number, string, number | null, number, number, string, string, Scene?];

/** The camera of a scene, as tools/trophic/replay/shot.hpp has it. */
export interface Shot {
  at_m: [number, number, number];
  azimuth_deg: number;
  elevation_deg: number;
  near_m: number;
  high_m: number;
  wide_m: number;
}

/** A catch to be played, as tools/trophic/replay/director.hpp has it. */
export interface Scene {
  time_s: number;
  begins_s: number;
  ends_s: number;
  still_s: number; // how long the catch itself is shown, seconds of the viewer
  individuals: [number, number]; // hunter and victim
  sentence: string;
  remark: string; // what the scene lacks; may be empty
  camera: Shot;
  reach_m?: number; // how close a victim must be
  opens?: boolean; // a page opens at it
}

export interface Event {
  time: number;
  kind: string;
  id: number;
  body: number;
  species: number;
  cause: string;
  other: number;
  x: number;
  y: number;
  parents: number[]; // of the event's individual; empty: a founder or an orphan
  origin: string;
  scene?: Scene; // of a catch
}

export interface Individual {
  id: number;
  species: number;
  parents: number[]; // the first is the one whose branch it belongs to; empty: a founder or an orphan
  birth: number;
  death: number; // Infinity: alive at the end
  cause: string;
  killer: number;
  origin: string;
  body: number;
  genome: string;
  mutation: number;
  traits: [string, string][]; // heritable ones: name with unit, value
  children: Individual[]; // of whom it is the first parent
  offspring: number; // of whom it is a parent
  row: number; // in the phylogeny's drawing
}

/** The contents of agents.csv: all bodies after each tick, in arrays of ticks times robots. A spare body has -1 as id and species. */
export class Agents {
  id = new Int32Array(0);
  species = new Int8Array(0);
  active = new Uint8Array(0);
  tag = new Int8Array(0);
  targetAngle = new Float32Array(0);
  adversary = new Int32Array(0); // -1: none
  hunger = new Float32Array(0); // NaN: has no prey
  energy = new Float32Array(0); // J; -1: not known
  line = new Int32Array(0); // rows of the file
  readonly extra = new Map<string, string[]>(); // by row of the file
  readonly outputs = new Map<string, Float32Array>(); // of brains in a live run, by act; NaN: not evaluated
  firstTick = 0;
  ticks = 0;

  constructor(readonly robots: number) {}

  static read(table: Table, robots: number, species: string[]): Agents {
    const names = new Map(species.map((name, index) => [name, index]));
    const agents = new Agents(robots);
    const ticks = table.numbers("tick");
    if (table.rows === 0) throw new Error("agents.csv has no tick");
    agents.firstTick = ticks[0];
    agents.ticks = ticks[table.rows - 1] - ticks[0] + 1;
    agents.reserve(agents.ticks * robots);
    const places = table.numbers("body").map((body, row) => (ticks[row] - ticks[0]) * robots + body);
    const fill = (column: Column, name: string, valueOf: (cell: string) => number = Number): void => {
      for (const [row, cell] of table.text(name).entries()) column[places[row]] = valueOf(cell);
    };
    fill(agents.id, "id");
    fill(agents.species, "species", (name) => names.get(name) ?? -1);
    fill(agents.active, "active");
    fill(agents.tag, "tag");
    fill(agents.targetAngle, "target_angle_rad");
    fill(agents.adversary, "adversary_id", (cell) => (cell === "" ? -1 : Number(cell)));
    fill(agents.hunger, "hunger_ticks", (cell) => (cell === "" ? NaN : Number(cell)));
    places.forEach((place, row) => (agents.line[place] = row));
    const known = ["tick", "body", "id", "species", "active", "tag", "target_angle_rad", "adversary_id", "hunger_ticks"];
    for (const name of table.names) if (!known.includes(name)) agents.extra.set(name, table.text(name));
    return agents;
  }

  /** Takes the columns of a table with the same ticks and bodies, such as states.csv. */
  addStates(table: Table): void {
    const columns = table.names.filter((name) => !["tick", "body"].includes(name));
    for (const name of columns) this.extra.set(name, []);
    const bodies = table.numbers("body");
    for (const [row, tick] of table.numbers("tick").entries()) {
      const line = this.line[(tick - this.firstTick) * this.robots + bodies[row]];
      for (const name of columns) this.extra.get(name)![line] = table.text(name)[row];
    }
  }

  /** Adds a tick; those that were left out before it are as the one before them. */
  append(tick: LiveTick): void {
    if (this.ticks === 0) this.firstTick = tick.tick;
    const { robots } = this;
    const wanted = tick.tick - this.firstTick + 1;
    if (wanted <= this.ticks) return;
    this.reserve(wanted * robots);
    for (; this.ticks > 0 && this.ticks < wanted - 1; ++this.ticks) {
      const to = this.ticks * robots;
      for (const column of [...columns.map((name) => this[name]), ...this.outputs.values()]) column.copyWithin(to, to - robots, to);
    }
    const at = (wanted - 1) * robots;
    this.id.set(tick.id, at);
    this.species.set(tick.species, at);
    this.active.set(tick.active, at);
    this.tag.set(tick.tag, at);
    this.targetAngle.set(tick.angle, at);
    this.adversary.set(tick.adversary.map((id) => id ?? -1), at);
    this.hunger.set(tick.hunger.map((ticks) => ticks ?? NaN), at);
    if (tick.energy) this.energy.set(tick.energy, at);
    for (const [act, values] of Object.entries(tick.outputs ?? {})) {
      const known = this.outputs.get(act) ?? new Float32Array(0);
      const column = known.length < this.id.length ? grown(known, this.id.length) : known;
      column.set(values.map((value) => value ?? NaN), at);
      this.outputs.set(act, column);
    }
    this.ticks = wanted;
  }

  private reserve(rows: number): void {
    if (rows <= this.id.length) return;
    const room = Math.max(rows, 2 * this.id.length);
    const wider = Object.fromEntries(columns.map((name) => [name, grown(this[name], room)]));
    Object.assign(this, wider);
  }
}

const columns = ["id", "species", "active", "tag", "targetAngle", "adversary", "hunger", "energy", "line"] as const;
type Column = Int32Array | Int8Array | Uint8Array | Float32Array;

/** A wider array with the values of `from` at its beginning, then -1. */
function grown<T extends Column>(from: T, room: number): T {
  const to = new (from.constructor as new (room: number) => T)(room).fill(-1) as T;
  to.set(from);
  return to;
}

/** The contents of senses.csv: all robots after each tick, row by row as the agents. */
export class Senses {
  constructor(private readonly table: Table, private readonly inputs: string[]) {}

  /** Inputs of the brain in a row: (sensor, value); empty if it was not evaluated. */
  told(row: number): [string, string][] {
    return this.inputs.map((name, i): [string, string] => [name, this.cell(`input${i}`, row)]).filter(([, value]) => value !== "");
  }

  /** Outputs of the brain in a row: (act, value), NaN if it was not evaluated. The column of the act turn is angle_output. */
  outputs(row: number): [string, number][] {
    const columns = this.table.names.filter((name) => name.endsWith("_output"));
    return columns.map((name) => [name === "angle_output" ? "turn" : name.slice(0, -"_output".length), parseFloat(this.cell(name, row))]);
  }

  /** A cell, or an empty text behind the table's end. */
  cell(name: string, row: number): string {
    return this.table.has(name) ? (this.table.text(name)[row] ?? "") : "";
  }
}

export class Run {
  readonly individuals = new Map<number, Individual>();
  readonly roots: Individual[] = [];
  readonly events: Event[] = [];
  /** In a world with energy. */
  energy: Curves | null = null;
  readonly foods: Food[] = [];
  /** x, y of every body at every tick of the agents; NaN until the recording has been read, but for newborns. */
  track: Float32Array;
  tracked = false;

  private constructor(readonly index: RunIndex, readonly recording: Recording, readonly agents: Agents, readonly senses: Senses | null) {
    this.track = new Float32Array(2 * agents.ticks * agents.robots).fill(NaN);
  }

  /** A live run: it grows by the `add` functions. */
  static growing(index: RunIndex, head: Head): Run {
    const run = new Run(index, new Recording(head), new Agents(head.robots), null);
    run.tracked = true;
    return run;
  }

  addTick(tick: LiveTick): void {
    const { agents, robots } = this;
    const before = agents.ticks;
    agents.append(tick);
    if (agents.ticks === before) return;
    const size = 2 * agents.ticks * robots;
    if (size > this.track.length) {
      const before = this.track;
      this.track = new Float32Array(Math.max(size, 2 * before.length)).fill(NaN);
      this.track.set(before);
    }
    for (let body = 0; body < robots; ++body) {
      const at = size - 2 * robots + 2 * body;
      this.track[at] = tick.x[body];
      this.track[at + 1] = tick.y[body];
      this.joinTrack(body, before);
    }
    if (tick.stock) this.addEnergy(tick.time_s, tick.stock);
    for (const [name, cells] of Object.entries(tick.foods ?? {})) this.addFood(name, tick.time_s, cells);
  }

  /** Fills the ticks from number `from` on that a fast run left out, up to the last one, if the body's individual is the same. */
  private joinTrack(body: number, from: number): void {
    const { agents, robots, track } = this;
    const [first, last] = [from - 1, agents.ticks - 1];
    if (first < 0 || agents.id[first * robots + body] !== agents.id[last * robots + body]) return;
    for (const axis of [0, 1]) {
      const [a, b] = [first, last].map((tick) => track[2 * (tick * robots + body) + axis]);
      for (let tick = from; tick < last; ++tick) track[2 * (tick * robots + body) + axis] = a + ((b - a) * (tick - first)) / (last - first);
    }
  }

  private addEnergy(time: number, bySpecies: ArrayLike<number>): void {
    this.energy ??= { time: [], bySpecies: this.index.species.map(() => []) };
    this.energy.time.push(time);
    this.energy.bySpecies.forEach((curve, species) => curve.push(bySpecies[species]));
  }

  private addFood(name: string, time: number, cells: ArrayLike<number>): void {
    let food = this.foods.find((one) => one.name === name);
    if (!food) this.foods.push((food = new Food(name)));
    food.add(time, cells);
  }

  /** Adds the rows of field.csv: at each moment the cells of one food after another. */
  private addFoods(table: Table): void {
    const names = table.has("food") ? table.text("food") : [];
    for (const [time, cells] of Run.moments(table, "food_J")) {
      for (let from = 0, to = 0; from < cells.length; from = to) {
        while (to < cells.length && names[to] === names[from]) ++to;
        this.addFood(names[from] ?? "food", time, cells.subarray(from, to));
      }
    }
  }

  /** Rows of a table of a world with energy, moment by moment. */
  private static *moments(table: Table, name: string): Generator<[number, Float64Array]> {
    const time = table.numbers("time_s");
    const values = table.numbers(name);
    const first = time.findIndex((one) => one !== time[0]);
    const each = first < 0 ? table.rows : first;
    for (let row = 0; each > 0 && row + each <= table.rows; row += each) yield [time[row], values.subarray(row, row + each)];
  }

  addEvents(events: LiveEvent[]): void {
    for (const [time, kind, id, body, species, cause, other, x, y, ancestors, origin, scene] of events) {
      const event: Event = { time, kind, id, body, species, cause, other: other ?? NaN, x, y, parents: idsIn(ancestors), origin, scene };
      this.events.push(event);
      const one = this.individuals.get(id);
      if (kind === "birth" && !one) {
        const born = bornOf(event);
        this.individuals.set(id, born);
        this.place(born);
      }
      if (kind === "death" && one) Object.assign(one, { death: time, cause, killer: event.other });
    }
  }

  private place(born: Individual): void {
    (this.individuals.get(born.parents[0])?.children ?? this.roots).push(born);
    for (const id of born.parents) {
      const parent = this.individuals.get(id);
      if (parent) ++parent.offspring;
    }
  }

  private readTraits(table: Table): void {
    const names = table.names.filter((name) => name !== "id");
    table.numbers("id").forEach((id, row) => {
      const one = this.individuals.get(id);
      if (one) one.traits = names.map((name) => [name, table.text(name)[row]]);
    });
  }

  private readTables(events: Table, phylogeny: Table, scenes: Scene[]): void {
    const names = new Map(this.index.species.map((name, i) => [name, i]));
    const time = events.numbers("time_s");
    const id = events.numbers("id");
    const body = events.numbers("body");
    const killer = events.numbers("killer_id");
    const victim = events.numbers("victim_id");
    const x = events.numbers("x_m");
    const y = events.numbers("y_m");
    const species = events.text("species");
    const cause = events.text("cause");
    const parent = events.text("parent_id");
    const origin = events.text("origin");
    events.text("event").forEach((kind, i) => {
      const other = kind === "catch" ? victim[i] : killer[i];
      this.events.push({ time: time[i], kind, id: id[i], body: body[i], species: names.get(species[i]) ?? -1, cause: cause[i], other, x: x[i], y: y[i], parents: idsIn(parent[i]), origin: origin[i] });
    });
    this.catches.forEach((event, i) => (event.scene = scenes[i]));
    this.readPhylogeny(phylogeny, names);
  }

  /** Whether its robots show tags that tell them apart. */
  get hasTags(): boolean {
    return this.index.tags.length > 1;
  }
  /** Whether its rule table fills one of some slots. */
  fills(...slots: string[]): boolean {
    const { rules } = this.index;
    return rules === undefined || slots.some((slot) => slot in rules);
  }

  /** When the last member of a species died; Infinity if some live, or none ever did. */
  diedOut(species: number): number {
    let last = -Infinity;
    for (const one of this.individuals.values()) if (one.species === species) last = Math.max(last, one.death);
    return last === -Infinity ? Infinity : last;
  }

  get changes(): Change[] {
    return this.index.changes ?? [];
  }
  get catches(): Event[] {
    return this.events.filter(({ kind }) => kind === "catch");
  }

  private readPhylogeny(table: Table, names: Map<string, number>): void {
    const id = table.numbers("id");
    const ancestors = table.text("ancestor_list");
    const birth = table.numbers("origin_time");
    const death = table.text("destruction_time");
    const species = table.text("species");
    const cause = table.text("cause_of_death");
    const killer = table.numbers("killer_id");
    const origin = table.text("origin");
    const body = table.numbers("body");
    const genome = table.text("genome_id");
    const mutation = table.numbers("mutation_distance");
    for (let i = 0; i < table.rows; ++i) {
      this.individuals.set(id[i], {
        id: id[i],
        species: names.get(species[i]) ?? -1,
        parents: idsIn(ancestors[i]),
        birth: birth[i],
        death: death[i] === "inf" || death[i] === "" ? Infinity : Number(death[i]),
        cause: cause[i],
        killer: killer[i],
        origin: origin[i],
        body: body[i],
        genome: genome[i],
        mutation: mutation[i],
        traits: [],
        children: [],
        offspring: 0,
        row: 0,
      });
    }
    // Individuals with a birth but without a row lived when the run was interrupted.
    for (const event of this.events) {
      if (event.kind === "birth" && !this.individuals.has(event.id)) this.individuals.set(event.id, bornOf(event));
    }
    const inOrder = [...this.individuals.values()].sort((a, b) => a.birth - b.birth || a.id - b.id);
    for (const one of inOrder) this.place(one);
  }

  get firstTime(): number {
    return Math.max(this.recording.firstTime, this.index.from_s ?? -Infinity);
  }
  get lastTime(): number {
    return Math.min(this.recording.lastTime, this.index.to_s ?? Infinity);
  }
  get robots(): number {
    return this.recording.head.robots;
  }

  /** Index of a moment's tick in the agents' arrays. */
  rowAt(time: number): number {
    const tick = Math.floor(time / this.recording.head.tick_s + 1e-9) - this.agents.firstTick;
    return Math.min(this.agents.ticks - 1, Math.max(0, tick)) * this.robots;
  }

  /** Whether an element of the agents is of one who was born at its tick. */
  isNew(at: number): boolean {
    return at >= this.robots && this.agents.id[at] !== this.agents.id[at - this.robots];
  }

  /** The body of an individual at a moment; -1 if it does not live. */
  bodyOf(id: number, time: number): number {
    const row = this.rowAt(time);
    const one = this.individuals.get(id);
    if (one && this.agents.id[row + one.body] === id) return one.body;
    for (let body = 0; body < this.robots; ++body) if (this.agents.id[row + body] === id) return body;
    return -1;
  }

  /** Reads the whole recording once for the tracks; calls `pause` with the share that was read, 0 to 1. */
  async readTracks(pause: (part: number) => Promise<void>): Promise<void> {
    const { head } = this.recording;
    const robots = this.robots;
    await this.recording.forEachBlock((values, first, frames) => {
      for (let frame = first; frame < first + frames; ++frame) {
        if (frame % head.frames_per_tick !== 0) continue;
        const tick = Math.round(head.first_time_s / head.tick_s) + frame / head.frames_per_tick - this.agents.firstTick;
        if (tick < 0 || tick >= this.agents.ticks) continue;
        for (let robot = 0; robot < robots; ++robot) {
          const at = 2 * (tick * robots + robot);
          if (!Number.isNaN(this.track[at])) continue;
          this.track[at] = values[robot * frames + frame - first] * head.units.position_m;
          this.track[at + 1] = values[(robots + robot) * frames + frame - first] * head.units.position_m;
        }
      }
    }, pause);
    this.tracked = true;
  }

  /** The recording's frame of a birth's tick shows who lived in the body before. */
  private placeNewborns(): void {
    for (const { kind, time, id, body, x, y } of this.events) {
      const at = this.rowAt(time) + body;
      if (kind === "birth" && this.isNew(at) && this.agents.id[at] === id) this.track.set([x, y], 2 * at);
    }
  }

  /** Reads run number `number` from the page. */
  static async open(index: RunIndex, number: number): Promise<Run> {
    const find = (file: string): Element | null => document.querySelector(`script[data-run="${number}"][data-file="${file}"]`);
    const isIn = (file: string): boolean => find(file) !== null;
    const bytes = (file: string): Uint8Array => {
      const element = find(file);
      if (!element) throw new Error(`run ${index.label} lacks ${file}`);
      const found = fromBase64(element.textContent!.trim());
      element.remove();
      return found;
    };
    const text = async (file: string): Promise<string> => new TextDecoder().decode(await inflate(bytes(file)));
    const table = async (file: string): Promise<Table> => new Table(await text(file));
    const replay = bytes("replay");
    const isPlain = replay[0] === Recording.firstByte; // else compressed, as bodies are long
    const recording = Recording.read(isPlain ? replay : await inflate(replay));
    const [agents, events, phylogeny] = await Promise.all([table("agents"), table("events"), table("phylogeny")]);
    const senses = index.inputs ? new Senses(await table("senses"), index.inputs) : null;
    await recording.prepare(recording.firstFrame);
    const run = new Run(index, recording, Agents.read(agents, recording.head.robots, index.species), senses);
    run.readTables(events, phylogeny, JSON.parse(await text("scenes")) as Scene[]);
    run.placeNewborns();
    if (isIn("states")) run.agents.addStates(await table("states"));
    if (isIn("traits")) run.readTraits(await table("traits"));
    for (const [time, stock] of isIn("energy") ? Run.moments(await table("energy"), "stock_J") : []) run.addEnergy(time, stock);
    if (isIn("food")) run.addFoods(await table("food"));
    return run;
  }
}

/** An individual of which only the birth is known. */
function bornOf({ id, species, parents, time, origin, body }: Event): Individual {
  return { id, species, parents, birth: time, death: Infinity, cause: "", killer: NaN, origin, body, genome: "", mutation: NaN, traits: [], children: [], offspring: 0, row: 0 };
}

/** The ids in an ancestor list: "[none]", "[7]" or "[7,9]". */
function idsIn(list: string): number[] {
  return (list.match(/\d+/g) ?? []).map(Number);
}
