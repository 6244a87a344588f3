// SPDX-License-Identifier: MIT
// The world of one run in 3-D.
import { AmbientLight, BoxGeometry, Color, DirectionalLight, InstancedMesh, Matrix4, MeshLambertMaterial, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { colourOf, inactiveColour, selectedColour } from "./colours";
import { makeGround } from "./ground";
import { Lines, type Mark, Marks } from "./marks";
import { RobotShape } from "./robot";
import type { Run } from "./run";

export type View = "orbit" | "top" | "follow";

/** Optional parts of the picture besides the robots. */
export interface Shown {
  trails: boolean;
  links: boolean;
}

const trailTicks = 30;
const flashSeconds = 6;
/** In worlds of more robots, those smaller than so many pixels are drawn without their limbs. */
const manyRobots = 60;
const farPixels = 16;

export class World {
  readonly canvas = document.createElement("canvas");
  readonly label = document.createElement("div");
  view: View = "orbit";
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(38, 1, 0.05, 400);
  private readonly controls: OrbitControls;
  private readonly shape: RobotShape;
  private readonly boxes: InstancedMesh;
  private readonly marks: Marks;
  private readonly trails: Lines;
  private readonly links: Lines;
  private readonly pose = new Float32Array(128);
  private readonly matrix = new Matrix4();
  private readonly colour = new Color();
  private readonly ringSize: number;
  /** Last drawn place of each robot: x, y, z. */
  readonly drawn: Float32Array;

  constructor(
    readonly run: Run,
    onPick: (body: number) => void,
    onLook: () => void,
  ) {
    const { head } = run.recording;
    const { robots } = run;
    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: true, powerPreference: "high-performance", preserveDrawingBuffer: true });
    this.scene.background = new Color(0xffffff);
    this.scene.add(new AmbientLight(0xffffff, 1.9));
    const sun = new DirectionalLight(0xffffff, 1.9);
    sun.position.set(4, -7, 10);
    this.scene.add(sun, makeGround(head.arena));
    this.shape = new RobotShape(head);
    this.boxes = new InstancedMesh(new BoxGeometry(1, 1, 1), new MeshLambertMaterial(), robots * this.shape.boxes.length);
    this.boxes.frustumCulled = false;
    this.marks = new Marks(robots);
    this.trails = new Lines(robots * trailTicks, 0.004);
    this.links = new Lines(robots, 0.1);
    this.scene.add(this.boxes, this.marks.group, this.trails.object, this.links.object);
    this.drawn = new Float32Array(3 * robots);
    this.ringSize = Math.max(head.robot.bounding_radius_m * 1.15, 0.021 * head.arena.half_side_m);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.maxPolarAngle = 0.495 * Math.PI;
    this.controls.addEventListener("change", onLook);
    this.label.className = "tag";
    this.look("orbit");
    let downAt = [0, 0];
    this.canvas.addEventListener("pointerdown", (e) => (downAt = [e.clientX, e.clientY]));
    this.canvas.addEventListener("click", (e) => {
      if (Math.hypot(e.clientX - downAt[0], e.clientY - downAt[1]) < 5) onPick(this.nearest(e));
    });
  }

  /** Puts the camera at the start of a view. */
  look(view: View): void {
    const half = this.run.recording.head.arena.half_side_m;
    this.view = view;
    this.controls.enableRotate = view !== "top";
    const fit = Math.max(1, 1.25 / this.camera.aspect);
    this.camera.far = Math.max(400, 12 * half * fit);
    this.camera.near = this.camera.far / 8000; // so that marks on the floor stay in front of it
    this.camera.updateProjectionMatrix();
    if (view === "orbit") {
      this.controls.target.set(0, -0.14 * half, 0);
      this.camera.position.set(0, -2.1 * half * fit, 2.3 * half * fit);
    } else if (view === "top") {
      this.controls.target.set(0, 0, 0);
      this.camera.position.set(0, -0.001, 3.05 * half * fit);
    } else {
      this.camera.position.copy(this.controls.target).add(new Vector3(0, -2.0, 1.35));
    }
    this.controls.update();
  }

  resize(width: number, height: number): void {
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    const before = this.camera.aspect;
    this.camera.aspect = width / Math.max(1, height);
    this.camera.updateProjectionMatrix();
    if (Math.abs(before - this.camera.aspect) > 0.05 && this.view !== "follow") this.look(this.view);
  }

  /** The robot drawn nearest to a click, within 26 pixels; -1: none. */
  private nearest(event: MouseEvent): number {
    const bounds = this.canvas.getBoundingClientRect();
    let best = -1;
    let least = 26;
    for (let body = 0; body < this.run.robots; ++body) {
      const [x, y] = this.onScreen(body);
      const distance = Math.hypot(x + bounds.left - event.clientX, y + bounds.top - event.clientY);
      if (distance < least) {
        least = distance;
        best = body;
      }
    }
    return best;
  }

  private readonly point = new Vector3();

  /** Size of a robot on the screen. */
  private pixelsOf(body: number): number {
    this.point.set(this.drawn[3 * body], this.drawn[3 * body + 1], this.drawn[3 * body + 2]);
    const focal = (0.5 * this.canvas.clientHeight) / Math.tan((0.5 * this.camera.fov * Math.PI) / 180);
    return (2 * this.run.recording.head.robot.bounding_radius_m * focal) / this.point.distanceTo(this.camera.position);
  }

  /** Place of a robot in the canvas, CSS pixels. */
  onScreen(body: number): [number, number] {
    this.point.set(this.drawn[3 * body], this.drawn[3 * body + 1], this.drawn[3 * body + 2]).project(this.camera);
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    return [((this.point.x + 1) / 2) * width, ((1 - this.point.y) / 2) * height];
  }

  /** Draws a moment whose frames are ready. `selected`: a body or -1; `highlighted`: individuals. */
  draw(time: number, selected: number, highlighted: ReadonlySet<number>, shown: Shown): void {
    const { run } = this;
    const { agents, recording } = run;
    const { head } = recording;
    const row = run.rowAt(time);
    let boxes = 0;
    const bodyOf = new Map<number, number>();
    for (let body = 0; body < run.robots; ++body) bodyOf.set(agents.id[row + body], body);
    const filledTag = Math.max(...run.index.tags);
    for (let body = 0; body < run.robots; ++body) {
      const active = agents.active[row + body] === 1;
      const colour = active ? colourOf(agents.species[row + body]) : inactiveColour;
      recording.poseInto(this.pose, time, body);
      this.drawn.set(this.pose.subarray(0, 3), 3 * body);
      const links = this.shape.place(this.pose, head.joints);
      this.colour.set(colour);
      const rootColour = this.colour.getHex();
      const limbColour = this.colour.lerp(new Color(0x2b333d), 0.45).getHex();
      const isFar = run.robots > manyRobots && this.pixelsOf(body) < farPixels;
      for (const box of this.shape.boxes) {
        if (isFar && box.link > 0) continue;
        const index = boxes++;
        this.boxes.setMatrixAt(index, this.matrix.multiplyMatrices(links[box.link], box.frame));
        this.boxes.setColorAt(index, this.colour.setHex(box.link === 0 ? rootColour : limbColour));
      }
      const [, , , w, x, y, z] = this.pose;
      const yaw = Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
      const mark: Mark = {
        x: this.pose[0],
        y: this.pose[1],
        heading: yaw + head.robot.forward_rad,
        colour,
        filled: agents.tag[row + body] === filledTag,
        size: this.ringSize,
      };
      const isMarked = highlighted.has(agents.id[row + body]);
      this.marks.set(body, mark, body === selected ? selectedColour : isMarked ? "#e8b400" : null);
    }
    this.boxes.count = boxes;
    this.flash(time);
    this.marks.done();
    this.boxes.instanceMatrix.needsUpdate = true;
    if (this.boxes.instanceColor) this.boxes.instanceColor.needsUpdate = true;
    this.drawTrails(time, row, selected, shown);
    this.drawLinks(row, bodyOf, selected, shown);
    if (this.view === "follow" && selected >= 0) this.followTo(selected);
    this.renderer.render(this.scene, this.camera);
    this.placeLabel(selected, row);
  }

  private followTo(body: number): void {
    const at = new Vector3(this.drawn[3 * body], this.drawn[3 * body + 1], this.drawn[3 * body + 2]);
    const move = at.sub(this.controls.target);
    this.controls.target.add(move);
    this.camera.position.add(move);
    this.camera.lookAt(this.controls.target);
    this.camera.updateMatrixWorld();
  }

  private flash(time: number): void {
    const marks: Mark[] = [];
    const { events } = this.run;
    for (let i = firstAfter(events, time - flashSeconds); i < events.length && events[i].time <= time; ++i) {
      const event = events[i];
      if (event.kind !== "death" && event.kind !== "activation") continue;
      const age = (time - event.time) / flashSeconds;
      const colour = event.kind === "death" ? selectedColour : colourOf(event.species);
      marks.push({ x: event.x, y: event.y, heading: 0, colour, filled: false, size: this.ringSize * (1.2 + 2.2 * age) * (age < 1 ? 1 : 0) });
    }
    this.marks.flash(marks);
  }

  private drawTrails(time: number, row: number, selected: number, shown: Shown): void {
    const { track, agents, robots, recording } = this.run;
    this.trails.clear();
    const tick = row / robots;
    for (let body = 0; shown.trails && body < robots; ++body) {
      let x = this.drawn[3 * body];
      let y = this.drawn[3 * body + 1];
      for (let back = 0; back < trailTicks; ++back) {
        const at = (tick - back) * robots + body;
        if (tick - back < 0 || (tick - back + agents.firstTick) * recording.head.tick_s > time + 1e-9) continue;
        const x1 = track[2 * at];
        const y1 = track[2 * at + 1];
        if (Number.isNaN(x1)) break;
        const strength = body === selected ? 1 : 0.7;
        const colour = agents.active[at] === 1 ? colourOf(agents.species[at]) : inactiveColour;
        this.trails.add(x, y, x1, y1, colour, strength * (1 - back / trailTicks), strength * (1 - (back + 1) / trailTicks));
        x = x1;
        y = y1;
      }
    }
    this.trails.done();
  }

  private drawLinks(row: number, bodyOf: Map<number, number>, selected: number, shown: Shown): void {
    const { agents, robots } = this.run;
    this.links.clear();
    for (let body = 0; shown.links && body < robots; ++body) {
      const other = bodyOf.get(agents.adversary[row + body]);
      if (other === undefined) continue;
      const strength = body === selected ? 0.9 : 0.28;
      const colour = colourOf(agents.species[row + body]);
      this.links.add(this.drawn[3 * body], this.drawn[3 * body + 1], this.drawn[3 * other], this.drawn[3 * other + 1], colour, strength, 0.12 * strength);
    }
    this.links.done();
  }

  private placeLabel(selected: number, row: number): void {
    this.label.hidden = selected < 0;
    if (selected < 0) return;
    const [x, y] = this.onScreen(selected);
    this.label.textContent = `${this.run.agents.id[row + selected]}`;
    this.label.style.transform = `translate(${Math.round(x + 12)}px, ${Math.round(y - 26)}px)`;
  }

  /** The picture of the canvas, as a PNG. */
  picture(): string {
    return this.canvas.toDataURL("image/png");
  }
}

/** The first event later than a moment. */
export function firstAfter(events: readonly { time: number }[], time: number): number {
  let low = 0;
  let high = events.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (events[middle].time <= time) low = middle + 1;
    else high = middle;
  }
  return low;
}
