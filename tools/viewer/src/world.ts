// SPDX-License-Identifier: MIT
// The world of one run in 3-D.
import { AmbientLight, Color, DirectionalLight, Matrix4, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { Bodies, sunAt } from "./bodies";
import { branchColour, catchColour, colourOf, inactiveColour } from "./colours";
import { Ground } from "./ground";
import { Labels } from "./labels";
import { Lines, type Mark, Marks } from "./marks";
import { RobotShape } from "./robot";
import { firstAfter } from "./moments";
import type { Run, Scene as Catch, Shot } from "./run";
import { theme } from "./theme";

export type View = "orbit" | "top" | "follow";

/** Optional parts of the picture besides the robots. */
export interface Shown {
  trails: boolean;
  links: boolean;
}

/** Content of a picture of a moment. */
export interface Look {
  time: number; // of the poses, and of what has just happened
  rowTime: number; // of who lives in which body: just before `time` while a catch is shown
  selected: number; // a body; -1: none
  scene: Catch | null; // its two are named, and its camera stays
  victim: number; // the individual whose death alone is marked; NaN: all deaths are
  highlighted: ReadonlySet<number>; // individuals
  flashSeconds: number; // how long a death is seen, ecology seconds
  shown: Shown;
}

const trailTicks = 30;
const reachSides = 64;
/** With more robots than that, those smaller than so many pixels are drawn without their limbs. */
const manyRobots = 60;
const farPixels = 16;
/** A robot of that many pixels has a name tag. */
const namedPixels = 64;

export class World {
  readonly canvas = document.createElement("canvas");
  readonly labels = new Labels();
  view: View = "orbit";
  private shot: Shot | null = null;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(38, 1, 0.05, 400);
  private readonly controls: OrbitControls;
  /** Per body that was drawn, and of each robot as it is drawn now. */
  private readonly shapes: RobotShape[] = [];
  private shapeOf: RobotShape[] = [];
  private readonly ground: Ground;
  private readonly bodies: Bodies;
  private readonly marks: Marks;
  private readonly trails: Lines;
  private readonly links: Lines;
  /** A circle round the hunter of a scene: what is in its reach. */
  private readonly reach: Lines;
  private pose = new Float32Array(7);
  private readonly matrix = new Matrix4();
  /** Last drawn place of each robot: x, y, z; NaN of a spare body. */
  readonly drawn: Float32Array;
  /** The way that each robot was drawn to head, radians. */
  readonly headings: Float32Array;

  /** Throws where the browser has no WebGL. */
  constructor(readonly run: Run, onPick: (body: number) => void, onLook: () => void) {
    const { head } = run.recording;
    const { robots } = run;
    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: true, powerPreference: "high-performance", preserveDrawingBuffer: true });
    this.scene.add(new AmbientLight(0xffffff, 1.9));
    const sun = new DirectionalLight(0xffffff, 1.9);
    sun.position.set(...sunAt);
    this.ground = new Ground(head.arena);
    this.scene.add(sun, this.ground.group);
    this.bodies = new Bodies(robots, !head.arena.height_field);
    this.marks = new Marks(robots);
    this.trails = new Lines(robots * trailTicks, 0.004);
    this.links = new Lines(robots, 0.1);
    this.reach = new Lines(reachSides, 0.006);
    this.scene.add(this.bodies.group, this.marks.group, this.trails.object, this.links.object, this.reach.object);
    this.drawn = new Float32Array(3 * robots);
    this.headings = new Float32Array(robots);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.maxPolarAngle = 0.495 * Math.PI;
    this.controls.addEventListener("change", onLook);
    this.paint();
    this.look("orbit");
    let downAt = [0, 0];
    this.canvas.addEventListener("pointerdown", (e) => (downAt = [e.clientX, e.clientY]));
    this.canvas.addEventListener("click", (e) => {
      if (Math.hypot(e.clientX - downAt[0], e.clientY - downAt[1]) < 5) onPick(this.nearest(e));
    });
  }

  /** Takes the colours of the theme. */
  paint(): void {
    this.scene.background = new Color(theme().background);
    this.ground.paint();
    this.bodies.paint();
  }

  /** Puts the camera where a view begins. */
  look(view: View): void {
    const half = this.run.recording.head.arena.half_side_m;
    this.view = view;
    this.shot = null;
    this.controls.enableRotate = view !== "top";
    const fit = Math.max(1, 1.25 / this.camera.aspect);
    this.camera.far = Math.max(400, 12 * half * fit);
    this.camera.near = this.camera.far / 8000; // so that marks on the floor stay in front of it
    this.camera.updateProjectionMatrix();
    if (view === "orbit") {
      this.controls.target.set(0, -0.14 * half, 0);
      this.camera.position.set(0, -2.0 * half * fit, 2.4 * half * fit);
    } else if (view === "top") {
      this.controls.target.set(0, 0, 0);
      this.camera.position.set(0, -0.001, 3.05 * half * fit);
    } else {
      this.camera.position.copy(this.controls.target).add(new Vector3(0, -2.0, 1.35));
    }
    this.controls.update();
  }

  /** Puts the camera where the director has it for a scene. */
  take(shot: Shot): void {
    this.shot = shot;
    const azimuth = (shot.azimuth_deg * Math.PI) / 180;
    const elevation = (shot.elevation_deg * Math.PI) / 180;
    const forward = new Vector3(Math.cos(azimuth) * Math.cos(elevation), Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation));
    this.controls.enableRotate = true;
    this.controls.target.set(...shot.at_m);
    this.camera.position.copy(this.controls.target).addScaledVector(forward, -(shot.near_m + Math.max(shot.high_m, shot.wide_m / this.camera.aspect)));
    this.controls.update();
  }

  resize(width: number, height: number): void {
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    const before = this.camera.aspect;
    this.camera.aspect = width / Math.max(1, height);
    this.camera.updateProjectionMatrix();
    if (Math.abs(before - this.camera.aspect) <= 0.05) return;
    if (this.shot) this.take(this.shot);
    else if (this.view !== "follow") this.look(this.view);
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

  private placeOf(body: number): Vector3 {
    return this.point.set(this.drawn[3 * body], this.drawn[3 * body + 1], this.drawn[3 * body + 2]);
  }

  /** The radius of a robot's body. */
  private radiusOf(body: number): number {
    return (this.shapeOf[body]?.model ?? this.run.recording.head.robot).bounding_radius_m;
  }
  private ringOf(body: number): number {
    return Math.max(1.15 * this.radiusOf(body), 0.021 * this.run.recording.head.arena.half_side_m);
  }

  /** How large a robot is on the screen. */
  private pixelsOf(body: number): number {
    const focal = (0.5 * this.canvas.clientHeight) / Math.tan((0.5 * this.camera.fov * Math.PI) / 180);
    return (2 * this.radiusOf(body) * focal) / this.placeOf(body).distanceTo(this.camera.position);
  }

  /** Place of a robot in the canvas, CSS pixels. */
  onScreen(body: number): [number, number] {
    this.placeOf(body).project(this.camera);
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    return [((this.point.x + 1) / 2) * width, ((1 - this.point.y) / 2) * height];
  }

  /** Draws a moment whose frames are ready. */
  draw(look: Look): void {
    const { run } = this;
    const { agents, recording } = run;
    const row = run.rowAt(look.rowTime);
    const bodyOf = new Map<number, number>();
    for (let body = 0; body < run.robots; ++body) if (agents.id[row + body] >= 0) bodyOf.set(agents.id[row + body], body);
    this.takeShapes(look.time, row);
    for (let body = 0; body < run.robots; ++body) {
      if (agents.id[row + body] < 0) {
        this.drawn.fill(NaN, 3 * body, 3 * body + 3);
        this.marks.set(body, null, null);
        continue;
      }
      const place = look.time === look.rowTime && run.isNew(row + body) ? run.track.subarray(2 * (row + body), 2 * (row + body) + 2) : undefined;
      recording.poseInto(this.pose, look.time, body, Number.isNaN(place?.[0]) ? undefined : place);
      this.drawRobot(body, row, look);
    }
    if (run.foods.length > 0) this.ground.show(run.foods, look.time);
    this.bodies.done();
    this.flash(look);
    this.marks.done();
    this.drawTrails(look, row);
    this.drawLinks(look, row, bodyOf);
    this.drawReach(look, bodyOf);
    if (!look.scene && this.view === "follow" && look.selected >= 0) this.followTo(look.selected);
    this.ground.see(this.camera.position);
    this.renderer.render(this.scene, this.camera);
    this.placeLabels(look, row);
  }

  /** The shapes of all living robots' bodies at a moment. */
  private takeShapes(time: number, row: number): void {
    const { agents, recording, robots } = this.run;
    if (this.pose.length < recording.poseSize) this.pose = new Float32Array(recording.poseSize);
    const frame = recording.shownAt(time);
    let boxes = 0;
    for (let robot = 0; robot < robots; ++robot) {
      if (agents.id[row + robot] < 0) continue;
      const body = recording.bodyAt(frame, robot);
      this.shapeOf[robot] = this.shapes[body] ??= new RobotShape(recording.bodies[body]);
      boxes += this.shapeOf[robot].boxes.length;
    }
    this.bodies.clear(boxes);
  }

  private drawRobot(body: number, row: number, look: Look): void {
    const { run, pose } = this;
    const { agents } = run;
    const colour = agents.active[row + body] === 1 ? colourOf(agents.species[row + body]) : inactiveColour;
    this.drawn.set(pose.subarray(0, 3), 3 * body);
    const shape = this.shapeOf[body];
    const links = shape.place(pose);
    this.bodies.begin(colour);
    const isFar = run.robots > manyRobots && this.pixelsOf(body) < farPixels;
    for (const box of shape.boxes) {
      if (!isFar || box.link === 0) this.bodies.add(this.matrix.multiplyMatrices(links[box.link], box.frame), box.link === 0);
    }
    const [, , , w, x, y, z] = pose;
    const heading = Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)) + shape.model.forward_rad;
    this.headings[body] = heading;
    const mark: Mark = { x: pose[0], y: pose[1], heading, colour, filled: run.hasTags && agents.tag[row + body] === Math.max(...run.index.tags), size: this.ringOf(body) };
    const isMarked = look.highlighted.has(agents.id[row + body]);
    const highlight = body === look.selected ? theme().ink : isMarked ? branchColour : null;
    this.marks.set(body, mark, look.scene ? null : highlight); // the two of a scene have names
  }

  private followTo(body: number): void {
    const move = this.placeOf(body).clone().sub(this.controls.target);
    this.controls.target.add(move);
    this.camera.position.add(move);
    this.camera.lookAt(this.controls.target);
    this.camera.updateMatrixWorld();
  }

  private flash({ time, flashSeconds, victim }: Look): void {
    const marks: Mark[] = [];
    const catches: Mark[] = [];
    const { events } = this.run;
    const { ink } = theme();
    for (let i = firstAfter(events, time - flashSeconds); i < events.length && events[i].time <= time; ++i) {
      const { kind, cause, species, time: then, x, y, body, id } = events[i];
      if (kind !== "death" && kind !== "activation") continue;
      if (!Number.isNaN(victim) && (id !== victim || kind !== "death")) continue;
      const age = (time - then) / flashSeconds;
      const mark = { x, y, heading: 0, filled: false, colour: ink, size: this.ringOf(body) * (1.2 + 2.2 * age) };
      if (kind === "activation") marks.push({ ...mark, colour: colourOf(species) });
      else if (cause !== "caught") marks.push(mark);
      else catches.push({ ...mark, colour: catchColour, size: this.ringOf(body) * (1.35 + 0.5 * age) });
    }
    this.marks.flash(marks, catches);
  }

  private drawTrails({ time, selected, shown }: Look, row: number): void {
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
        // Up to where its individual was born in a place of its own, or came over the edge of a torus.
        const most = agents.id[at] === agents.id[row + body] ? recording.head.arena.half_side_m : this.radiusOf(body);
        if (agents.id[at] < 0 || !(Math.hypot(x1 - x, y1 - y) < most)) break;
        const strength = body === selected ? 1 : 0.7;
        const colour = agents.active[at] === 1 ? colourOf(agents.species[at]) : inactiveColour;
        this.trails.add(x, y, x1, y1, colour, strength * (1 - back / trailTicks), strength * (1 - (back + 1) / trailTicks));
        x = x1;
        y = y1;
      }
    }
    this.trails.done();
  }

  private drawLinks({ selected, shown }: Look, row: number, bodyOf: Map<number, number>): void {
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

  private drawReach({ scene }: Look, bodyOf: Map<number, number>): void {
    this.reach.clear();
    const hunter = bodyOf.get(scene?.individuals[0] ?? NaN);
    if (scene?.reach_m && hunter !== undefined) {
      const [x, y] = this.drawn.subarray(3 * hunter, 3 * hunter + 2);
      const corner = (side: number): [number, number] => [x + scene.reach_m! * Math.cos((2 * Math.PI * side) / reachSides), y + scene.reach_m! * Math.sin((2 * Math.PI * side) / reachSides)];
      for (let side = 0; side < reachSides; ++side) this.reach.add(...corner(side), ...corner(side + 1), theme().ink, 0.8, 0.8);
    }
    this.reach.done();
  }

  private placeLabels({ selected, scene }: Look, row: number): void {
    const { agents, index, robots } = this.run;
    this.labels.clear();
    for (let body = 0; body < robots; ++body) {
      const isMain = body === selected || (scene?.individuals.includes(agents.id[row + body]) ?? false);
      if (!isMain && !(this.pixelsOf(body) >= namedPixels)) continue;
      const [x, y] = this.onScreen(body);
      if (this.point.z > 1 || x < 0 || y < 0 || x > this.canvas.clientWidth || y > this.canvas.clientHeight) continue;
      const id = agents.id[row + body];
      const species = agents.species[row + body];
      const above = 0.5 * this.pixelsOf(body); // on no limb of its own
      this.labels.add(isMain ? `${index.species[species] ?? ""} ${id}` : `${id}`, x, y - above, scene && isMain ? colourOf(species) : "", isMain);
    }
    this.labels.done();
  }

  /** Gives back what it holds of the graphics processor. */
  stop(): void {
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  /** The picture of the canvas, as a PNG. */
  picture(): string {
    return this.canvas.toDataURL("image/png");
  }
}
