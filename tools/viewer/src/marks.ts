// SPDX-License-Identifier: MIT
// Marks of robots that are visible from afar: a ring on the floor in the species' colour, filled or hollow by the tag, and the heading.
// Marks of events: rings round the place, red for a catch; those of another death or an activation widen.
import { BufferAttribute, BufferGeometry, CircleGeometry, Color, DoubleSide, Group, InstancedMesh, LineBasicMaterial, LineSegments, Matrix4, MeshBasicMaterial, RingGeometry, Vector3 } from "three";

const hidden = new Matrix4().makeScale(0, 0, 0);

export interface Mark {
  x: number;
  y: number;
  heading: number;
  colour: string;
  filled: boolean;
  size: number;
}

/** A pool of flat marks of one shape. */
class Flat {
  readonly mesh: InstancedMesh;
  private readonly matrix = new Matrix4();
  private readonly colour = new Color();

  constructor(geometry: BufferGeometry, count: number, opacity: number, height: number) {
    const material = new MeshBasicMaterial({ transparent: opacity < 1, opacity, side: DoubleSide, depthWrite: false });
    this.mesh = new InstancedMesh(geometry, material, count);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = height;
    this.mesh.position.z = 0.002 + 0.001 * height;
    this.mesh.setColorAt(0, this.colour.set("#fff"));
  }

  set(index: number, mark: Mark | null, colour?: string): void {
    if (!mark) {
      this.mesh.setMatrixAt(index, hidden);
      return;
    }
    this.matrix.makeRotationZ(mark.heading);
    this.matrix.scale(new Vector3(mark.size, mark.size, 1));
    this.matrix.setPosition(mark.x, mark.y, 0);
    this.mesh.setMatrixAt(index, this.matrix);
    this.mesh.setColorAt(index, this.colour.set(colour ?? mark.colour));
  }

  done(): void {
    this.mesh.instanceMatrix.needsUpdate = true;
    if (this.mesh.instanceColor) this.mesh.instanceColor.needsUpdate = true;
  }
}

function pointer(): BufferGeometry {
  const shape = new Float32Array([1.55, 0, 0, 1.08, 0.3, 0, 1.08, -0.3, 0]);
  return new BufferGeometry().setAttribute("position", new BufferAttribute(shape, 3));
}

/** Rings, discs, pointers and highlights of `count` robots, and what has just happened. */
export class Marks {
  readonly group = new Group();
  private readonly highlights: Flat;
  private readonly discs: Flat;
  private readonly rings: Flat;
  private readonly pointers: Flat;
  private readonly flashes: Flat;
  private readonly catches: Flat;

  constructor(count: number, private readonly flashCount = 64) {
    this.highlights = new Flat(new RingGeometry(1.66, 1.8, 48), count, 1, 0);
    this.discs = new Flat(new CircleGeometry(1, 32), count, 0.42, 1);
    this.rings = new Flat(new RingGeometry(0.88, 1, 48), count, 1, 2);
    this.pointers = new Flat(pointer(), count, 1, 3);
    this.flashes = new Flat(new RingGeometry(0.9, 1, 40), flashCount, 0.7, 4);
    this.catches = new Flat(new RingGeometry(0.85, 1, 48), flashCount, 1, 5);
    for (const flat of this.all) this.group.add(flat.mesh);
  }

  private get all(): Flat[] {
    return [this.highlights, this.discs, this.rings, this.pointers, this.flashes, this.catches];
  }

  /** `mark`: null for a spare body. */
  set(index: number, mark: Mark | null, highlight: string | null): void {
    this.rings.set(index, mark);
    this.discs.set(index, mark?.filled ? mark : null);
    this.pointers.set(index, mark);
    this.highlights.set(index, highlight ? mark : null, highlight ?? undefined);
  }

  /** Rings where something has just happened, and where a robot was caught; the last ones of too many. */
  flash(marks: Mark[], catches: Mark[]): void {
    for (let i = 1; i <= this.flashCount; ++i) {
      this.flashes.set(i - 1, marks.at(-i) ?? null);
      this.catches.set(i - 1, catches.at(-i) ?? null);
    }
  }

  done(): void {
    for (const flat of this.all) flat.done();
  }
}

/** Line segments that are rewritten at each frame, with a colour at each end. */
export class Lines {
  readonly object: LineSegments;
  private readonly position: BufferAttribute;
  private readonly colours: BufferAttribute;
  private used = 0;
  private readonly colour = new Color();

  constructor(private readonly most: number, height: number) {
    this.position = new BufferAttribute(new Float32Array(6 * most), 3);
    this.colours = new BufferAttribute(new Float32Array(8 * most), 4);
    const geometry = new BufferGeometry().setAttribute("position", this.position).setAttribute("color", this.colours);
    this.object = new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false }));
    this.object.frustumCulled = false;
    this.object.position.z = height;
  }

  clear(): void {
    this.used = 0;
  }

  add(x0: number, y0: number, x1: number, y1: number, colour: string, opacity0: number, opacity1: number): void {
    if (this.used >= this.most) return;
    const at = 2 * this.used++;
    this.position.setXYZ(at, x0, y0, 0);
    this.position.setXYZ(at + 1, x1, y1, 0);
    const { r, g, b } = this.colour.set(colour);
    this.colours.setXYZW(at, r, g, b, opacity0);
    this.colours.setXYZW(at + 1, r, g, b, opacity1);
  }

  done(): void {
    this.object.geometry.setDrawRange(0, 2 * this.used);
    this.position.needsUpdate = true;
    this.colours.needsUpdate = true;
  }
}
