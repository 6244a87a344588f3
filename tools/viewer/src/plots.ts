// SPDX-License-Identifier: MIT
// Population, tags and speed over time, with the current moment.
import uPlot from "uplot";
import { colourOf } from "./colours";
import type { Run } from "./run";

/** Curves by species, one value a point of time. */
export interface Curves {
  time: number[];
  bySpecies: (number | null)[][]; // null: unknown
}

export interface Series {
  population: Curves;
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
  return { population, tags, speed: run.tracked ? speedOf(run, count) : null };
}

/** Mean displacement in a window of at least 60 s, over that window, by species, cm/s. */
function speedOf(run: Run, count: number): Curves {
  const { agents, robots, recording, track } = run;
  const window = Math.max(1, Math.round(60 / recording.head.tick_s), strideOf(run));
  const curves: Curves = { time: [], bySpecies: Array.from({ length: count }, () => []) };
  for (let tick = window; tick < agents.ticks; tick += window) {
    const sum = new Array<number>(count).fill(0);
    const number = new Array<number>(count).fill(0);
    for (let body = 0; body < robots; ++body) {
      const now = tick * robots + body;
      const before = now - window * robots;
      if (agents.id[now] !== agents.id[before]) continue;
      const way = Math.hypot(track[2 * now] - track[2 * before], track[2 * now + 1] - track[2 * before + 1]);
      if (Number.isNaN(way)) continue;
      sum[agents.species[now]] += (100 * way) / (window * recording.head.tick_s);
      ++number[agents.species[now]];
    }
    curves.time.push((agents.firstTick + tick - window / 2) * recording.head.tick_s);
    for (let species = 0; species < count; ++species) curves.bySpecies[species].push(number[species] ? sum[species] / number[species] : null);
  }
  return curves;
}

export class Plot {
  readonly element = document.createElement("div");
  private plot: uPlot | null = null;
  private now = 0;

  constructor(
    private readonly title: string,
    private readonly range: [number, number] | null,
    private readonly onJump: (time: number) => void,
  ) {
    this.element.className = "plot";
  }

  show(curves: Curves | null, species: string[], first: number, last: number): void {
    this.plot?.destroy();
    this.plot = null;
    this.element.replaceChildren();
    if (!curves || curves.time.length === 0) {
      this.element.textContent = `${this.title}: ${curves ? "the run is too short" : "reading the recording …"}`;
      return;
    }
    const grid = { stroke: "#e8ecef", width: 1 };
    const axis = { stroke: "#6b7682", grid, ticks: { ...grid, size: 4 }, font: "10px system-ui, sans-serif", gap: 3 };
    this.plot = new uPlot(
      {
        width: Math.max(200, this.element.clientWidth),
        height: 96,
        title: this.title,
        legend: { show: false },
        cursor: { y: false, points: { show: false }, drag: { setScale: false } },
        scales: { x: { time: false, range: [first, last] }, y: this.range ? { range: this.range } : { range: (_, low, high) => [Math.min(0, low), high * 1.08 || 1] } },
        axes: [
          { ...axis, size: 22, values: (_, ticks) => ticks.map((t) => `${t}`) },
          { ...axis, size: 38 },
        ],
        series: [{}, ...species.map((name, i) => ({ label: name, stroke: colourOf(i), width: 1.6, points: { show: false }, spanGaps: true }))],
        hooks: { draw: [(u: uPlot) => this.drawNow(u)] },
      },
      [curves.time, ...curves.bySpecies],
      this.element,
    );
    this.plot.over.addEventListener("click", (e) => this.onJump(this.plot!.posToVal(e.offsetX, "x")));
  }

  private drawNow(u: uPlot): void {
    const x = u.valToPos(this.now, "x", true);
    const g = u.ctx;
    g.save();
    g.fillStyle = "#111";
    g.fillRect(x - 0.5, u.bbox.top, 1.5, u.bbox.height);
    g.restore();
  }

  at(time: number): void {
    this.now = time;
    this.plot?.redraw(false, false);
  }

  resize(): void {
    if (this.plot) this.plot.setSize({ width: Math.max(200, this.element.clientWidth), height: 96 });
  }
}
