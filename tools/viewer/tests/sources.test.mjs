// SPDX-License-Identifier: MIT
// The page that is linked into programs is what npm's packages make of its sources, byte for byte. VIEWER names the folder of the sources.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, rmSync, symlinkSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";

const room = mkdtempSync(join(tmpdir(), "trophic-viewer-sources-"));
for (const name of ["src", "build.mjs", "package.json", "tsconfig.json"]) cpSync(join(process.env.VIEWER, name), join(room, name), { recursive: true });
symlinkSync(join(process.cwd(), "node_modules"), join(room, "node_modules"));
after(() => rmSync(room, { recursive: true, force: true }));

test("types", () => {
  execFileSync(process.execPath, ["node_modules/typescript/bin/tsc", "--noEmit"], { cwd: room, stdio: "inherit" });
});

test("page/viewer.html is built of src", () => {
  execFileSync(process.execPath, ["build.mjs"], { cwd: room });
  const built = readFileSync(join(room, "built/viewer.html"));
  const kept = readFileSync(join(process.env.VIEWER, "page/viewer.html"));
  assert.ok(built.equals(kept), "tools/viewer/page/viewer.html is not built of tools/viewer/src: cmake --build --preset ci --target viewer");
});
