// SPDX-License-Identifier: MIT
// Pages that `trophic show` makes, in a real browser. TROPHIC, PREDATOR_PREY, OWN_BODIES, WORLDS and CHROMIUM name the programs.
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
  writeFileSync(at("changes.csv"), "time_s,number,value\n40,rules.capture.reach_m,0.5\n80,rules.capture.reach_m,1\n80,rules.mutation.sd,0.2\n");
  run("changed", "--seed", 4, "--duration", 120, "--changes", at("changes.csv"));
  show("changed.html", "changed");
  run("sensing", "--seed", 4, "--duration", 100, "--senses");
  execFileSync(process.env.PREDATOR_PREY, ["--backend", "kinematic", "--out", at("set"), "--replicates", "2", "--shadow", "--duration", "200"]);
  show("long.html", "long");
  show("short.html", "short");
  show("sensing.html", "sensing");
  show("two.html", "short", "long");
  show("crowd.html", "crowd");
  show("pair.html", "set/replicate-00", "set/shadow/replicate-00");
  execFileSync(process.env.TROPHIC, ["show", at("short"), "--from", "75", "--to", "130.5", "--out", at("part.html")]);
  writeFileSync(at("wide.toml"), 'name = "wide"\nside_m = 400\n');
  run("wide", "--duration", 4, "--set", `ecology.arena=${at("wide.toml")}`);
  show("wide.html", "wide");
  execFileSync(process.env.OWN_BODIES, ["--out", at("bodies"), "--seed", "3", "--duration", "400", "--set", "rules.body_plan.first_modules=6"]);
  show("bodies.html", "bodies");
  const numbers = { "recruitment.spare_bodies": 140, "recruitment.birth_J": 40, "community.predators": 1, "resource.growth_1_s": 0, "resource.seed_1_s": 0 };
  const set = Object.entries(numbers).flatMap(([path, value]) => ["--set", `rules.${path}=${value}`]);
  execFileSync(process.env.WORLDS, ["--rules", "pond", "--backend", "kinematic", "--seed", "4", "--duration", "1000", "--out", at("pond"), ...set]);
  show("pond.html", "pond");
  execFileSync(process.env.WORLDS, ["--rules", "pond_with_refuges", "--backend", "kinematic", "--duration", "60", "--out", at("refuges")]);
  show("refuges.html", "refuges");
  execFileSync(process.env.WORLDS, ["--rules", "two_foods", "--backend", "kinematic", "--duration", "60", "--out", at("foods")]);
  show("foods.html", "foods");
  execFileSync(process.env.WORLDS, ["--rules", "wolf_sheep", "--robots", "200", "--set", "rules.recruitment.sheep.spare_bodies=50", "--set", "rules.metabolism.sheep.gain_J=0", "--duration", "150", "--out", at("meadow")]);
  show("meadow.html", "meadow");
  execFileSync(process.env.TROPHIC, ["show", at("bodies"), "--from", "200", "--to", "300", "--out", at("some_bodies.html")]);
  browser = await Browser.start();
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** Fails if the page made requests or errors; closes it. */
async function leave(opened) {
  assert.deepEqual(opened.complaints, []);
  assert.deepEqual(opened.requests, []);
  assert.equal(await opened.evaluate(() => window.trophicError), undefined);
  await opened.page.close();
}

/** A test of one page, opened at a moment. */
const onPage = (name, [page, moment], look) =>
  test(name, async () => {
    const opened = await browser.open(at(page), moment);
    await look(opened);
    await leave(opened);
  });

onPage("page: run of 6000 s -> opens within 3 s of processor time and draws both species", ["long.html"], async (opened) => {
  const busy = await opened.busySeconds();
  assert.ok(busy < 3, `${busy} s`);
  await opened.seek(1000);
  for (const [species, colour] of [["prey", "#0072b2"], ["predators", "#d55e00"]]) {
    const pixels = await opened.pixels(colour);
    assert.ok(pixels > 100, `${pixels} pixels of ${species}`);
  }
  assert.match(await opened.page.title(), /long/);
});

onPage("page: requested stretch of a run -> begins and ends there, with the individuals that live then", ["part.html"], async (opened) => {
  assert.deepEqual(await opened.evaluate(() => [window.trophic.firstTime, window.trophic.lastTime]), [75, 130.5]);
  for (const [time, tick] of [[75, 37], [100, 50], [130.5, 65]]) {
    const shown = await opened.evaluate((moment) => {
      const { run } = window.trophic;
      return [...run.agents.id.slice(run.rowAt(moment), run.rowAt(moment) + run.robots)];
    }, time);
    assert.deepEqual(shown, rows("short", "agents.csv").filter((row) => Number(row.tick) === tick).map((row) => Number(row.id)));
  }
});

onPage("page: parameters that changed -> marks on the bar of time and on the curves, and the run's own name", ["changed.html"], async (opened) => {
  const { page } = opened;
  assert.match(await page.locator(".view figcaption").innerText(), /^changed paper \(3 changes\), kinematic/);
  const hover = async (selector, time, place) => {
    const bounds = await page.locator(selector).first().boundingBox();
    await page.mouse.move(bounds.x + (await opened.evaluate(place, time)), bounds.y + bounds.height - 8);
  };
  const onBar = (time) => window.trophic.timebar.xOf(time);
  await hover(".timebar canvas", 80, onBar);
  assert.equal(await page.locator(".timebar .tip").innerText(), "80 s: capture.reach_m 0.5 → 1; mutation.sd 0.05 → 0.2");
  await hover(".timebar canvas", 60, onBar);
  assert.equal(await page.locator(".timebar .tip").isVisible(), false);
  await hover(".plot .u-over", 40, (time) => window.trophic.side.plots.population.plot.valToPos(time, "x"));
  assert.equal(await page.locator(".plot .u-over").first().getAttribute("title"), "40 s: capture.reach_m 1 → 0.5");
  const marked = await opened.evaluate(() => {
    const { canvas } = window.trophic.timebar;
    const [r, g, b] = canvas.getContext("2d").getImageData(Math.round((window.trophic.timebar.xOf(40) * canvas.width) / canvas.clientWidth), 30, 1, 1).data;
    return [r, g, b];
  });
  assert.deepEqual(marked, [0x8a, 0x2b, 0xe2]);
});

onPage("page: world of 400 m -> drawn as any other, and a press on it changes nothing else", ["wide.html"], async (opened) => {
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
});

/** At a moment of the page: (individual, hinges of the body in which it is drawn), and how many boxes are drawn. */
const shapes = (opened, time) =>
  opened.evaluate(async (moment) => {
    const app = window.trophic;
    app.seek(moment);
    while (!app.settled) await new Promise(requestAnimationFrame);
    const { run, worlds } = app;
    const row = run.rowAt(moment);
    const drawn = worlds[0].shapeOf.map((shape, body) => [run.agents.id[row + body], shape.model.links.length - 1]);
    return { drawn, boxes: worlds[0].bodies.boxes.count, wanted: worlds[0].shapeOf.reduce((sum, shape) => sum + shape.boxes.length, 0) };
  }, time);

test("page: individuals with bodies of their own -> each is drawn in its own, in a stretch of the run too", async () => {
  const hinges = new Map(rows("bodies", "bodies.csv").map((row) => [Number(row.id), Number(row.hinges)]));
  assert.ok(new Set(hinges.values()).size > 3);
  for (const [page, times] of [["bodies.html", [1, 51, 399]], ["some_bodies.html", [201, 299]]]) {
    const opened = await browser.open(at(page));
    for (const time of times) {
      const { drawn, boxes, wanted } = await shapes(opened, time); // half a tick after the births, when bodies are set down
      assert.deepEqual(drawn, drawn.map(([id]) => [id, hinges.get(id)]));
      assert.equal(boxes, wanted);
    }
    await opened.evaluate(() => window.trophic.select(window.trophic.run.agents.id[window.trophic.run.rowAt(window.trophic.time)]));
    await opened.settle();
    assert.match(await opened.page.locator(".inspector").innerText(), /\d+: modules, \d+ hinges?/);
    await leave(opened);
  }
});

onPage("page: newborn with a body of its own -> appears where it is set down, without a glide from the body before", ["bodies.html"], async (opened) => {
  const births = rows("bodies", "events.csv").filter((row) => row.event === "birth" && Number(row.time_s) > 0).slice(0, 20);
  const places = await opened.evaluate(async (wanted) => {
    const { run } = window.trophic;
    const { recording } = run;
    const pose = new Float32Array(recording.poseSize);
    const found = [];
    for (const { time, body } of wanted) {
      const frame = recording.frameAt(time);
      await recording.prepare(frame);
      const at = (moment) => (recording.poseInto(pose, moment, body), [pose[0], pose[1]]);
      found.push([at(time), at(0.9 * recording.time(frame + 1) + 0.1 * time), at(recording.time(frame + 1))]);
    }
    return found;
  }, births.map((row) => ({ time: Number(row.time_s), body: Number(row.body) })));
  for (const [death, between] of places) assert.deepEqual(between, death);
  assert.ok(places.some(([death, , born]) => Math.hypot(death[0] - born[0], death[1] - born[1]) > 0.001));
});

onPage("page: three events -> the drawn robot is at the place in events.csv, to 2 mm", ["long.html"], async (opened) => {
  const catches = rows("long", "events.csv").filter((row) => row.event === "catch");
  for (const event of [catches[0], catches[Math.floor(catches.length / 2)], catches[catches.length - 1]]) {
    await opened.seek(Number(event.time_s));
    const [x, y] = await opened.evaluate((body) => [...window.trophic.worlds[0].drawn.slice(3 * body, 3 * body + 2)], Number(event.body));
    const off = Math.hypot(x - event.x_m, y - event.y_m);
    assert.ok(off < 0.002, `${off} m at ${event.time_s} s`);
  }
});

onPage("page: numbers go from 10 to 70 and down to 20 -> the living are drawn at their places and no others, with curves of energy and food on the floor", ["pond.html", "#t=0&view=top"], async (opened) => {
  const green = [];
  for (const time of [0, 60, 420, 425.9, 1000]) {
    await opened.seek(time);
    const alive = rows("pond", "agents.csv").filter((row) => Number(row.tick) === Math.floor(time / 2));
    const [drawn, counts] = await opened.evaluate(() => [[...window.trophic.worlds[0].drawn], window.trophic.counts.map((one) => Number.parseFloat(one.textContent))]);
    const bodies = alive.map((row) => Number(row.body));
    assert.deepEqual(drawn.flatMap((x, i) => (i % 3 === 0 && !Number.isNaN(x) ? [i / 3] : [])), bodies);
    const off = (row) => Math.hypot(drawn[3 * row.body] - row.x_m, drawn[3 * row.body + 1] - row.y_m);
    for (const row of alive) assert.ok(off(row) < (time % 2 ? 0.4 : 0.002), `${row.id} is ${off(row)} m away at ${time} s`);
    assert.deepEqual(counts, ["prey", "predator"].map((species) => alive.filter((row) => row.species === species).length));
    green.push(await opened.pixels("#9cc47f"));
  }
  assert.ok(green[0] > 1.5 * green[2] && green[2] > 1.5 * green[4], `${green} pixels of food`);
  const shown = await opened.evaluate(() => window.trophic.side.plots.energy.plot.data.map((values) => [...values]));
  const energy = rows("pond", "energy.csv").filter((row) => row.species === "prey").map((row) => Number(row.stock_J));
  assert.equal(shown[1].length, energy.length);
  energy.forEach((stock_J, i) => assert.ok(Math.abs(shown[1][i] - stock_J) <= 1e-3 * stock_J));
});

onPage("page: two foods -> each in the legend with its colour, both on the floor", ["foods.html", "#t=0&view=top"], async (opened) => {
  const foods = await opened.page.$$eval("header .legend li:has(i.food)", (items) => items.map((item) => [item.textContent, item.firstChild.style.getPropertyValue("--mark")]));
  assert.deepEqual(foods, [["grass, up to 15 J a cell", "#9cc47f"], ["fruit, up to 15 J a cell", "#c7a1db"]]);
  const both = await opened.pixels("#8c8b78"); // each filters the light of the floor
  assert.ok(both > 3000 && (await opened.pixels("#9cc47f")) < 0.1 * both, `${both} pixels of both foods`);
});

onPage("page: click on the time bar -> jumps, click on an event -> selects its individual", ["long.html"], async (opened) => {
  const [x, y] = await opened.evaluate(() => [window.trophic.timebar.xOf(4321), window.trophic.timebar.canvas.clientHeight - 6]);
  await opened.click(".timebar canvas", x, y);
  assert.ok(Math.abs((await opened.evaluate(() => window.trophic.time)) - 4321) < 6);
  const event = rows("long", "events.csv").filter((row) => row.event === "catch")[5];
  const place = await opened.evaluate((time) => [window.trophic.timebar.xOf(time), window.trophic.timebar.yOf("catches")], Number(event.time_s));
  await opened.click(".timebar canvas", ...place);
  const [time, selected] = await opened.evaluate(() => [window.trophic.time, window.trophic.selected]);
  const there = rows("long", "events.csv").some((row) => row.event === "catch" && Number(row.time_s) === time && Number(row.id) === selected);
  assert.ok(there, `${selected} at ${time} s`);
});

onPage("page: click on a robot -> selected and its branch highlighted, click on its branch -> selects it again", ["long.html", "#t=3000&view=top"], async (opened) => {
  await opened.frames();
  const [body, x, y] = await opened.evaluate(() => {
    const { worlds, runs } = window.trophic;
    const places = Array.from({ length: runs[0].robots }, (_, one) => worlds[0].onScreen(one));
    const lonely = places.map(([px, py], one) => Math.min(...places.map(([qx, qy], other) => (one === other ? 1e9 : Math.hypot(px - qx, py - qy)))));
    const chosen = lonely.indexOf(Math.max(...lonely));
    return [chosen, ...places[chosen]];
  });
  await opened.click(".view canvas", x, y);
  const living = rows("long", "agents.csv").find((row) => row.time_s === "3000" && Number(row.body) === body);
  await opened.until((id) => window.trophic.selected === id, Number(living.id));
  await opened.settle();
  assert.match(await opened.page.locator(".inspector h2").innerText(), new RegExp(`${living.species} ${living.id}$`));
  assert.ok((await opened.page.locator(".inspector").innerText()).includes("perceives"));
  await opened.evaluate(() => window.trophic.select(NaN));
  await opened.frames();
  await opened.settle();
  await opened.click(".phylogeny", ...(await opened.evaluate((id) => window.trophic.phylogeny.placeOf(id), Number(living.id))));
  await opened.until(() => window.trophic.selected >= 0);
  const again = await opened.evaluate(() => window.trophic.selected);
  const rowOf = (id) => opened.evaluate((one) => window.trophic.run.individuals.get(one)?.row, id);
  assert.ok(Math.abs((await rowOf(again)) - (await rowOf(Number(living.id)))) <= 4, `${again} for ${living.id}`);
});

onPage("page: branch selected in the tree -> its living robots are highlighted in the world", ["long.html", "#t=3000&view=top"], async (opened) => {
  assert.equal(await opened.pixels("#e8b400"), 0);
  await opened.evaluate(() => {
    const { run, time } = window.trophic;
    const alive = (one) => one.birth <= time && one.death > time;
    const parents = [...run.individuals.values()].filter((one) => !alive(one) && one.children.some(alive));
    window.trophic.select(parents[0].id);
  });
  await opened.settle();
  assert.ok((await opened.pixels("#e8b400")) > 5);
});

/** The catches of a run, with the victim's origin and age at its death. */
function catches(name) {
  const births = new Map(rows(name, "events.csv").filter((row) => row.event === "birth").map((row) => [row.id, row]));
  return rows(name, "events.csv").filter((row) => row.event === "catch").map((row) => {
    const victim = births.get(row.victim_id);
    return { ...row, time: Number(row.time_s), victim, text: `${row.species} ${row.id} catches ${victim.species} ${row.victim_id}: ${victim.origin}, lived ${(row.time_s - victim.time_s).toFixed(0)} s` };
  });
}

onPage("page: no moment in its address -> plays the first catch without a flaw by one that inherited its genome, from inside the arena", ["long.html", ""], async (opened) => {
  const event = await opened.evaluate(() => ({ ...window.trophic.event, playing: window.trophic.playing, speed: window.trophic.speed, now: window.openedAt }));
  const births = new Map(rows("long", "events.csv").filter((row) => row.event === "birth").map((row) => [row.id, row]));
  const all = await opened.evaluate(() => window.trophic.run.catches.map(({ id, other, time, scene }) => ({ id, other, time, remark: scene.remark })));
  const bornAt = (id) => Number(births.get(String(id)).time_s);
  for (const { id, other, time, remark } of all) assert.equal(remark.includes("was born"), time - Math.max(bornAt(id), bornAt(other)) < 8, remark);
  const first = all.find((one) => one.remark === "" && births.get(String(one.id)).origin === "inherited");
  assert.deepEqual([event.kind, event.id, event.time], ["catch", first.id, first.time]);
  const [eye, half] = await opened.evaluate(() => [window.trophic.worlds[0].camera.position.toArray(), window.trophic.run.recording.head.arena.half_side_m]);
  assert.ok(Math.max(Math.abs(eye[0]), Math.abs(eye[1])) < half, `${eye}`);
  assert.deepEqual([event.playing, event.speed], [true, 1]);
  assert.ok(event.now >= first.time - 8 && event.now < first.time, `${event.now} s`);
});

onPage("next catch begins before it, plays at 1x, names both and shows the victim in its body when it is caught", ["long.html", "#t=1000"], async (opened) => {
  const next = catches("long").find((one) => one.time > 1000);
  assert.equal(await opened.pixels("#c2002f"), 0);
  await opened.page.keyboard.press("n");
  const begun = await opened.evaluate(() => [window.trophic.time, window.trophic.speed, window.trophic.playing, window.trophic.selected]);
  assert.ok(begun[0] >= next.time - 8 && begun[0] < next.time, `${begun[0]} s`);
  assert.deepEqual(begun.slice(1), [1, true, Number(next.id)]);
  // The moment stands for a second: what is seen then is kept by the page.
  await opened.evaluate(() => {
    const app = window.trophic;
    const banner = document.querySelector(".banner");
    window.stood = {};
    const look = (now) => {
      const { stood } = window;
      if (app.time < app.event.time && !banner.hidden) stood.before ??= banner.textContent;
      if (stood.before && app.time < app.event.time - 0.3) app.time = app.event.time - 0.3;
      if (app.time === app.event.time) stood.from ??= now;
      if (stood.from && app.time === app.event.time && app.settled && !stood.text) {
        stood.text = banner.textContent;
        stood.rowIsBefore = app.rowTime < app.time;
        stood.names = [...document.querySelectorAll(".tag:not(.small)")].filter((tag) => !tag.hidden).map((tag) => tag.textContent).sort();
        stood.picture = app.worlds[0].picture();
      }
      if (app.time > app.event.time) stood.ms ??= now - stood.from;
      if (stood.ms === undefined) requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
  await opened.until(() => window.stood.ms !== undefined);
  const { before, text, rowIsBefore, names, picture } = await opened.evaluate(() => window.stood);
  assert.match(before, new RegExp(`^${next.text} \\(in \\d s\\)( · .*)?$`));
  assert.equal(text.split(" · ")[0], next.text);
  assert.equal(rowIsBefore, true);
  assert.deepEqual(names, [`${next.species} ${next.id}`, `${next.victim.species} ${next.victim_id}`].sort());
  assert.ok((await opened.pixels("#c2002f", 0, picture)) > 100);
  assert.ok((await opened.evaluate(() => window.stood.ms)) >= 1000, "the moment stands still");
  await opened.until(() => window.trophic.scene === null);
  assert.deepEqual(await opened.evaluate(() => [window.trophic.playing, window.trophic.speed]), [false, 10]);
});

onPage("n and p go through the catches one by one, and Esc ends the scene", ["long.html", "#t=0"], async (opened) => {
  const times = catches("long").map((one) => one.time);
  const at_ = () => opened.evaluate(() => window.trophic.event.time);
  for (const expected of [times[0], times[1], times[2]]) {
    await opened.page.keyboard.press("n");
    assert.equal(await at_(), expected);
  }
  await opened.page.keyboard.press("p");
  assert.equal(await at_(), times[1]);
  await opened.page.keyboard.press("Escape");
  assert.deepEqual(await opened.evaluate(() => [window.trophic.scene, window.trophic.speed, window.trophic.playing]), [null, 10, false]);
});

onPage("a click on a catch in the bar of time shows the victim still in its body", ["long.html"], async (opened) => {
  const event = catches("long")[5];
  await opened.evaluate((time) => window.trophic.show(window.trophic.run.catches.find((one) => one.time === time)), event.time);
  await opened.settle();
  const shown = await opened.evaluate((body) => window.trophic.run.agents.id[window.trophic.run.rowAt(window.trophic.rowTime) + body], Number(event.victim.body));
  assert.equal(shown, Number(event.victim_id));
  assert.equal((await opened.page.locator(".banner.happened").innerText()).split(" · ")[0], event.text);
  assert.ok((await opened.pixels("#c2002f")) > 10);
});

onPage("the list of events has every catch, is searched by words, and a line plays its catch", ["long.html"], async (opened) => {
  await opened.page.keyboard.press("e");
  const all = catches("long");
  assert.equal(await opened.page.locator(".events .hint").innerText(), `${all.length} events`);
  assert.match(await opened.page.locator(".events li").nth(3).innerText(), new RegExp(all[3].text));
  await opened.page.keyboard.press("/");
  await opened.page.keyboard.type(all[7].victim_id);
  const found = all.filter((one) => one.id === all[7].victim_id || one.victim_id === all[7].victim_id || one.time_s === all[7].victim_id || one.text.split(/[\s:,]+/).includes(all[7].victim_id));
  assert.equal(await opened.page.locator(".events li").count(), found.length);
  await opened.page.locator(".events li button", { hasText: all[7].text }).click();
  assert.equal(await opened.evaluate(() => window.trophic.scene.scene.time_s), all[7].time);
  await opened.page.locator(".events select").selectOption("birth");
  assert.match(await opened.page.locator(".events .hint").innerText(), /^0 events$|^\d+ events?$/);
});

onPage("keys: help, speed, start, end", ["short.html", "#t=100"], async (opened) => {
  const { page } = opened;
  await page.keyboard.press("?");
  assert.equal(await page.locator("dialog.help").isVisible(), true);
  const help = await page.locator("dialog.help").innerText();
  for (const word of ["space", "Home", "End", "Esc", "next catch", "caught", "perceives"]) assert.ok(help.includes(word), word);
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("dialog.help").isVisible(), false);
  await page.keyboard.press("End");
  assert.equal(await opened.evaluate(() => window.trophic.time), 300);
  await page.keyboard.press("Home");
  assert.equal(await opened.evaluate(() => window.trophic.time), 0);
  for (const [key, speed] of [["ArrowUp", 20], ["+", 50], ["ArrowDown", 20], ["-", 10]]) {
    await page.keyboard.press(key);
    assert.equal(await opened.evaluate(() => window.trophic.speed), speed);
  }
  for (const [key, view] of [["t", "top"], ["f", "follow"], ["o", "orbit"]]) {
    await page.keyboard.press(key);
    assert.equal(await opened.evaluate(() => window.trophic.view), view);
  }
});

onPage("every mark is in the legend, with how many live now", ["short.html", "#t=100"], async (opened) => {
  const words = await opened.page.$$eval("header .legend li", (items) => items.map((item) => item.textContent));
  const alive = (species) => rows("short", "agents.csv").filter((row) => row.time_s === "100" && row.species === species).length;
  assert.deepEqual(words, [`prey ${alive("prey")}`, `predator ${alive("predator")}`, "tag +1", "tag -1", "not yet active", "caught", "other death", "becomes active", "selected", "its branch", "trail", "perceives"]);
});

onPage("page: refuges -> their edges on the floor and their name in the legend", ["refuges.html", "#t=0&view=top"], async (opened) => {
  assert.ok((await opened.page.locator("header .legend").innerText()).includes("refuge"));
  const pixels = await opened.pixels("#4a5968");
  assert.ok(pixels > 300, `${pixels} pixels of edges`);
});

onPage("page: world without tags, activation and newborns -> says nothing of them, but the energy of each and when a species died out", ["meadow.html"], async (opened) => {
  const legend = () => opened.page.$$eval("header .legend li", (items) => items.map((item) => item.textContent.trim()));
  const words = (await legend()).join();
  assert.ok(!/tag|active/.test(words) && words.includes("other death"), words);
  assert.equal(await opened.evaluate(() => window.trophic.side.plots.tags.element.hidden), true);
  const [row] = rows("meadow", "agents.csv").filter(({ time_s, id }) => time_s === "2" && Number(id) > 3);
  await opened.seek(2, Number(row.id));
  const said = await opened.inspected();
  assert.equal(said.energy, `${Number(Number(row.energy_J).toPrecision(6))} J`);
  assert.ok(!("tag" in said) && !said.brain.includes("tag"), JSON.stringify(said));
  const died = Math.max(...rows("meadow", "phylogeny.csv").filter(({ species }) => species === "sheep").map((one) => Number(one.destruction_time)));
  await opened.seek(150);
  assert.equal((await legend())[0], `sheep 0, died out at ${died} s`);
  await opened.seek(0);
  assert.match((await legend())[0], /^sheep \d+$/);
  await opened.page.keyboard.press("e");
  assert.deepEqual(await opened.page.$$eval(".events option", (all) => all.filter((one) => !one.hidden).map((one) => one.value)), ["", "catch", "death", "birth"]);
});

test("page: curves and phylogeny of a pond in a window of 1280 x 720 -> all in sight, and with a robot selected all within reach", async () => {
  const small = await browser.with({ viewport: { width: 1280, height: 720 } });
  const opened = await small.open(at("pond.html"), "#t=500");
  await opened.until(() => window.trophic.side.plots.speed.plot !== null);
  /** How many pixels of the parts of the side bar are cut off, where they are or after scrolling to each. */
  const cutOff = (scrolls) =>
    opened.evaluate((isScrolled) => {
      const parts = [...document.querySelectorAll("aside .plot"), document.querySelector("aside .phylogeny")].filter((part) => part.offsetParent !== null);
      const hidden = (part) => {
        if (isScrolled) part.scrollIntoView({ block: "nearest" });
        const own = part.getBoundingClientRect();
        let [top, bottom] = [own.top, own.bottom];
        for (let around = part.parentElement; around; around = around.parentElement) {
          const bounds = around.getBoundingClientRect();
          if (getComputedStyle(around).overflowY === "visible") continue;
          top = Math.max(top, bounds.top);
          bottom = Math.min(bottom, bounds.bottom);
        }
        return Math.max(0, Math.round(own.height - (bottom - top)));
      };
      return [parts.length, Math.min(...parts.map((part) => part.clientHeight)), ...parts.map(hidden)];
    }, scrolls);
  for (const id of [undefined, 3]) {
    await opened.seek(500, id);
    const [count, least, ...hidden] = await cutOff(id !== undefined);
    assert.equal(count, 5); // individuals, energy, tags, speed, phylogeny
    assert.ok(least > 50, `${least} pixels`);
    assert.ok(hidden.every((pixels) => pixels === 0), `${hidden} pixels are cut off`);
  }
  await leave(opened);
});

test("in dark surroundings page and world are dark, and turn light again", async () => {
  const dark = await browser.with({ viewport: { width: 1280, height: 800 }, colorScheme: "dark" });
  const opened = await dark.open(at("short.html"), "#t=100");
  const brightness = () => opened.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).slice(0, 3).reduce((a, b) => a + Number(b), 0) / 3);
  assert.ok((await brightness()) < 60);
  assert.ok((await opened.pixels("#12171d")) > 10000);
  await opened.page.emulateMedia({ colorScheme: "light" });
  await opened.untilPixels("#12171d", (found) => found < 100);
  assert.ok((await brightness()) > 200);
  await leave(opened);
});

test("on a phone controls take two rows, and a sheet from below has the rest", async () => {
  const phone = await browser.with({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const opened = await phone.open(at("short.html"), "#t=100");
  const { page } = opened;
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  assert.ok((await opened.rowsOfControls()) <= 2);
  assert.equal(await page.locator("aside").isVisible(), false);
  await page.getByRole("button", { name: "Details" }).click();
  await page.waitForFunction(() => Math.abs(document.querySelector("aside").getBoundingClientRect().bottom - innerHeight) < 1);
  await opened.evaluate(() => window.trophic.select(5));
  await opened.settle();
  assert.match(await page.locator(".inspector h2").innerText(), /5$/);
  await page.locator("aside .close").click();
  await page.waitForFunction(() => getComputedStyle(document.querySelector("aside")).visibility === "hidden");
  await leave(opened);
});

onPage("extinct branches are collapsed: lines of those who have living descendants remain", ["long.html", "#t=6000"], async (opened) => {
  const whole = await opened.evaluate(() => window.trophic.phylogeny.lines);
  const taxa = rows("long", "phylogeny.csv");
  assert.equal(whole, taxa.length);
  const kept = new Set();
  const parent = new Map(taxa.map((row) => [row.id, row.ancestor_id]));
  for (const row of taxa) {
    if (row.destruction_time !== "inf") continue;
    for (let id = row.id; id !== undefined && !kept.has(id); id = parent.get(id) === id ? undefined : parent.get(id)) kept.add(id);
  }
  await opened.page.getByText("collapse extinct branches").click();
  assert.equal(await opened.evaluate(() => window.trophic.phylogeny.lines), kept.size);
  await opened.page.getByText("collapse extinct branches").click();
  assert.equal(await opened.evaluate(() => window.trophic.phylogeny.lines), whole);
});

onPage("the inspector says in words where the one is that a robot perceives", ["long.html", "#t=3000"], async (opened) => {
  const row = rows("long", "agents.csv").find((one) => one.time_s === "3000" && one.adversary_id !== "");
  await opened.seek(3000, Number(row.id));
  const said = await opened.inspected();
  const other = rows("long", "agents.csv").find((one) => one.time_s === "3000" && one.id === row.adversary_id);
  const bearing = Math.atan2(other.y_m - row.y_m, other.x_m - row.x_m) - Number(row.heading_rad);
  const off = (Math.atan2(Math.sin(bearing), Math.cos(bearing)) * 180) / Math.PI;
  const side = off > 0 ? "to the left" : "to the right";
  const size = Math.abs(off);
  const words = size < 15 ? "straight ahead" : size < 65 ? `ahead ${side}` : size < 115 ? side : size < 165 ? `behind ${side}` : "straight behind";
  assert.equal(said.perceives, `${other.species} ${other.id}, ${Math.hypot(other.x_m - row.x_m, other.y_m - row.y_m).toFixed(1)} m ${words}`);
});

test("a browser without WebGL says so and still shows curves, phylogeny, events and the robot", async () => {
  const without = await browser.with({ viewport: { width: 1280, height: 800 } });
  await without.context.addInitScript(() => {
    const before = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
      return kind.startsWith("webgl") ? null : before.call(this, kind, ...more);
    };
  });
  const opened = await without.open(at("short.html"), "#t=100&robot=5");
  assert.match(await opened.page.locator(".view .error").innerText(), /^This browser cannot draw the world/);
  assert.match(await opened.page.locator(".inspector h2").innerText(), /5$/);
  assert.ok((await opened.page.locator(".u-over").count()) >= 2);
  await opened.page.keyboard.press("e");
  assert.ok((await opened.page.locator(".events li").count()) > 0);
  assert.equal(await opened.evaluate(() => window.trophicError), undefined);
  await opened.page.close();
});

onPage("lanes with more events than fit are drawn by density", ["long.html", "#t=100"], async (opened) => {
  const many = rows("long", "events.csv").filter((row) => row.event === "birth").length;
  const width = await opened.evaluate(() => window.trophic.timebar.canvas.clientWidth);
  assert.deepEqual(await opened.evaluate(() => window.trophic.timebar.denseLanes), many > 0.5 * (width - 118) ? ["births"] : []);
  await opened.page.setViewportSize({ width: 640, height: 800 });
  await opened.until(() => window.trophic.timebar.denseLanes.includes("births"));
});

onPage("a link opens at its moment, robot and view, playing continues from there, and the address follows", ["long.html", "#t=1234&robot=17&view=top"], async (opened) => {
  assert.deepEqual(await opened.evaluate(() => [window.trophic.time, window.trophic.selected, window.trophic.worlds[0].view]), [1234, 17, "top"]);
  assert.equal(await opened.evaluate(() => window.trophic.link()), "#t=1234&robot=17&view=top");
  await opened.page.keyboard.press("ArrowRight");
  await opened.settle();
  assert.equal(await opened.evaluate(() => window.trophic.time), 1236);
  await opened.page.keyboard.press("Space");
  await opened.until(() => window.trophic.time > 1237);
  await opened.page.keyboard.press("Space");
  assert.equal(await opened.evaluate(() => window.trophic.playing), false);
  await opened.seek(140, 5);
  await opened.until(() => location.hash === "#t=140&robot=5&view=top");
});

onPage("page: several runs -> side by side on one time bar", ["two.html"], async (opened) => {
  assert.equal(await opened.page.locator(".view").count(), 2);
  assert.equal(await opened.evaluate(() => window.trophic.lastTime), 6000);
  await opened.seek(120);
  for (const [number, name] of ["short", "long"].entries()) {
    const blue = await opened.pixels("#0072b2", number);
    assert.ok(blue > 5, `${blue} pixels of prey in ${name}`);
    const rowsThen = rows(name, "agents.csv").filter((row) => row.time_s === "120");
    const drawn = await opened.evaluate((one) => [...window.trophic.worlds[one].drawn], number);
    rowsThen.forEach((row, body) => assert.ok(Math.hypot(drawn[3 * body] - row.x_m, drawn[3 * body + 1] - row.y_m) < 0.002));
  }
});

onPage("two runs of one name are labelled by their folders, and a shadow is labelled as one", ["pair.html", "#t=10"], async (opened) => {
  const captions = await opened.page.locator("figcaption").allInnerTexts();
  assert.match(captions[0], /^set\/replicate-00 paper, kinematic/);
  assert.match(captions[1], /^shadow\/replicate-00 .* neutral shadow$/);
  assert.equal(captions[0].includes("shadow"), false);
});

onPage("300 robots stay usable", ["crowd.html"], async (opened) => {
  const start = await opened.busySeconds();
  const pictures = 4;
  for (let i = 1; i <= pictures; ++i) {
    await opened.seek(43.3 * i);
  }
  const each = ((await opened.busySeconds()) - start) / pictures;
  assert.ok(each < 0.12, `${each} s of work a picture`);
  assert.equal(await opened.evaluate(() => window.trophic.worlds[0].drawn.length), 900);
});

test("page: damaged -> shows an error", async () => {
  const page = readFileSync(at("long.html"), "utf8");
  const start = page.indexOf('data-file="agents">') + 'data-file="agents">'.length;
  const { writeFileSync } = await import("node:fs");
  writeFileSync(at("damaged.html"), page.slice(0, start + 5000) + "AAAA" + page.slice(start + 5004));
  const opened = await browser.open(at("damaged.html"));
  assert.match(await opened.page.locator(".error").innerText(), /^This page cannot be shown: /);
  await opened.page.close();
});

onPage("inspector: run with senses.csv -> a brain's inputs, outputs and wanted tag as in the table", ["sensing.html"], async (opened) => {
  const inputs = JSON.parse(readFileSync(join(at("sensing"), "manifest.json"), "utf8")).senses.inputs;
  const fixed = (text) => Number(text).toFixed(2);
  for (const wish of ["denied", "kept", "switched"]) {
    const row = rows("sensing", "senses.csv").find((one) => one.tag_outcome === wish);
    await opened.seek(Number(row.time_s), Number(row.id));
    const said = await opened.inspected();
    assert.equal(said["brain's inputs"], inputs.map((name, i) => `${name.replaceAll("_", " ")} ${fixed(row[`input${i}`])}`).join(", "));
    assert.equal(said.outputs, `turn ${fixed(row.angle_output)}, tag ${fixed(row.tag_output)}`);
    assert.equal(said["wants tag"], `${Number(row.chosen_tag) > 0 ? "+" : ""}${row.chosen_tag}, ${{ denied: "denied", kept: "as before", switched: "switched now" }[wish]}`);
    assert.equal(said.touches, undefined); // points have no bodies
  }
});

test("a page of an analysis has its table, sorts it, gives its data, and replays a run in a frame of its own", async () => {
  execFileSync(process.env.TROPHIC, ["analyze", at("set"), "--html", at("analysis.html")]);
  const page = await browser.context.newPage();
  const complaints = [];
  const requests = [];
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
  page.on("request", (request) => /^(data|blob):/.test(request.url()) || requests.push(request.url()));
  await page.goto(`file://${at("analysis.html")}`);
  assert.match(await page.locator("details pre").textContent(), /velocity/);
  assert.match(await page.locator(".question").innerText(), /^Does inheritance matter under the rules of paper\?/);
  assert.match(await page.locator(".findings").innerText(), /Too few runs for a test: 6 are needed, paper has 2\./);
  assert.match(await page.locator(".commands").innerText(), /trophic analyze \S*set --html \S*analysis.html$/m);
  const { rules } = JSON.parse(readFileSync(join(at("set"), "replicate-00/manifest.json"), "utf8"));
  assert.deepEqual(await page.$$eval(".rules dt", (slots) => slots.map((slot) => [slot.textContent, slot.nextSibling.textContent])), Object.entries(rules));
  const means = async () => (await page.$$eval(".results tbody tr", (lines) => lines.map((line) => Number(line.cells[1].dataset.key))));
  const before = await means();
  await page.locator(".results th button", { hasText: "ours [95 %]" }).click();
  assert.deepEqual(await means(), before.toSorted((a, b) => a - b));
  await page.locator(".results th button", { hasText: "ours [95 %]" }).click();
  assert.deepEqual(await means(), before.toSorted((a, b) => b - a));
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("link", { name: "metrics.csv" }).click()]);
  assert.match(readFileSync(await download.path(), "utf8"), /^set,run,seed,metric,species,group,baseline,time_s,value,unit\npaper,replicate-00,/);
  await page.locator("iframe").scrollIntoViewIfNeeded();
  await page.waitForFunction(() => document.querySelector("[data-replay='0']").getAttribute("aria-pressed") === "true");
  const buttons = page.locator(".replays button");
  assert.deepEqual(await buttons.allTextContents(), ["replicate-00", "replicate-01"]);
  for (const name of ["replicate-01", "replicate-00"]) {
    await page.getByRole("button", { name }).click();
    const frame = page.frames()[1];
    await frame.waitForFunction((name_) => window.trophicError || (document.title.includes(name_) && window.trophic?.settled), name);
    assert.equal(await frame.evaluate(() => window.trophicError), undefined);
    assert.match(await frame.title(), new RegExp(name));
    await frame.evaluate(() => {
      window.trophic.play(false); // it opens at a catch, playing
      window.trophic.seek(100);
    });
    await frame.waitForFunction(() => window.trophic.settled);
    assert.equal(await frame.evaluate(() => window.trophic.time), 100);
    assert.equal(await frame.getByText("Copy link").count(), 0); // no reader could open it
  }
  assert.deepEqual(complaints, []);
  assert.deepEqual(requests.filter((url) => !url.startsWith("data:")), [`file://${at("analysis.html")}`]);
  const phone = await browser.with({ viewport: { width: 390, height: 844 }, isMobile: true });
  const small = await phone.context.newPage();
  await small.goto(`file://${at("analysis.html")}`);
  assert.equal(await small.evaluate(() => document.documentElement.scrollWidth), 390);
  await small.close();
  await page.close();
});
