// SPDX-License-Identifier: MIT
// Pages that `trophic show` makes, in a real browser. TROPHIC, PREDATOR_PREY and CHROMIUM name the programs.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Browser } from "./opened_page.mjs";

const folder = mkdtempSync(join(tmpdir(), "trophic-viewer-"));
const at = (name) => join(folder, name);
const run = (name, ...options) => execFileSync(process.env.PREDATOR_PREY, ["--backend", "kinematic", "--out", at(name), ...options.map(String)]);
const show = (name, ...runs) => execFileSync(process.env.TROPHIC, ["show", ...runs.map(at), "--out", at(name)]);
const rows = (run_, file) => {
  const [header, ...lines] = readFileSync(join(at(run_), file), "utf8").trim().split("\n").map((line) => line.split(","));
  return lines.map((cells) => Object.fromEntries(header.map((name, i) => [name, cells[i]])));
};

let browser;
before(async () => {
  run("long", "--seed", 3);
  run("short", "--seed", 4, "--duration", 300);
  run("crowd", "--seed", 5, "--duration", 200, "--robots", 300);
  run("sensing", "--seed", 4, "--duration", 100, "--senses");
  execFileSync(process.env.PREDATOR_PREY, ["--backend", "kinematic", "--out", at("set"), "--replicates", "2", "--duration", "200"]);
  show("long.html", "long");
  show("sensing.html", "sensing");
  show("two.html", "short", "long");
  show("crowd.html", "crowd");
  execFileSync(process.env.TROPHIC, ["show", at("short"), "--from", "75", "--to", "130.5", "--out", at("part.html")]);
  writeFileSync(at("wide.toml"), 'name = "wide"\nside_m = 400\n');
  run("wide", "--duration", 4, "--set", `ecology.arena=${at("wide.toml")}`);
  show("wide.html", "wide");
  browser = await Browser.start();
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** Fails unless the page kept quiet; closes it. */
async function leave(opened) {
  assert.deepEqual(opened.complaints, []);
  assert.deepEqual(opened.requests, []);
  assert.equal(await opened.evaluate(() => window.trophicError), undefined);
  await opened.page.close();
}

test("a run of 6000 s opens within 3 s of work and draws both species", async () => {
  const opened = await browser.open(at("long.html"));
  const busy = await opened.busySeconds();
  assert.ok(busy < 3, `${busy} s`);
  await opened.evaluate(() => window.trophic.seek(1000));
  await opened.settle();
  for (const [species, colour] of [["prey", "#0072b2"], ["predators", "#d55e00"]]) {
    const pixels = await opened.pixels(colour);
    assert.ok(pixels > 100, `${pixels} pixels of ${species}`);
  }
  assert.match(await opened.page.title(), /long/);
  await leave(opened);
});

test("a stretch begins and ends where it was asked to, with those who live then", async () => {
  const opened = await browser.open(at("part.html"));
  assert.deepEqual(await opened.evaluate(() => [window.trophic.firstTime, window.trophic.lastTime]), [75, 130.5]);
  for (const [time, tick] of [[75, 37], [100, 50], [130.5, 65]]) {
    const shown = await opened.evaluate((moment) => {
      const { run } = window.trophic;
      return [...run.agents.id.slice(run.rowAt(moment), run.rowAt(moment) + run.robots)];
    }, time);
    assert.deepEqual(shown, rows("short", "agents.csv").filter((row) => Number(row.tick) === tick).map((row) => Number(row.id)));
  }
  await leave(opened);
});

test("a world of 400 m is drawn as any other, and a press on it leaves the rest alone", async () => {
  const opened = await browser.open(at("wide.html"));
  await opened.settle();
  const pixels = await opened.pixels("#0072b2");
  assert.ok(pixels > 20, `${pixels} pixels of prey`);
  await opened.evaluate(() => {
    window.shownTrees = 0;
    const { phylogeny } = window.trophic;
    const before = phylogeny.show.bind(phylogeny);
    phylogeny.show = (run) => (++window.shownTrees, before(run));
  });
  await opened.click(".view canvas", 40, 40);
  assert.equal(await opened.evaluate(() => window.shownTrees), 0);
  await leave(opened);
});

test("at three events the drawn robot is where events.csv says, to 2 mm", async () => {
  const opened = await browser.open(at("long.html"));
  const catches = rows("long", "events.csv").filter((row) => row.event === "catch");
  for (const event of [catches[0], catches[Math.floor(catches.length / 2)], catches[catches.length - 1]]) {
    await opened.evaluate((time) => window.trophic.seek(time), Number(event.time_s));
    await opened.settle();
    const [x, y] = await opened.evaluate((body) => [...window.trophic.worlds[0].drawn.slice(3 * body, 3 * body + 2)], Number(event.body));
    const off = Math.hypot(x - event.x_m, y - event.y_m);
    assert.ok(off < 0.002, `${off} m at ${event.time_s} s`);
  }
  await leave(opened);
});

test("a click on the bar of time jumps, a click on an event selects whom it happened to", async () => {
  const opened = await browser.open(at("long.html"));
  const [x, y] = await opened.evaluate(() => [window.trophic.timebar.xOf(4321), window.trophic.timebar.canvas.clientHeight - 6]);
  await opened.click(".timebar canvas", x, y);
  assert.ok(Math.abs((await opened.evaluate(() => window.trophic.time)) - 4321) < 6);
  const event = rows("long", "events.csv").filter((row) => row.event === "catch")[5];
  const place = await opened.evaluate((time) => [window.trophic.timebar.xOf(time), window.trophic.timebar.yOf("catches")], Number(event.time_s));
  await opened.click(".timebar canvas", ...place);
  const [time, selected] = await opened.evaluate(() => [window.trophic.time, window.trophic.selected]);
  const there = rows("long", "events.csv").some((row) => row.event === "catch" && Number(row.time_s) === time && Number(row.id) === selected);
  assert.ok(there, `${selected} at ${time} s`);
  await leave(opened);
});

test("a click on a robot selects it, its branch lights up, and a click on its branch leads back", async () => {
  const opened = await browser.open(at("long.html"), "#t=3000&view=top");
  const [body, x, y] = await opened.evaluate(() => {
    const { worlds, runs } = window.trophic;
    const places = Array.from({ length: runs[0].robots }, (_, one) => worlds[0].onScreen(one));
    const lonely = places.map(([px, py], one) => Math.min(...places.map(([qx, qy], other) => (one === other ? 1e9 : Math.hypot(px - qx, py - qy)))));
    const chosen = lonely.indexOf(Math.max(...lonely));
    return [chosen, ...places[chosen]];
  });
  await opened.click(".view canvas", x, y);
  const living = rows("long", "agents.csv").find((row) => row.time_s === "3000" && Number(row.body) === body);
  assert.equal(await opened.evaluate(() => window.trophic.selected), Number(living.id));
  assert.match(await opened.page.locator(".inspector h2").innerText(), new RegExp(`${living.species} ${living.id}$`));
  assert.ok((await opened.page.locator(".inspector").innerText()).includes("perceives"));
  const line = await opened.evaluate(() => window.trophic.phylogeny.placeOf(window.trophic.selected));
  await opened.evaluate(() => window.trophic.select(NaN));
  await opened.settle();
  await opened.click(".phylogeny", ...line);
  const again = await opened.evaluate(() => window.trophic.selected);
  const rowOf = (id) => opened.evaluate((one) => window.trophic.run.individuals.get(one)?.row, id);
  assert.ok(Math.abs((await rowOf(again)) - (await rowOf(Number(living.id)))) <= 4, `${again} for ${living.id}`);
  await leave(opened);
});

test("a branch in the tree lights up its living robots in the world", async () => {
  const opened = await browser.open(at("long.html"), "#t=3000&view=top");
  assert.equal(await opened.pixels("#e8b400"), 0);
  await opened.evaluate(() => {
    const { run, time } = window.trophic;
    const alive = (one) => one.birth <= time && one.death > time;
    const parents = [...run.individuals.values()].filter((one) => !alive(one) && one.children.some(alive));
    window.trophic.select(parents[0].id);
  });
  await opened.settle();
  assert.ok((await opened.pixels("#e8b400")) > 5);
  await leave(opened);
});

test("a link opens at its moment, robot and view, and playing goes on from there", async () => {
  const opened = await browser.open(at("long.html"), "#t=1234&robot=17&view=top");
  assert.deepEqual(await opened.evaluate(() => [window.trophic.time, window.trophic.selected, window.trophic.worlds[0].view]), [1234, 17, "top"]);
  assert.equal(await opened.evaluate(() => window.trophic.link()), "#t=1234&robot=17&view=top");
  await opened.page.keyboard.press("ArrowRight");
  await opened.settle();
  assert.equal(await opened.evaluate(() => window.trophic.time), 1236);
  await opened.page.keyboard.press("Space");
  await opened.page.waitForFunction(() => window.trophic.time > 1237, null, { timeout: 60000 });
  await opened.page.keyboard.press("Space");
  assert.equal(await opened.evaluate(() => window.trophic.playing), false);
  await leave(opened);
});

test("several runs stand side by side on one bar of time", async () => {
  const opened = await browser.open(at("two.html"));
  assert.equal(await opened.page.locator(".view").count(), 2);
  assert.equal(await opened.evaluate(() => window.trophic.lastTime), 6000);
  await opened.evaluate(() => window.trophic.seek(120));
  await opened.settle();
  for (const [number, name] of ["short", "long"].entries()) {
    const blue = await opened.pixels("#0072b2", number);
    assert.ok(blue > 5, `${blue} pixels of prey in ${name}`);
    const rowsThen = rows(name, "agents.csv").filter((row) => row.time_s === "120");
    const drawn = await opened.evaluate((one) => [...window.trophic.worlds[one].drawn], number);
    rowsThen.forEach((row, body) => assert.ok(Math.hypot(drawn[3 * body] - row.x_m, drawn[3 * body + 1] - row.y_m) < 0.002));
  }
  await leave(opened);
});

test("300 robots stay usable", async () => {
  const opened = await browser.open(at("crowd.html"));
  const start = await opened.busySeconds();
  const pictures = 4;
  for (let i = 1; i <= pictures; ++i) {
    await opened.evaluate((time) => window.trophic.seek(time), 43.3 * i);
    await opened.settle();
  }
  const each = ((await opened.busySeconds()) - start) / pictures;
  assert.ok(each < 0.12, `${each} s of work a picture`);
  assert.equal(await opened.evaluate(() => window.trophic.worlds[0].drawn.length), 900);
  await leave(opened);
});

test("a page that was damaged says so", async () => {
  const page = readFileSync(at("long.html"), "utf8");
  const start = page.indexOf('data-file="agents">') + 'data-file="agents">'.length;
  const { writeFileSync } = await import("node:fs");
  writeFileSync(at("damaged.html"), page.slice(0, start + 5000) + "AAAA" + page.slice(start + 5004));
  const opened = await browser.open(at("damaged.html"));
  assert.match(await opened.page.locator(".error").innerText(), /^This page cannot be shown: /);
  await opened.page.close();
});

test("the inspector says what a brain is told, answers and wants, as senses.csv does", async () => {
  const opened = await browser.open(at("sensing.html"));
  const inputs = JSON.parse(readFileSync(join(at("sensing"), "manifest.json"), "utf8")).senses.inputs;
  const fixed = (text) => Number(text).toFixed(2);
  for (const wish of ["denied", "kept", "switched"]) {
    const row = rows("sensing", "senses.csv").find((one) => one.tag_outcome === wish);
    await opened.evaluate(([time, id]) => {
      window.trophic.seek(time);
      window.trophic.select(id);
    }, [Number(row.time_s), Number(row.id)]);
    await opened.settle();
    const said = Object.fromEntries(await opened.page.$$eval(".inspector dt", (terms) => terms.map((term) => [term.textContent, term.nextSibling.textContent])));
    assert.equal(said["brain is told"], inputs.map((name, i) => `${name.replaceAll("_", " ")} ${fixed(row[`input${i}`])}`).join(", "));
    assert.equal(said.outputs, `angle ${fixed(row.angle_output)}, tag ${fixed(row.tag_output)}`);
    assert.equal(said["wants tag"], `${Number(row.chosen_tag) > 0 ? "+" : ""}${row.chosen_tag}, ${{ denied: "denied", kept: "as before", switched: "switched now" }[wish]}`);
    assert.equal(said.touches, undefined); // points have no bodies
  }
  await leave(opened);
});

test("a page of an analysis has its table, and replays a run in a frame of its own", async () => {
  execFileSync(process.env.TROPHIC, ["analyze", at("set"), "--html", at("analysis.html")]);
  const page = await browser.context.newPage();
  const complaints = [];
  const requests = [];
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
  page.on("request", (request) => /^(data|blob):/.test(request.url()) || requests.push(request.url()));
  await page.goto(`file://${at("analysis.html")}`);
  assert.match(await page.locator("pre").textContent(), /velocity/);
  const buttons = page.locator(".replays button");
  assert.deepEqual(await buttons.allTextContents(), ["replicate-00", "replicate-01"]);
  for (const name of ["replicate-01", "replicate-00"]) {
    await page.getByRole("button", { name }).click();
    const frame = page.frames()[1];
    await frame.waitForFunction((name_) => window.trophicError || (document.title.includes(name_) && window.trophic?.settled), name);
    assert.equal(await frame.evaluate(() => window.trophicError), undefined);
    assert.match(await frame.title(), new RegExp(name));
    await frame.evaluate(() => window.trophic.seek(100));
    await frame.waitForFunction(() => window.trophic.settled);
    assert.equal(await frame.evaluate(() => window.trophic.time), 100);
    assert.equal(await frame.getByText("Copy link").count(), 0); // nobody could open it
  }
  assert.deepEqual(complaints, []);
  assert.deepEqual(requests, [`file://${at("analysis.html")}`]);
  await page.close();
});
