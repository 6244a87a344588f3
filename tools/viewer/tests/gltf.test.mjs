// SPDX-License-Identifier: MIT
// Files of `trophic export` in Khronos' validator and three.js. TROPHIC, PREDATOR_PREY, OWN_BODIES and ENGINE name programs and backend.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import validator from "gltf-validator";
import * as three from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";

const folder = mkdtempSync(join(tmpdir(), "trophic-gltf-"));
const at = (name) => join(folder, name);
const write = (run, name, ...options) => execFileSync(process.env.TROPHIC, ["export", at(run), "--out", at(name), ...options.map(String)]);
before(() => {
  const run = (name, backend, ...options) =>
    execFileSync(process.env.PREDATOR_PREY, ["--backend", backend, "--seed", "3", "--out", at(name), ...options]);
  run("long", "kinematic", "--duration", "600");
  run("walk", process.env.ENGINE, "--duration", "20");
  execFileSync(process.env.OWN_BODIES, ["--out", at("bodies"), "--seed", "3", "--duration", "100", "--set", "rules.body_plan.first_modules=6"]);
  run("torus", "torus", "--duration", "60");
  run("slopes", "kinematic", "--duration", "20", "--set", "ecology.arena=height_field");
});
after(() => rmSync(folder, { recursive: true, force: true }));

test("glTF: exported run -> no finding of Khronos' validator", async () => {
  const files = [
    ["long", "long.glb"], ["walk", "walk.gltf"], ["slopes", "slopes.glb"], ["walk", "moment.glb", "--from", 4, "--to", 4],
    ["long", "one.glb", "--follow", 5, "--to", 2], ["bodies", "bodies.glb"],
  ];
  for (const [run, name, ...options] of files) {
    write(run, name, ...options);
    const report = await validator.validateBytes(new Uint8Array(readFileSync(at(name))), { uri: name });
    const { numErrors, numWarnings, messages } = report.issues;
    assert.deepEqual([numErrors, numWarnings], [0, 0], JSON.stringify(messages.slice(0, 5)));
    assert.equal(report.info.hasAnimations ?? report.info.animationCount > 0, name !== "moment.glb");
  }
});

test("glTF: individuals with bodies of their own -> each node has the hinges of its own body", () => {
  write("bodies", "own.gltf");
  const { nodes } = JSON.parse(readFileSync(at("own.gltf"), "utf8"));
  const [header, ...lines] = readFileSync(join(at("bodies"), "bodies.csv"), "utf8").trim().split("\n").map((line) => line.split(","));
  const recorded = lines.filter((cells) => Number(cells[header.indexOf("time_s")]) < 100); // those born at the end have no frame
  const hinges = new Map(recorded.map((cells) => [Number(cells[header.indexOf("id")]), Number(cells[header.indexOf("hinges")])]));
  const joints = (node) => (node.children ?? []).reduce((sum, child) => sum + (nodes[child].mesh === undefined ? 1 : 0) + joints(nodes[child]), 0);
  const robots = nodes.filter((node) => hinges.has(node.extras?.id));
  assert.ok(robots.length >= 30);
  for (const robot of robots) assert.equal(joints(robot), hinges.get(robot.extras.id), robot.name);
});

async function played(name) {
  const bytes = readFileSync(at(name));
  const gltf = await new GLTFLoader().parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength), "");
  const mixer = new three.AnimationMixer(gltf.scene);
  mixer.clipAction(gltf.animations[0]).setLoop(three.LoopOnce).play();
  return { scene: gltf.scene, mixer };
}

test("glTF: robots of a torus -> leave the arena on one side and are at once on the other", async () => {
  write("torus", "torus.glb");
  const { scene, mixer } = await played("torus.glb");
  const robots = [];
  scene.traverse((node) => node.userData.id !== undefined && robots.push(node));
  const side = 2 * JSON.parse(readFileSync(join(at("torus"), "manifest.json"), "utf8")).arena.half_side_m;
  let crossings = 0;
  let before = null;
  for (let time = 0; time < 60; time += 0.02) {
    mixer.setTime(time);
    const places = robots.map(({ position, scale }) => [position.x, position.y, position.z, scale.x]);
    for (const [i, place] of places.entries()) {
      if (before === null || before[i][3] === 0 || place[3] === 0) continue;
      const step = Math.max(...[0, 1, 2].map((axis) => Math.abs(place[axis] - before[i][axis])));
      assert.ok(step < 0.5 || step > side - 0.5, `${robots[i].name} makes ${step} m at ${time} s`);
      crossings += step > 0.5;
    }
    before = places;
  }
  assert.ok(crossings > 5, `${crossings} crossings`);
});

test("glTF: played by three.js -> robots at their places in agents.csv, walking on the floor", async () => {
  write("walk", "played.glb");
  const { scene, mixer } = await played("played.glb");
  const [header, ...lines] = readFileSync(join(at("walk"), "agents.csv"), "utf8").trim().split("\n").map((line) => line.split(","));
  const rows = lines.map((cells) => Object.fromEntries(header.map((name, i) => [name, cells[i]])));
  for (const time of [2, 8, 14]) {
    mixer.setTime(time);
    scene.updateMatrixWorld(true);
    const alive = rows.filter((row) => Number(row.time_s) === time);
    assert.equal(alive.length, 30);
    for (const row of alive) {
      const robot = scene.getObjectByName(`robot_${row.id}`);
      const place = robot.getWorldPosition(new three.Vector3());
      assert.ok(Math.hypot(place.x - row.x_m, -place.z - row.y_m) < 0.002, `robot ${row.id} at ${time} s`);
      if (process.env.ENGINE === "kinematic") continue;
      const lowest = new three.Box3().setFromObject(robot, true).min.y;
      assert.ok(lowest > -0.01 && lowest < 0.02, `the feet of robot ${row.id} are ${lowest} m above the floor at ${time} s`);
    }
  }
});
