// SPDX-License-Identifier: MIT
// A run with --live in a real browser. PREDATOR_PREY, OWN_BODIES, WORLDS and CHROMIUM name the programs.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Browser } from "./opened_page.mjs";

const folder = mkdtempSync(join(tmpdir(), "trophic-live-"));
const at = (name) => join(folder, name);
const options = (out, ...more) => ["--backend", "kinematic", "--seed", "7", "--duration", "600", "--out", at(out), ...more];
const started = [];

/** A program with --live: its address, and its end. */
async function start(out, name = process.env.PREDATOR_PREY, given = options(out)) {
  const program = spawn(name, [...given, "--live"]);
  started.push(program);
  const ended = new Promise((resume) => program.on("exit", resume));
  const address = await new Promise((resume, reject) => {
    let text = "";
    program.stdout.on("data", (part) => {
      text += part;
      const found = text.match(/http:\/\/127\.0\.0\.1:\d+\/\?token=\w+/);
      if (found) resume(found[0]);
    });
    program.on("exit", () => reject(new Error("the program ended")));
  });
  return { address, ended };
}

let browser;
before(async () => {
  browser = await (await Browser.start()).with({ viewport: { width: 960, height: 600 } });
});
after(async () => {
  await browser?.close();
  for (const program of started) program.kill("SIGKILL");
  rmSync(folder, { recursive: true, force: true });
});

const tablesOf = (run) => Object.fromEntries(readdirSync(at(run)).filter((name) => /\.(csv|trp)$/.test(name)).map((name) => [name, readFileSync(join(at(run), name), "latin1")]));

/** In the page: pauses the run before its second tick, so that a slow browser sees it from its start. */
function pauseAtOnce() {
  const Socket = window.WebSocket;
  window.WebSocket = class extends Socket {
    constructor(...address) {
      super(...address);
      this.addEventListener("open", () => this.send('{"do": "pause"}'));
    }
  };
}

/** Opens a live page, whose run is paused, and waits until it shows something. */
async function open(address, inBrowser = browser) {
  const opened = await inBrowser.openAt(address, "", pauseAtOnce);
  await opened.until(() => window.trophic?.live?.isVisible && window.trophic.live.state.paused && window.trophic.settled);
  return opened;
}

test("live: run of 600 s with three changes -> shown as it is recorded, and made again from its record to the same bytes", async () => {
  const run = await start("live");
  const opened = await open(run.address);
  const { page } = opened;
  const begun = await opened.evaluate(() => window.trophic.live.newest);
  assert.ok(begun < 60, `paused at ${begun} s`);
  await page.locator(".controls select").selectOption("1");
  await page.keyboard.press("Space");
  await opened.until((before) => window.trophic.live.newest > before, begun);
  await page.keyboard.press("Space");
  await opened.until(() => window.trophic.live.state.paused);
  await page.getByRole("button", { name: "Parameters" }).click();
  const row = page.locator(".number", { hasText: "capture.reach_m" });
  assert.match(await row.locator(".hint").innerText(), /> 0$/);
  await row.locator("input[type=number]").fill("0.5");
  await row.locator("input[type=number]").press("Enter");
  await opened.until(() => window.trophic.live.changes.length === 1);
  assert.equal(await page.locator(".curves .u-over").first().isVisible(), true); // next to the parameters
  await opened.until(() => document.querySelector(".view figcaption .rules").textContent === `paper (capture.reach_m 0.5 at ${window.trophic.live.changes[0].time_s} s)`);
  assert.equal(await row.locator(".back").isVisible(), true);
  assert.equal(await page.locator(".number", { hasText: "mutation.sd" }).locator(".back").isVisible(), false);
  const time = await opened.evaluate(() => window.trophic.live.newest);
  await page.locator("h1").click();
  for (let i = 1; i <= 3; ++i) {
    await page.keyboard.press("ArrowRight");
    await opened.until((wanted) => window.trophic.live.newest >= wanted, time + 2 * i);
  }
  assert.equal(await opened.evaluate(() => window.trophic.live.newest), time + 6);
  const slider = page.locator(".number", { hasText: "mutation.sd" }).locator("input[type=range]");
  await slider.focus();
  await slider.press("ArrowRight");
  await opened.until(() => window.trophic.live.changes.length === 2);
  await row.locator(".back").click();
  await opened.until(() => window.trophic.live.changes.length === 3);
  assert.deepEqual(await opened.evaluate(() => window.trophic.live.changes.map(({ value }) => value).filter((_, i) => i !== 1)), ["0.5", "1"]);
  await row.locator(".back").waitFor({ state: "hidden" });
  await page.locator(".controls select").selectOption("0");
  await page.locator("button.play").click();
  await opened.until(() => window.trophic.live.state.over);
  await opened.until(() => window.trophic.time === window.trophic.lastTime && window.trophic.settled);
  assert.equal(await opened.evaluate(() => window.trophic.lastTime), 600);

  // The page has the individuals, events and last robots of the run's tables.
  const lines = (file) => readFileSync(join(at("live"), file), "utf8").trim().split("\n").slice(1);
  const seen = await opened.evaluate(() => {
    const { run: shown } = window.trophic;
    const row_ = (shown.agents.ticks - 1) * shown.robots;
    return { events: shown.events.length, sentences: shown.catches.map(({ scene }) => scene.sentence), individuals: shown.individuals.size, last: [...shown.agents.id.slice(row_, row_ + shown.robots)], dead: [...shown.individuals.values()].filter((one) => one.death !== Infinity).length };
  });
  const agents = lines("agents.csv").map((line) => line.split(","));
  assert.equal(seen.events, lines("events.csv").length);
  assert.equal(seen.individuals, lines("phylogeny.csv").length);
  const catches = lines("events.csv").map((line) => line.split(",")).filter((cells) => cells[2] === "catch");
  assert.ok(catches.length > 0);
  assert.deepEqual(seen.sentences.map((text) => Number(text.match(/^predator (\d+) catches prey \d+: \w+, lived \d+ s$/)[1])), catches.map((cells) => Number(cells[3])));
  assert.equal(seen.dead, lines("events.csv").filter((line) => line.split(",")[2] === "death").length);
  assert.deepEqual(seen.last, agents.slice(-seen.last.length).map((cells) => Number(cells[3])));
  await opened.untilPixels("#0072b2", (count) => count > 50);
  assert.deepEqual(opened.complaints, []);
  await page.close();
  assert.equal(await run.ended, 0);
  execFileSync(process.env.PREDATOR_PREY, options("again", "--changes", join(at("live"), "changes.csv")));
  assert.deepEqual(tablesOf("live"), tablesOf("again"));
});

test("live: number out of bounds, a second page, another run -> one sentence each, and the run is what it was", async () => {
  const run = await start("hostile");
  const opened = await open(run.address);
  const { page } = opened;
  await page.getByRole("button", { name: "Parameters" }).click();
  const box = page.locator(".number", { hasText: "capture.reach_m" }).locator("input[type=number]");
  await box.fill("-1");
  await box.press("Enter");
  await opened.until(() => document.querySelector(".problem").textContent !== "");
  assert.equal(await page.locator(".problem").innerText(), "rules.capture.reach_m = -1: must be > 0");
  const isInSight = () => {
    const { left, top } = document.querySelector(".problem").getBoundingClientRect();
    return document.elementFromPoint(left + 2, top + 6)?.className === "problem";
  };
  assert.ok(await opened.evaluate(isInSight), "the sentence is scrolled away");
  await opened.until(() => document.querySelector("[aria-label='rules.capture.reach_m']").value === "1");

  const second = await open(run.address);
  await second.page.getByRole("button", { name: "Parameters" }).click();
  assert.equal(await second.page.locator(".numbers .hint").first().innerText(), "Another page steers this run; this one only shows it.");
  assert.equal(await second.page.locator("button.play").isDisabled(), true);
  assert.equal(await second.page.locator(".number input[type=range]").first().isDisabled(), true);
  await second.page.close();

  await page.locator(".again input").fill("11");
  await page.getByRole("button", { name: "Start again" }).click();
  await opened.until(() => window.trophic.live.facts.head.seed === 11 && window.trophic.live.isVisible);
  assert.equal(readFileSync(join(at("hostile"), "changes.csv"), "utf8"), "time_s,tick,number,value,before\n");
  assert.deepEqual(opened.complaints, []);
  await page.close();
});

test("live: individuals with bodies of their own -> each is drawn in its own", async () => {
  const given = ["--out", at("bodies"), "--seed", "3", "--duration", "200", "--set", "rules.body_plan.first_modules=6"];
  const run = await start("bodies", process.env.OWN_BODIES, given);
  const opened = await open(run.address);
  await opened.page.locator(".controls select").selectOption("0");
  await opened.page.keyboard.press("Space");
  await opened.until(() => window.trophic.live.state.over && window.trophic.time === 200 && window.trophic.settled);
  const drawn = await opened.evaluate(() => {
    const { run: shown, worlds, time } = window.trophic;
    const row = shown.rowAt(time);
    return worlds[0].shapeOf.map((shape, body) => [shown.agents.id[row + body], shape.model.links.length - 1]);
  });
  assert.deepEqual(opened.complaints, []);
  await opened.page.close();
  assert.equal(await run.ended, 0);
  const [header, ...lines] = readFileSync(join(at("bodies"), "bodies.csv"), "utf8").trim().split("\n").map((line) => line.split(","));
  const born = new Map(lines.map((cells) => [Number(cells[0]), cells]));
  const settled = drawn.filter(([id]) => Number(born.get(id)[header.indexOf("time_s")]) < 200); // the last newborns are not set down
  assert.ok(settled.length > 20);
  assert.deepEqual(settled, settled.map(([id]) => [id, Number(born.get(id)[header.indexOf("hinges")])]));
});

test("live: numbers that change -> the living are drawn and no others, on their food, with the outputs of brains", async () => {
  const run = await start("pond", process.env.WORLDS, ["--rules", "pond", "--backend", "kinematic", "--duration", "200", "--out", at("pond")]);
  const opened = await open(run.address);
  await opened.page.locator(".controls select").selectOption("0");
  await opened.page.keyboard.press("Space");
  await opened.until(() => window.trophic.live.state.over && window.trophic.time === 200 && window.trophic.settled);
  const [drawn, curves] = await opened.evaluate(() => [[...window.trophic.worlds[0].drawn], window.trophic.run.energy.bySpecies.map((curve) => curve.length)]);
  await opened.untilPixels("#9cc47f", (count) => count > 3000);
  await opened.seek(200, await opened.evaluate(() => [...window.trophic.run.individuals.values()].find(({ birth, death }) => birth < 190 && death === Infinity).id));
  const { energy } = await opened.inspected();
  assert.match(energy, /^\d+\.\d J$/);
  // As fast as it goes, ticks are left out: the curve of speed is there all the same, and rings are those of the last moment.
  await opened.until(() => window.trophic.side.plots.speed.plot !== null);
  const speeds = await opened.evaluate(() => window.trophic.side.plots.speed.plot.data[1].filter((value) => value > 0).length);
  assert.ok(speeds >= 2, `${speeds} points of speed`);
  const [rings, deaths] = await opened.evaluate(() => {
    const { marks, run: shown } = window.trophic.worlds[0];
    const flats = [marks.catches, marks.flashes].map(({ mesh }) => mesh.instanceMatrix.array);
    const drawn_ = flats.flatMap((values) => [...values].filter((value, i) => i % 16 === 0 && value > 0));
    return [drawn_.length, shown.events.filter(({ kind, time }) => (kind === "death" || kind === "activation") && time > 200 - 6).length];
  });
  assert.equal(rings, deaths);
  const angle = opened.page.locator(".number", { hasText: "brain.turn_angle_rad" });
  assert.deepEqual(await angle.locator(".hint").innerText().then((text) => text.match(/\d\.\d+/g)), ["3.14159"]);
  assert.match((await opened.inspected()).outputs, /^turn -?\d\.\d\d, tag -?\d\.\d\d$/);
  assert.deepEqual(opened.complaints, []);
  await opened.page.close();
  const last = readFileSync(join(at("pond"), "agents.csv"), "utf8").trim().split("\n").map((line) => line.split(",")).filter((cells) => cells[0] === "200");
  assert.deepEqual(drawn.flatMap((x, i) => (i % 3 === 0 && !Number.isNaN(x) ? [i / 3] : [])), last.map((cells) => Number(cells[2])));
  assert.ok(curves[0] > 1 && curves[0] === curves[1]);
});

test("live: on a phone and in the dark -> parameters in a sheet from below", async () => {
  const run = await start("phone");
  const phone = await browser.with({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, colorScheme: "dark" });
  const opened = await open(run.address, phone);
  assert.equal(await opened.page.evaluate(() => document.documentElement.scrollWidth), 390);
  assert.equal(await opened.rowsOfControls(), 2);
  await opened.page.getByRole("button", { name: "Details" }).click();
  await opened.page.getByRole("button", { name: "Parameters" }).click();
  assert.equal(await opened.page.locator(".number").first().isVisible(), true);
  await opened.page.close();
});
