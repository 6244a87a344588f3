// SPDX-License-Identifier: MIT
// replay.trp, as docs/recording.md describes it.
import { inflate } from "./bytes";

export interface BoxShape {
  part: string;
  half_extents_m: number[];
  centre_m: number[];
  orientation: number[];
}
export interface LinkShape {
  name: string;
  parent: number;
  offset_m: number[];
  rotation: number[];
  boxes: BoxShape[];
  hinge?: { name: string; axis: number[] };
}
export interface RobotModel {
  name: string;
  forward_rad: number;
  bounding_radius_m: number;
  links: LinkShape[];
}
export interface Head {
  version: number;
  fingerprint: string;
  seed: number;
  rule_table: string;
  backend: string;
  species: string[];
  first_time_s: number;
  tick_s: number;
  clock_scale: number;
  frames_per_tick: number;
  steps_per_tick: number;
  robots: number;
  joints: number;
  units: { position_m: number; yaw_rad: number; tilt_rad: number; joint_rad: number };
  robot: RobotModel;
  arena: {
    name: string;
    half_side_m: number;
    extent_m: number;
    height_field?: { nodes: number; half_extent_m: number; height_m: number[] };
    obstacles?: number[][]; // of each: x and y of both ends of its axis, radius, height
    zones?: { name: string; x_m: number; y_m: number; radius_m: number }[];
  };
}

interface Block {
  first: number;
  frames: number;
  channels: number;
  bytes: Uint8Array;
  values?: Int16Array;
  waiting?: Promise<Int16Array>;
}

const poseChannels = 6;
/** Version of recordings whose robots have bodies of their own. */
const versionOfBodies = 2;

export class Recording {
  /** The bodies, by their numbers; one for all robots unless bodies differ. */
  readonly bodies: RobotModel[];
  /** For each robot whose body differs from others': the frames before which a body was set down, and its number. */
  private readonly setDowns: { frame: number; body: number }[][] = [];
  private readonly blocks: Block[] = [];
  private kept: Block[] = [];
  private before = new Float32Array(7);
  private after = new Float32Array(7);

  /** For a live run: `append` adds its frames. */
  constructor(readonly head: Head) {
    this.bodies = this.bodiesDiffer ? [] : [head.robot];
    for (let robot = 0; this.bodiesDiffer && robot < head.robots; ++robot) this.setDowns.push([]);
  }

  get bodiesDiffer(): boolean {
    return this.head.version === versionOfBodies;
  }

  /** Robots (robot, body) that were set down before a frame. */
  setDown(frame: number, pairs: [number, number][]): void {
    for (const [robot, body] of pairs) {
      if (!this.setDowns[robot] || !this.bodies[body]) throw new Error("this recording names a robot or body that it lacks");
      this.setDowns[robot].push({ frame, body });
    }
  }

  /** The last time that a robot was set down, at or before a frame. */
  private lastSetDown(frame: number, robot: number): { frame: number; body: number } {
    const all = this.setDowns[robot];
    let low = 0;
    let high = all.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (all[middle].frame <= frame) low = middle;
      else high = middle - 1;
    }
    return all[low];
  }

  /** The number of a robot's body at a frame. */
  bodyAt(frame: number, robot: number): number {
    return this.bodiesDiffer ? (this.lastSetDown(frame, robot)?.body ?? 0) : 0;
  }

  /** That of the file. */
  static readonly firstByte = 0x89;

  /** Throws for bytes that are not a recording. */
  static read(bytes: Uint8Array): Recording {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    if (bytes[0] !== Recording.firstByte || String.fromCharCode(...bytes.subarray(1, 4)) !== "TRP") throw new Error("replay.trp is not a recording");
    let head: Head | undefined;
    let recording: Recording | undefined;
    const numbers = (data: Uint8Array): number[] => {
      const words = new DataView(data.buffer, data.byteOffset, data.byteLength);
      return Array.from({ length: data.length >> 2 }, (_, i) => words.getUint32(4 * i, true));
    };
    for (let at = 8; at + 12 <= bytes.length; ) {
      const size = view.getUint32(at, true);
      if (at + 12 + size > bytes.length) break;
      const kind = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
      const data = bytes.subarray(at + 8, at + 8 + size);
      const json = (): unknown => JSON.parse(new TextDecoder().decode(data));
      if (kind === "HEAD") {
        head = { ...head, ...(json() as Head) };
        if (recording) Object.assign(recording.head, head);
        else recording = new Recording(head);
      } else if (recording && kind === "BODY") {
        recording.bodies.push(json() as RobotModel);
      } else if (recording && kind === "WHO ") {
        const [frame, ...rest] = numbers(data);
        recording.setDown(frame, rest.flatMap((robot, i): [number, number][] => (i % 2 === 0 ? [[robot, rest[i + 1]]] : [])));
      } else if (recording && kind === "POSE") {
        recording.append(data);
      }
      at += 12 + size;
    }
    if (!recording || recording.isEmpty) throw new Error("this recording has no frames");
    return recording;
  }

  /** Adds a block: its first frame, its number of frames, of channels if bodies differ, then the frames. */
  append(block: Uint8Array): void {
    const view = new DataView(block.buffer, block.byteOffset, block.byteLength);
    const channels = this.bodiesDiffer ? view.getUint32(8, true) : poseChannels + this.head.joints;
    this.blocks.push({ first: view.getUint32(0, true), frames: view.getUint32(4, true), channels, bytes: block.subarray(this.bodiesDiffer ? 12 : 8) });
    const size = 1 + channels; // a quaternion has four numbers, its channels three
    if (size > this.before.length) {
      this.before = new Float32Array(size);
      this.after = new Float32Array(size);
    }
  }

  /** Numbers of a pose: position, orientation and joint angles. */
  get poseSize(): number {
    return this.before.length;
  }

  get isEmpty(): boolean {
    return this.blocks.length === 0;
  }
  get firstFrame(): number {
    return this.blocks[0].first;
  }
  /** The number of the last frame, plus one. */
  get frames(): number {
    const last = this.blocks[this.blocks.length - 1];
    return last.first + last.frames;
  }
  /** How many unpacked blocks are kept. */
  private get keptAtMost(): number {
    return Math.max(4, Math.floor(96e6 / (this.blocks[0].frames * this.head.robots * this.blocks[0].channels * 2)));
  }

  /** The ecology's clock at a frame. */
  time(frame: number): number {
    const { frames_per_tick: n, steps_per_tick: steps, tick_s, first_time_s } = this.head;
    return first_time_s + (Math.floor(frame / n) + Math.ceil(((frame % n) * steps) / n) / steps) * tick_s;
  }
  get firstTime(): number {
    return this.time(this.firstFrame);
  }
  get lastTime(): number {
    return this.time(this.frames - 1);
  }

  /** The last frame at or before a moment, within the recording. */
  frameAt(time: number): number {
    const { frames_per_tick: n, tick_s, first_time_s } = this.head;
    let frame = Math.floor(((time - first_time_s) * n) / tick_s + 1);
    frame = Math.min(this.frames - 1, Math.max(this.firstFrame, frame));
    while (frame > this.firstFrame && this.time(frame) > time + 1e-9) --frame;
    return frame;
  }

  private blockOf(frame: number): Block {
    let low = 0;
    let high = this.blocks.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.blocks[middle].first <= frame) low = middle;
      else high = middle - 1;
    }
    return this.blocks[low];
  }

  /** The frame, or the last one before it where a fast live run has a gap. */
  private known(frame: number): number {
    const block = this.blockOf(frame);
    return Math.min(frame, block.first + block.frames - 1);
  }

  /** Whether a frame can be shown at once. */
  isReady(frame: number): boolean {
    return this.blockOf(frame).values !== undefined;
  }

  /** Unpacks the blocks of a frame and its successor. */
  async prepare(frame: number): Promise<void> {
    const block = this.blockOf(frame);
    const next = this.blockOf(Math.min(this.frames - 1, frame + 1));
    await this.unpack(block);
    if (next !== block) await this.unpack(next);
  }

  private async unpack(block: Block): Promise<Int16Array> {
    if (block.values) return block.values;
    block.waiting ??= inflate(block.bytes).then((planes) => {
      const count = block.channels * this.head.robots * block.frames;
      if (planes.length !== 2 * count) throw new Error(`the block of frame ${block.first} is damaged`);
      const values = new Int16Array(count);
      for (let column = 0; column < count; column += block.frames) {
        let now = 0;
        for (let at = column; at < column + block.frames; ++at) {
          const folded = planes[at] + 256 * planes[count + at];
          now = (now + ((folded >> 1) ^ -(folded & 1))) & 0xffff;
          values[at] = now;
        }
      }
      block.values = values;
      block.waiting = undefined;
      this.kept.push(block);
      if (this.kept.length > this.keptAtMost) this.kept.shift()!.values = undefined;
      return values;
    });
    return block.waiting;
  }

  /** Calls `see` with every block in turn, without keeping more than a few: (values, first frame, frames); `pause` with the part done. */
  async forEachBlock(see: (values: Int16Array, first: number, frames: number) => void, pause: (part: number) => Promise<void>): Promise<void> {
    for (const [number, block] of this.blocks.entries()) {
      see(await this.unpack(block), block.first, block.frames);
      await pause((number + 1) / this.blocks.length);
    }
  }

  /** Position, orientation (w, x, y, z) and joint angles of a robot at a frame that is ready, into `out`. */
  private frameInto(out: Float32Array, frame: number, robot: number): void {
    const block = this.blockOf(frame);
    const values = block.values;
    if (!values) return;
    const { robots, units } = this.head;
    const stride = robots * block.frames;
    let at = robot * block.frames + frame - block.first;
    out[0] = values[at] * units.position_m;
    out[1] = values[(at += stride)] * units.position_m;
    out[2] = values[(at += stride)] * units.position_m;
    const half = 0.5 * values[(at += stride)] * units.yaw_rad;
    const tiltX = values[(at += stride)] * units.tilt_rad;
    const tiltY = values[(at += stride)] * units.tilt_rad;
    const tilt = Math.hypot(tiltX, tiltY);
    const w = Math.cos(0.5 * tilt);
    const share = tilt > 0 ? Math.sin(0.5 * tilt) / tilt : 0;
    const x = share * tiltX;
    const y = share * tiltY;
    const c = Math.cos(half);
    const s = Math.sin(half);
    out[3] = c * w;
    out[4] = c * x - s * y;
    out[5] = c * y + s * x;
    out[6] = s * w;
    out.fill(0, 7);
    for (let channel = poseChannels; channel < block.channels; ++channel) out[channel + 1] = values[(at += stride)] * units.joint_rad;
  }

  /** The frame that a moment begins from. */
  shownAt(time: number): number {
    return this.known(this.frameAt(time));
  }

  /**
   * As `frameInto` at any moment whose frames are ready: interpolated between the frames next to it, unless the robot was set down, or
   * crossed the edge of a torus, between them. `born`: its place x, y at the last tick, if it was born then. `out` has `poseSize` numbers.
   */
  poseInto(out: Float32Array, time: number, robot: number, born?: ArrayLike<number>): void {
    const wanted = this.frameAt(time);
    const frame = this.known(wanted);
    let next = frame === wanted ? this.known(Math.min(this.frames - 1, frame + 1)) : frame;
    if (this.bodiesDiffer && this.lastSetDown(next, robot)?.frame > frame) next = frame;
    const { before: a, after: b } = this;
    this.frameInto(a, frame, robot);
    this.frameInto(b, next, robot);
    if (born && frame % this.head.frames_per_tick === 0) a.set(born);
    const gap = this.time(next) - this.time(frame);
    const part = gap > 0 ? Math.min(1, Math.max(0, (time - this.time(frame)) / gap)) : 0;
    const size = a.length;
    if (part < 1e-6 || !this.isReady(next) || Math.hypot(b[0] - a[0], b[1] - a[1]) > this.head.arena.half_side_m) {
      out.set(a);
      return;
    }
    const dot = a[3] * b[3] + a[4] * b[4] + a[5] * b[5] + a[6] * b[6];
    const sign = dot < 0 ? -1 : 1;
    for (let i = 0; i < size; ++i) out[i] = a[i] + part * ((i >= 3 && i < 7 ? sign : 1) * b[i] - a[i]);
    const norm = Math.hypot(out[3], out[4], out[5], out[6]);
    for (let i = 3; i < 7; ++i) out[i] /= norm;
  }
}
