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
export interface Head {
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
  robot: { name: string; forward_rad: number; bounding_radius_m: number; links: LinkShape[] };
  arena: {
    name: string;
    half_side_m: number;
    extent_m: number;
    height_field?: { nodes: number; half_extent_m: number; height_m: number[] };
  };
}

interface Block {
  first: number;
  frames: number;
  bytes: Uint8Array;
  values?: Int16Array;
  waiting?: Promise<Int16Array>;
}

const poseChannels = 6;

export class Recording {
  readonly channels: number;
  private readonly blocks: Block[] = [];
  private kept: Block[] = [];

  /** Of a live run: `append` adds its frames. */
  constructor(readonly head: Head) {
    this.channels = poseChannels + head.joints;
  }

  /** Throws for bytes that are not a recording. */
  static read(bytes: Uint8Array): Recording {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    if (bytes[0] !== 0x89 || String.fromCharCode(...bytes.subarray(1, 4)) !== "TRP") throw new Error("replay.trp is not a recording");
    let head: Head | undefined;
    const poses: Uint8Array[] = [];
    for (let at = 8; at + 12 <= bytes.length; ) {
      const size = view.getUint32(at, true);
      if (at + 12 + size > bytes.length) break;
      const kind = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
      const data = bytes.subarray(at + 8, at + 8 + size);
      if (kind === "HEAD") head = { ...head, ...(JSON.parse(new TextDecoder().decode(data)) as Head) };
      if (kind === "POSE") poses.push(data);
      at += 12 + size;
    }
    if (!head || poses.length === 0) throw new Error("this recording has no frames");
    const recording = new Recording(head);
    for (const block of poses) recording.append(block);
    return recording;
  }

  /** Adds a block: its first frame, its number of frames, the frames. */
  append(block: Uint8Array): void {
    const view = new DataView(block.buffer, block.byteOffset, block.byteLength);
    this.blocks.push({ first: view.getUint32(0, true), frames: view.getUint32(4, true), bytes: block.subarray(8) });
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
    return Math.max(4, Math.floor(96e6 / (this.blocks[0].frames * this.head.robots * this.channels * 2)));
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
      const count = this.channels * this.head.robots * block.frames;
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
    for (let joint = 0; joint < this.head.joints; ++joint) out[7 + joint] = values[(at += stride)] * units.joint_rad;
  }

  private readonly before = new Float32Array(128);
  private readonly after = new Float32Array(128);

  /** As `frameInto` at any moment whose frames are ready: interpolated between the frames next to it. */
  poseInto(out: Float32Array, time: number, robot: number): void {
    const wanted = this.frameAt(time);
    const frame = this.known(wanted);
    const next = frame === wanted ? this.known(Math.min(this.frames - 1, frame + 1)) : frame;
    const { before: a, after: b } = this;
    this.frameInto(a, frame, robot);
    const gap = this.time(next) - this.time(frame);
    const part = gap > 0 ? Math.min(1, Math.max(0, (time - this.time(frame)) / gap)) : 0;
    const size = 7 + this.head.joints;
    if (part < 1e-6 || !this.isReady(next)) {
      out.set(a.subarray(0, size));
      return;
    }
    this.frameInto(b, next, robot);
    const dot = a[3] * b[3] + a[4] * b[4] + a[5] * b[5] + a[6] * b[6];
    const sign = dot < 0 ? -1 : 1;
    for (let i = 0; i < size; ++i) out[i] = a[i] + part * ((i >= 3 && i < 7 ? sign : 1) * b[i] - a[i]);
    const norm = Math.hypot(out[3], out[4], out[5], out[6]);
    for (let i = 3; i < 7; ++i) out[i] /= norm;
  }
}
