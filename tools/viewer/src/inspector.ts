// SPDX-License-Identifier: MIT
// The data of one individual at a moment.
import { colourOf } from "./colours";
import { plain } from "./element";
import type { Run, Senses } from "./run";
import { deathWords, directionWords, labelled } from "./sentences";

/** Drawn positions of robots, x, y, z, and their headings. */
export interface Drawn {
  drawn: Float32Array;
  headings: Float32Array;
}

export class Inspector {
  readonly element = document.createElement("div");

  constructor(private readonly onSelect: (id: number) => void) {
    this.element.className = "inspector";
    this.element.addEventListener("click", (e) => {
      const id = (e.target as HTMLElement).dataset.id;
      if (id) this.onSelect(Number(id));
    });
  }

  show(run: Run, id: number, time: number, places: Drawn | null, living: number): void {
    const one = run.individuals.get(id);
    if (!one) {
      this.element.innerHTML = `<p class="hint">Select a robot, a line of the phylogeny or an event.</p>`;
      return;
    }
    const row = run.rowAt(time);
    const body = run.bodyOf(id, time);
    const { agents } = run;
    const link = (other: number): string => (run.individuals.has(other) ? `<a data-id="${other}">${other}</a>` : `${other}`);
    const rows: [string, string][] = [];
    const end = one.death === Infinity ? "lives at the end" : `${plain(deathWords(one.cause))} at ${fixed(one.death, 0)} s`;
    rows.push(["life", `${fixed(one.birth, 0)} s, ${end}${Number.isNaN(one.killer) ? "" : ` by ${link(one.killer)}`}`]);
    const parents = one.parents.map(link).join(" and ") || "none";
    rows.push([one.parents.length > 1 ? "parents" : "parent", `${parents}, genome ${plain(one.origin) || "unknown"}`]);
    rows.push(["offspring", one.children.length > 0 ? `${one.offspring}; ${living} of the branch live now` : `${one.offspring}`]);
    if (body >= 0) {
      const at = row + body;
      rows.push(["age", `${fixed(time - one.birth, 0)} s${agents.active[at] ? "" : ", not yet active"}`]);
      if (agents.energy[at] >= 0) rows.push(["energy", `${fixed(agents.energy[at], 1)} J`]);
      if (run.hasTags) rows.push(["tag", signed(agents.tag[at])]);
      const meals = run.fills("metabolism") && !run.fills("starvation") ? "last catch" : "hunger";
      const hungry = `${fixed(agents.hunger[at] * run.recording.head.tick_s, 0)} s`;
      if (!Number.isNaN(agents.hunger[at])) rows.push([meals, meals === "hunger" ? `${hungry} without a catch` : `none for ${hungry}`]);
      const other = agents.adversary[at];
      const otherBody = other >= 0 ? run.bodyOf(other, time) : -1;
      let seen = "none";
      if (other >= 0) {
        const where = places && otherBody >= 0 ? `, ${wayTo(places, body, otherBody)}` : "";
        seen = `${plain(run.index.species[run.individuals.get(other)?.species ?? -1] ?? "robot")} ${link(other)}${where}`;
      }
      rows.push(["perceives", seen]);
      const angle = (agents.targetAngle[at] * 180) / Math.PI;
      const turn = Math.abs(angle) < 0.5 ? "walks straight ahead" : `turns ${fixed(Math.abs(angle), 0)}° to the ${angle >= 0 ? "right" : "left"}`;
      rows.push(["brain", turn + (run.hasTags ? `, shows tag ${signed(agents.tag[at])}` : "")]);
      const told = run.senses ? run.senses.outputs(agents.line[at]) : [...agents.outputs].map(([act, values]): [string, number] => [act, values[at]]);
      const outputs = told.filter(([, value]) => !Number.isNaN(value));
      if (outputs.length > 0) rows.push(["outputs", outputs.map(([act, value]) => `${plain(act.replaceAll("_", " "))} ${fixed(value, 2)}`).join(", ")]);
      if (run.senses) rows.push(...sensed(run.senses, agents.line[at], run.hasTags));
      for (const [name, column] of agents.extra) {
        const [term, text] = labelled(name, column[agents.line[at]] ?? "");
        rows.push([plain(term), plain(text)]);
      }
      if (places) rows.push(["place", `${fixed(places.drawn[3 * body], 2)}, ${fixed(places.drawn[3 * body + 1], 2)} m`]);
      rows.push(["body", `${body}${shapeWords(run, body, time)}`]);
    } else {
      rows.push(["now", time < one.birth ? "not yet born" : "dead"]);
    }
    if (!Number.isNaN(one.mutation) && one.parents.length > 0) rows.push(["mutation", `${fixed(one.mutation, 3)} from the weights that it inherited`]);
    for (const [trait, value] of one.traits) {
      const [term, text] = labelled(trait, value);
      rows.push([plain(term), `${plain(text)}, inherited`]);
    }
    const name = run.index.species[one.species] ?? "?";
    this.element.innerHTML =
      `<h2><i style="background:${colourOf(one.species)}"></i>${plain(name)} ${id}</h2><dl>` +
      rows.map(([term, text]) => `<dt>${term}</dt><dd>${text}</dd>`).join("") +
      "</dl>";
  }
}

/** ": gecko, 6 hinges", of a robot whose body may differ from others'. */
function shapeWords({ recording }: Run, body: number, time: number): string {
  if (!recording.bodiesDiffer) return "";
  const { name, links } = recording.bodies[recording.bodyAt(recording.shownAt(time), body)];
  return `: ${plain(name)}, ${links.length - 1} ${links.length === 2 ? "hinge" : "hinges"}`;
}

/** "3.4 m ahead to the left", from a body to another. */
function wayTo({ drawn, headings }: Drawn, from: number, to: number): string {
  const dx = drawn[3 * to] - drawn[3 * from];
  const dy = drawn[3 * to + 1] - drawn[3 * from + 1];
  return `${fixed(Math.hypot(dx, dy), 1)} m ${directionWords(Math.atan2(dy, dx) - headings[from])}`;
}

/** Contacts of a robot, inputs of its brain, and the outcome of its choice. */
function sensed(senses: Senses, row: number, hasTags: boolean): [string, string][] {
  const rows: [string, string][] = [];
  const cell = (name: string): string => senses.cell(name, row);
  const number = (text: string): string => (text === "" ? "–" : fixed(Number(text), 2));
  const told = senses.told(row);
  if (told.length > 0) {
    rows.push(["brain's inputs", told.map(([name, value]) => `${plain(name.replaceAll("_", " "))} ${number(value)}`).join(", ")]);
    const became: Record<string, string> = { kept: "as before", switched: "switched now", denied: "denied" };
    const tag = Number(cell("chosen_tag"));
    if (hasTags) rows.push(["wants tag", `${signed(tag)}, ${became[cell("tag_outcome")] ?? plain(cell("tag_outcome"))}`]);
  } else {
    rows.push(["brain's inputs", "none at this tick"]);
  }
  if (cell("exempt") === "1") rows.push(["hunger", "would starve, exempt"]);
  if (cell("height_m") !== "") {
    rows.push(["root", `${number(cell("height_m"))} m high, tilted by ${fixed((Number(cell("tilt_rad")) * 180) / Math.PI, 0)}°`]);
    const touched = Number(cell("robots_touched"));
    const others = touched === 0 ? "no robot" : touched === 1 ? "one robot" : `${touched} robots`;
    rows.push(["touches", cell("touches_wall") === "1" ? `a wall, ${others}` : others]);
  }
  return rows;
}

function signed(tag: number): string {
  return `${tag > 0 ? "+" : ""}${tag}`;
}

function fixed(value: number, digits: number): string {
  return Number.isNaN(value) ? "–" : value.toFixed(digits);
}
