// SPDX-License-Identifier: MIT
// Population, energy, tags and speed over time, with the current moment and the moments at which parameters changed.
import uPlot from "uplot";
import { colourOf, faded } from "./colours";
import type { Curves } from "./moments";
import type { Change, Run } from "./run";
import { changesAt, changeWords } from "./sentences";
import { isDark, theme } from "./theme";

export interface Series {
  population: Curves;
  energy: Curves | null; // null: a world without
  tags: Curves;
  speed: Curves | null; // known when the recording has been read
}

/** Smallest distance of points, ticks, so that a curve has at most some thousands. */
function strideOf(run: Run): number {
  return Math.max(1, Math.floor(run.agents.ticks / 1500));
}

export function seriesOf(run: Run): Series {
  const { agents, robots, recording } = run;
  const stride = strideOf(run);
  const count = run.index.species.length;
  const empty = (): Curves => ({ time: [], bySpecies: Array.from({ length: count }, () => []) });
  const population = empty();
  const tags = empty();
  const filled = Math.max(...run.index.tags);
  for (let tick = 0; tick < agents.ticks; tick += stride) {
    const number = new Array<number>(count).fill(0);
    const shown = new Array<number>(count).fill(0);
    for (let at = tick * robots; at < (tick + 1) * robots; ++at) {
      if (agents.id[at] < 0) continue;
      ++number[agents.species[at]];
      if (agents.tag[at] === filled) ++shown[agents.species[at]];
    }
    const time = (agents.firstTick + tick) * recording.head.tick_s;
    population.time.push(time);
    tags.time.push(time);
    for (let species = 0; species < count; ++species) {
      population.bySpecies[species].push(number[species]);
      tags.bySpecies[species].push(number[species] ? shown[species] / number[species] : null);
    }
  }
  return { population, energy: run.energy, tags, speed: run.tracked ? speedOf(run, count) : null };
}

/** The mean over robots of their displacement in a window of at least 60 s, over that window, by species, cm/s; the band has half of them. */
function speedOf(run: Run, count: number): Curves {
  const { agents, robots, recording, track } = run;
  const window = Math.max(1, Math.round(60 / recording.head.tick_s), strideOf(run));
  const bands = Array.from({ length: count }, () => ({ low: [] as (number | null)[], high: [] as (number | null)[] }));
  const curves: Curves = { time: [], bySpecies: Array.from({ length: count }, () => []), bands };
  for (let tick = window; tick < agents.ticks; tick += window) {
    const speeds = Array.from({ length: count }, () => [] as number[]);
    for (let body = 0; body < robots; ++body) {
      const now = tick * robots + body;
      const before = now - window * robots;
      if (agents.id[now] < 0 || agents.id[now] !== agents.id[before]) continue;
      const way = Math.hypot(track[2 * now] - track[2 * before], track[2 * now + 1] - track[2 * before + 1]);
      if (!Number.isNaN(way)) speeds[agents.species[now]].push((100 * way) / (window * recording.head.tick_s));
    }
    curves.time.push((agents.firstTick + tick - window / 2) * recording.head.tick_s);
    speeds.forEach((ones, species) => {
      ones.sort((a, b) => a - b);
      curves.bySpecies[species].push(ones.length ? ones.reduce((a, b) => a + b) / ones.length : null);
      bands[species].low.push(quantile(ones, 0.25));
      bands[species].high.push(quantile(ones, 0.75));
    });
  }
  return curves;
}

/** A quantile of sorted values, interpolated; null for none. */
function quantile(sorted: number[], part: number): number | null {
  if (sorted.length === 0) return null;
  const at = part * (sorted.length - 1);
  const low = Math.floor(at);
  return sorted[low] + (at - low) * (sorted[Math.min(low + 1, sorted.length - 1)] - sorted[low]);
}

/** Time, means and bounds of bands, as uPlot takes them. */
function dataOf({ time, bySpecies, bands }: Curves): uPlot.AlignedData {
  return [time, ...bySpecies, ...(bands ?? []).flatMap(({ low, high }) => [low, high])];
}

/** Pixels of a plot, and of the axis of time below the last one. */
const plotHeight = 56;
const axisHeight = 22;

export class Plot {
  readonly element = document.createElement("div");
  private plot: uPlot | null = null;
  private now = 0;
  private changes: Change[] = [];
  private part = 0;
  private shape = "";
  private bounds: [number, number] = [0, 1];

  /** `hasTimes`: whether it has the axis of time, which plots below each other share. */
  constructor(private readonly title: string, private readonly range: [number, number] | null, private readonly onJump: (time: number) => void, private readonly hasTimes = false) {
    this.element.className = "plot";
  }

  show(curves: Curves | null, { index: { species }, changes }: Run, first: number, last: number): void {
    this.changes = changes;
    const shape = `${species.join()} ${curves?.bands ? "with bands" : ""} ${isDark() ? "dark" : "light"}`;
    if (this.plot && curves && curves.time.length > 0 && this.shape === shape) {
      this.bounds = [first, last];
      this.plot.setData(dataOf(curves));
      return;
    }
    this.plot?.destroy();
    this.plot = null;
    this.bounds = [first, last];
    this.element.replaceChildren();
    if (!curves || curves.time.length === 0) {
      this.element.textContent = `${this.title}: ${curves ? "the run is too short" : `reading the recording, ${Math.round(100 * this.part)} %`}`;
      return;
    }
    const { faint, muted } = theme();
    const grid = { stroke: faint, width: 1 };
    const axis = { stroke: muted, grid, ticks: { ...grid, size: 4 }, font: "10px system-ui, sans-serif", gap: 3 };
    const lines = species.map((name, i) => ({ label: name, stroke: colourOf(i), width: 1.6, points: { show: false }, spanGaps: true }));
    const bounds = (curves.bands ?? []).flatMap(() => [0, 1].map(() => ({ width: 0, points: { show: false }, spanGaps: true })));
    this.plot = new uPlot(
      {
        width: Math.max(200, this.element.clientWidth),
        height: this.height,
        title: this.title,
        legend: { show: false },
        cursor: { y: false, points: { show: false }, drag: { setScale: false } },
        scales: { x: { time: false, range: () => this.bounds }, y: this.range ? { range: this.range } : { range: (_, low, high) => [Math.min(0, low), high * 1.08 || 1] } },
        axes: [
          { ...axis, size: this.hasTimes ? axisHeight : 4, values: (_, ticks) => ticks.map((t) => (this.hasTimes ? `${t}` : "")) },
          { ...axis, size: 38, space: 16 },
        ],
        series: [{}, ...lines, ...bounds],
        bands: (curves.bands ?? []).map((_, i) => ({ series: [1 + species.length + 2 * i + 1, 1 + species.length + 2 * i], fill: faded(colourOf(i), 0.18) })),
        hooks: { draw: [(u: uPlot) => this.drawNow(u)] },
      },
      dataOf(curves),
      this.element,
    );
    this.shape = shape;
    const { over } = this.plot;
    over.addEventListener("click", (e) => this.onJump(this.plot!.posToVal(e.offsetX, "x")));
    over.addEventListener("mousemove", (e) => (over.title = changeWords(changesAt(this.changes, e.offsetX, (time) => this.plot!.valToPos(time, "x")))));
  }

  private drawNow(u: uPlot): void {
    const x = u.valToPos(this.now, "x", true);
    const g = u.ctx;
    g.save();
    g.beginPath();
    g.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
    g.clip();
    g.fillStyle = theme().change;
    for (const { time_s } of this.changes) g.fillRect(u.valToPos(time_s, "x", true) - 0.5, u.bbox.top, 1.5, u.bbox.height);
    g.fillStyle = theme().ink;
    g.fillRect(x - 0.5, u.bbox.top, 1.5, u.bbox.height);
    g.restore();
  }

  /** Says how much of the recording was read, 0 to 1, until the curve is known. */
  progress(part: number): void {
    this.part = part;
    if (!this.plot) this.element.textContent = `${this.title}: reading the recording, ${Math.round(100 * part)} %`;
  }

  at(time: number): void {
    this.now = time;
    this.plot?.redraw(false, false);
  }

  resize(): void {
    if (this.plot) this.plot.setSize({ width: Math.max(200, this.element.clientWidth), height: this.height });
  }
  private get height(): number {
    return plotHeight + (this.hasTimes ? axisHeight : 0);
  }
}
