// SPDX-License-Identifier: MIT
// A world that --save-mjcf wrote opens in MuJoCo 3 (WebAssembly, by MuJoCo's makers) and moves. PREDATOR_PREY names the program.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import loadMujoco from "@mujoco/mujoco";

for (const arena of ["walled_square", "height_field"]) {
  test(`${arena} opens in MuJoCo 3`, async () => {
    const folder = mkdtempSync(join(tmpdir(), "trophic-mjcf-"));
    const file = join(folder, "world.xml");
    execFileSync(process.env.PREDATOR_PREY, ["--set", `ecology.arena=${arena}`, "--save-mjcf", file]);
    const mujoco = await loadMujoco();
    mujoco.FS.writeFile("/world.xml", readFileSync(file));
    if (arena === "height_field") mujoco.FS.writeFile("/world.hfield", readFileSync(join(folder, "world.hfield")));
    const model = mujoco.MjModel.from_xml_path("/world.xml");
    const data = new mujoco.MjData(model);
    assert.equal(model.nu, 240);
    assert.ok(model.nlight > 0 && model.ncam > 0);
    for (let i = 0; i < 200; ++i) mujoco.mj_step(model, data);
    const heights = Array.from({ length: 30 }, (_, robot) => data.qpos[robot * 11 + 2]);
    assert.ok(heights.every((z) => z > 0.01 && z < 0.3), `robots stand: ${heights}`);
    rmSync(folder, { recursive: true, force: true });
  });
}
