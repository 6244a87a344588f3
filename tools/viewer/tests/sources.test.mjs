// SPDX-License-Identifier: MIT
// The page that is linked into programs is what npm's packages make of its sources, byte for byte. VIEWER names the folder of the sources.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, rmSync, symlinkSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { buildSync } from "esbuild";

const room = mkdtempSync(join(tmpdir(), "trophic-viewer-sources-"));
for (const name of ["src", "build.mjs", "package.json", "tsconfig.json"]) cpSync(join(process.env.VIEWER, name), join(room, name), { recursive: true });
symlinkSync(join(process.cwd(), "node_modules"), join(room, "node_modules"));
after(() => rmSync(room, { recursive: true, force: true }));

test("types", () => {
  execFileSync(process.execPath, ["node_modules/typescript/bin/tsc", "--noEmit"], { cwd: room, stdio: "inherit" });
});

test("live: a refusal before a run is said, and a state adds its changes", async () => {
  buildSync({ entryPoints: [join(room, "src/live.ts")], bundle: true, format: "esm", outfile: join(room, "live.mjs"), nodePaths: ["node_modules"] });
  let take;
  Object.assign(globalThis, { window: globalThis, location: { host: "", search: "" }, matchMedia: () => ({ addEventListener() {} }) });
  globalThis.WebSocket = class {
    addEventListener(kind, listener) {
      if (kind === "message") take = (message) => listener({ data: JSON.stringify(message) });
    }
  };
  const heard = [];
  const { connect, Live } = await import(join(room, "live.mjs"));
  connect({ begun() {}, grown() {}, state: () => heard.push("state"), said: (sentence) => heard.push(sentence) });
  take({ kind: "refused", text: "The run ended: no space" });
  assert.deepEqual(heard, ["The run ended: no space"]);
  const live = new Live({ species: [], tags: [], head: { version: 1, robots: 0, joints: 0, species: [], arena: {} } }, null);
  for (const [changes_from, changes] of [[0, ["a", "b"]], [2, []], [2, ["c"]]]) live.hear({ changes_from, changes });
  assert.deepEqual(live.changes, ["a", "b", "c"]);
  live.hear({ changes_from: 0, changes: [] }); // of another run
  assert.deepEqual(live.changes, []);
});

test("page/viewer.html is built of src", () => {
  execFileSync(process.execPath, ["build.mjs"], { cwd: room });
  const built = readFileSync(join(room, "built/viewer.html"));
  const kept = readFileSync(join(process.env.VIEWER, "page/viewer.html"));
  assert.ok(built.equals(kept), "tools/viewer/page/viewer.html is not built of tools/viewer/src: cmake --build --preset ci --target viewer");
});
