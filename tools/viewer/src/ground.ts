// SPDX-License-Identifier: MIT
// The arena: floor with a grid of metres, walls or slopes.
import { BoxGeometry, BufferAttribute, BufferGeometry, DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, MeshLambertMaterial, PlaneGeometry } from "three";
import type { Head } from "./recording";

export function makeGround(arena: Head["arena"]): Group {
  const ground = new Group();
  const half = arena.half_side_m;
  const floor = new Mesh(new PlaneGeometry(2 * half, 2 * half), new MeshBasicMaterial({ color: 0xf7f8f9 }));
  floor.position.z = -0.002;
  ground.add(floor);
  const step = half > 40 ? 10 : half > 15 ? 2 : 1;
  const lines: number[] = [];
  for (let at = -Math.floor(half / step) * step; at <= half + 1e-9; at += step) {
    lines.push(at, -half, 0, at, half, 0, -half, at, 0, half, at, 0);
  }
  const grid = new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(lines), 3));
  ground.add(new LineSegments(grid, new LineBasicMaterial({ color: 0xe2e6ea })));
  if (arena.height_field) {
    ground.add(slopes(arena.height_field));
  } else {
    const height = 0.035 * half;
    const thick = 0.012 * half;
    const material = new MeshLambertMaterial({ color: 0xc3cad2, transparent: true, opacity: 0.75 });
    for (const [x, y] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
      const long = 2 * half + 2 * thick;
      const wall = new Mesh(new BoxGeometry(x ? thick : long, y ? thick : long, height), material);
      wall.position.set(x * (half + thick / 2), y * (half + thick / 2), height / 2);
      ground.add(wall);
    }
  }
  return ground;
}

function slopes(field: NonNullable<Head["arena"]["height_field"]>): Mesh {
  const { nodes, half_extent_m, height_m } = field;
  const geometry = new PlaneGeometry(2 * half_extent_m, 2 * half_extent_m, nodes - 1, nodes - 1);
  const position = geometry.getAttribute("position");
  // Slopes of many metres would hide the floor: they are drawn flatter, and the floor itself a little lower than its own plane.
  const highest = height_m.reduce((a, b) => Math.max(a, b));
  const scale = highest > 1.5 ? 1.5 / highest : 1;
  for (let i = 0; i < position.count; ++i) {
    const ix = Math.round(((position.getX(i) + half_extent_m) / (2 * half_extent_m)) * (nodes - 1));
    const iy = Math.round(((position.getY(i) + half_extent_m) / (2 * half_extent_m)) * (nodes - 1));
    position.setZ(i, height_m[iy * nodes + ix] * scale - 0.006);
  }
  geometry.computeVertexNormals();
  return new Mesh(geometry, new MeshLambertMaterial({ color: 0xd4dae0, side: DoubleSide, transparent: true, opacity: 0.8 }));
}
