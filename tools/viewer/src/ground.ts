// SPDX-License-Identifier: MIT
// The arena: floor with a grid of metres, walls or slopes. A wall between the camera and the floor is nearly transparent.
import { BoxGeometry, BufferAttribute, BufferGeometry, CylinderGeometry, DataTexture, DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, MeshLambertMaterial, PlaneGeometry, RingGeometry, SRGBColorSpace, type Vector3 } from "three";
import { type Food, paintFoods } from "./food";
import type { Head } from "./recording";
import { theme } from "./theme";

interface Wall {
  material: MeshLambertMaterial;
  x: number; // its outward normal
  y: number;
}

export class Ground {
  readonly group = new Group();
  private readonly floor = new MeshBasicMaterial();
  private readonly grid = new LineBasicMaterial();
  private readonly slopes = new MeshLambertMaterial({ side: DoubleSide, transparent: true, opacity: 0.8 });
  private readonly obstacles = new MeshLambertMaterial();
  private readonly zones = new MeshBasicMaterial();
  private readonly walls: Wall[] = [];
  private readonly half: number;

  constructor(arena: Head["arena"]) {
    const half = arena.half_side_m;
    this.half = half;
    const floor = new Mesh(new PlaneGeometry(2 * half, 2 * half), this.floor);
    floor.position.z = -0.002;
    floor.renderOrder = -3; // shadows lie between the floor and its grid
    this.group.add(floor);
    const step = half > 40 ? 10 : half > 15 ? 2 : 1;
    const lines: number[] = [];
    for (let at = -Math.floor(half / step) * step; at <= half + 1e-9; at += step) lines.push(at, -half, 0, at, half, 0, -half, at, 0, half, at, 0);
    const grid = new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(lines), 3));
    const net = new LineSegments(grid, this.grid);
    net.renderOrder = -1;
    this.group.add(net);
    for (const one of arena.obstacles ?? []) this.makeObstacle(one);
    for (const { x_m, y_m, radius_m } of arena.zones ?? []) {
      const ring = new Mesh(new RingGeometry(radius_m - 0.006 * half, radius_m, 64), this.zones);
      ring.position.set(x_m, y_m, 0.001);
      this.group.add(ring);
    }
    if (arena.height_field) this.group.add(this.makeSlopes(arena.height_field));
    else this.makeWalls();
    this.paint();
  }

  /** Takes the colours of the theme. */
  paint(): void {
    const colours = theme();
    this.floor.color.set(this.floor.map ? "#fff" : colours.floor);
    this.grid.color.set(colours.grid);
    this.slopes.color.set(colours.wall);
    this.obstacles.color.set(colours.wall);
    this.zones.color.set(colours.zone);
    for (const { material } of this.walls) material.color.set(colours.wall);
  }

  /** Colours the floor by its foods at a moment, with as many cells as the finest has. */
  show(foods: Food[], time: number): void {
    if (!this.floor.map) {
      const side = Math.max(...foods.map((food) => food.side));
      this.floor.map = new DataTexture(new Uint8Array(4 * side ** 2), side, side);
      this.floor.map.colorSpace = SRGBColorSpace;
      this.floor.needsUpdate = true;
      this.paint();
    }
    const { data, width } = (this.floor.map as DataTexture).image;
    paintFoods(foods, width, data as Uint8Array, time);
    this.floor.map.needsUpdate = true;
  }

  /** Lets one see through the walls that stand before the floor as seen from a place. */
  see(from: Vector3): void {
    for (const { material, x, y } of this.walls) {
      const isBefore = from.x * x + from.y * y > 1.02 * this.half;
      material.opacity = isBefore ? 0.12 : 0.9;
      material.depthWrite = !isBefore;
    }
  }

  private makeWalls(): void {
    const { half } = this;
    const height = 0.035 * half;
    const thick = 0.012 * half;
    for (const [x, y] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
      const long = 2 * half + 2 * thick;
      const material = new MeshLambertMaterial({ transparent: true });
      const wall = new Mesh(new BoxGeometry(x ? thick : long, y ? thick : long, height), material);
      wall.position.set(x * (half + thick / 2), y * (half + thick / 2), height / 2);
      this.walls.push({ material, x, y });
      this.group.add(wall);
    }
  }

  private makeObstacle([x, y, toX, toY, radius, height]: number[]): void {
    const add = (mesh: Mesh, atX: number, atY: number) => {
      mesh.position.set(atX, atY, height / 2);
      this.group.add(mesh);
      return mesh;
    };
    const end = new CylinderGeometry(radius, radius, height, 24).rotateX(Math.PI / 2);
    add(new Mesh(end, this.obstacles), x, y);
    if (x === toX && y === toY) return;
    add(new Mesh(end, this.obstacles), toX, toY);
    const side = new BoxGeometry(Math.hypot(toX - x, toY - y), 2 * radius, height);
    add(new Mesh(side, this.obstacles), (x + toX) / 2, (y + toY) / 2).rotation.z = Math.atan2(toY - y, toX - x);
  }

  private makeSlopes(field: NonNullable<Head["arena"]["height_field"]>): Mesh {
    const { nodes, half_extent_m, height_m } = field;
    const geometry = new PlaneGeometry(2 * half_extent_m, 2 * half_extent_m, nodes - 1, nodes - 1);
    const position = geometry.getAttribute("position");
    // Slopes of many metres would hide the floor: they are drawn flatter, and lower, so that marks of robots at their foot stay visible.
    const highest = height_m.reduce((a, b) => Math.max(a, b));
    const scale = highest > 1.5 ? 1.5 / highest : 1;
    for (let i = 0; i < position.count; ++i) {
      const ix = Math.round(((position.getX(i) + half_extent_m) / (2 * half_extent_m)) * (nodes - 1));
      const iy = Math.round(((position.getY(i) + half_extent_m) / (2 * half_extent_m)) * (nodes - 1));
      position.setZ(i, height_m[iy * nodes + ix] * scale - 0.08);
    }
    geometry.computeVertexNormals();
    return new Mesh(geometry, this.slopes);
  }
}
