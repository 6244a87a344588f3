// SPDX-License-Identifier: MIT
// Sentences about events and the state of a run.
import type { Change, Event, Run } from "./run";

const deaths: Record<string, string> = { caught: "was caught", starved: "starved", sacrificed: "was sacrificed", senescence: "died of age", diverged: "was lost: its body diverged" };

/** "was caught", or the cause itself if it is a rule's own. */
export function deathWords(cause: string): string {
  return deaths[cause] ?? `died: ${cause}`;
}

/** "predator 19". */
export function nameOf(run: Run, id: number): string {
  const one = run.individuals.get(id);
  return one ? `${run.index.species[one.species] ?? "robot"} ${id}` : `robot ${id}`;
}

/** "inherited, lived 92 s", of an individual that dies at a moment. */
export function lifeWords(run: Run, id: number, time: number): string {
  const one = run.individuals.get(id);
  if (!one) return "";
  return `${one.origin ? `${one.origin}, ` : ""}lived ${(time - one.birth).toFixed(0)} s`;
}

/** "predator 19 catches prey 4: inherited, lived 92 s". */
export function sentence(run: Run, event: Event): string {
  if (event.scene) return event.scene.sentence;
  if (event.kind !== "death") return shortSentence(run, event);
  const life = lifeWords(run, event.id, event.time);
  return shortSentence(run, event) + (life ? `: ${life}` : "");
}

/** "predator 19 catches prey 4". */
export function shortSentence(run: Run, event: Event): string {
  const who = nameOf(run, event.id);
  switch (event.kind) {
    case "catch":
      return `${who} catches ${nameOf(run, event.other)}`;
    case "birth":
      return `${who} is born${event.parents.length === 0 ? `, genome ${event.origin}` : ` to ${(run.individuals.get(event.id) ?? event).parents.join(" and ")}`}`;
    case "death":
      return `${who} ${deathWords(event.cause)}${Number.isNaN(event.other) ? "" : ` by ${nameOf(run, event.other)}`}`;
    case "activation":
      return `${who} becomes active`;
    case "tag_switch":
      return `${who} switches its tag`;
    default:
      return `${who}: ${event.kind.replaceAll("_", " ")}`;
  }
}

/** A number as people write it: at most six digits that count. Other texts stay as they are. */
export function short(text: string): string {
  const digits = text.replace(/e.*/i, "").replace(/\D/g, "").replace(/^0+/, "");
  return digits.length > 6 && Number.isFinite(Number(text)) ? String(Number(Number(text).toPrecision(6))) : text;
}

const units: Record<string, string> = { J: "J", m: "m", s: "s", W: "W", rad: "rad", ticks: "ticks" };

/** A column's name and a cell as people write them: "energy_J", "43.21" -> "energy", "43.21 J". */
export function labelled(column: string, cell: string): [string, string] {
  const words = column.replace(/^\w+\./, "").split("_");
  const unit = words.length > 1 ? units[words[words.length - 1]] : undefined;
  if (unit) words.pop();
  return [words.join(" "), cell === "" ? "–" : short(cell) + (unit ? ` ${unit}` : "")];
}

/** A parameter's path without "rules.". */
export const shortPath = (path: string): string => path.replace(/^rules\./, "");

/** "100 s: capture.reach_m 0.3 → 0.5; mutation.sd 0.05 → 0.1" of changes at one moment. */
export function changeWords(changes: Change[]): string {
  return changes.length === 0 ? "" : `${changes[0].time_s} s: ${changes.map(({ number, before, value }) => `${shortPath(number)} ${short(before)} → ${short(value)}`).join("; ")}`;
}

/** The changes at the moment of one that is nearest to a place, nearer than `most`. */
export function changesAt(changes: Change[], x: number, xOf: (time: number) => number, most = 4.5): Change[] {
  const off = ({ time_s }: Change): number => Math.abs(xOf(time_s) - x);
  const near = changes.filter((change) => off(change) < most).sort((a, b) => off(a) - off(b));
  return near.filter(({ time_s }) => time_s === near[0].time_s);
}

/** A direction as seen from a robot: "ahead to the left". `bearing`: radians to the left of where it heads. */
export function directionWords(bearing: number): string {
  const turn = Math.atan2(Math.sin(bearing), Math.cos(bearing));
  const side = turn > 0 ? "to the left" : "to the right";
  const off = (Math.abs(turn) * 180) / Math.PI;
  if (off < 15) return "straight ahead";
  if (off < 65) return `ahead ${side}`;
  if (off < 115) return side;
  if (off < 165) return `behind ${side}`;
  return "straight behind";
}
