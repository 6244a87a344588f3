// SPDX-License-Identifier: MIT
// The run's time as a bar with events: births, catches and deaths by cause, and marks where parameters changed. A click jumps, the wheel zooms, a drag moves.
// A lane with too many events shows their number instead.
import { colourOf, faded } from "./colours";
import { firstAfter } from "./moments";
import type { Change, Event, Run } from "./run";
import { changesAt, changeWords, shortSentence } from "./sentences";
import { theme } from "./theme";

interface Lane {
  name: string;
  events: Event[];
}

const laneHeight = 15;
/** Lanes with more events than that a pixel are drawn by density. */
const densestPerPixel = 0.5;
const binPixels = 4;
const axisHeight = 20;

export class TimeBar {
  readonly canvas = document.createElement("canvas");
  private run: Run | null = null;
  private lanes: Lane[] = [];
  private from = 0;
  private to = 1;
  private first = 0;
  private last = 1;
  private now = 0;
  private hover: Event | null = null;
  private hoverChanges: Change[] = [];
  private readonly tip = document.createElement("div");
  readonly element = document.createElement("div");

  constructor(onJump: (time: number, event: Event | null) => void) {
    this.element.className = "timebar";
    this.tip.className = "tip";
    this.tip.hidden = true;
    this.element.append(this.canvas, this.tip);
    let dragFrom: { x: number; from: number; to: number } | null = null;
    let moved = false;
    this.canvas.addEventListener("pointerdown", (e) => {
      dragFrom = { x: e.offsetX, from: this.from, to: this.to };
      moved = false;
      this.canvas.setPointerCapture(e.pointerId);
    });
    this.canvas.addEventListener("pointermove", (e) => {
      if (dragFrom && Math.abs(e.offsetX - dragFrom.x) > 4) moved = true;
      if (dragFrom && moved) {
        if (this.to - this.from > 0.999 * (this.last - this.first)) {
          onJump(this.timeAt(e.offsetX), null);
        } else {
          const shift = ((dragFrom.x - e.offsetX) * (dragFrom.to - dragFrom.from)) / this.width();
          this.zoomTo(dragFrom.from + shift, dragFrom.to + shift);
        }
        return;
      }
      this.hover = this.eventAt(e.offsetX, e.offsetY);
      this.hoverChanges = this.hover ? [] : this.changesAt(e.offsetX);
      this.canvas.style.cursor = this.hover || this.hoverChanges.length > 0 ? "pointer" : "default";
      this.showTip(e.offsetX);
    });
    this.canvas.addEventListener("pointerleave", () => {
      this.tip.hidden = true;
    });
    this.canvas.addEventListener("pointerup", (e) => {
      if (dragFrom && !moved) {
        const event = this.eventAt(e.offsetX, e.offsetY);
        onJump(event?.time ?? this.changesAt(e.offsetX)[0]?.time_s ?? this.timeAt(e.offsetX), event);
      }
      dragFrom = null;
    });
    this.canvas.addEventListener("wheel", (e) => {
      e.preventDefault();
      const centre = this.timeAt(e.offsetX);
      const factor = Math.exp(0.0016 * e.deltaY);
      this.zoomTo(centre - (centre - this.from) * factor, centre + (this.to - centre) * factor);
    }, { passive: false });
    this.canvas.addEventListener("dblclick", () => this.zoomTo(this.first, this.last));
  }

  /** Shows the events of a run, and the time of all runs. */
  show(run: Run, first: number, last: number): void {
    const whole = this.to - this.from >= 0.999 * (this.last - this.first);
    this.first = first;
    this.last = Math.max(last, first + 1e-6);
    if (whole) {
      this.from = this.first;
      this.to = this.last;
    }
    this.run = run;
    const causes = [...new Set(run.events.filter((e) => e.kind === "death" && e.cause !== "caught").map((e) => e.cause))].sort();
    this.lanes = [
      { name: "births", events: run.events.filter((e) => e.kind === "birth") },
      { name: "catches", events: run.events.filter((e) => e.kind === "catch") },
      ...causes.map((cause) => ({ name: cause, events: run.events.filter((e) => e.kind === "death" && e.cause === cause) })),
    ];
    this.element.style.height = `${this.lanes.length * laneHeight + axisHeight + 4}px`;
    this.draw(this.now);
  }

  private get left(): number {
    return this.element.clientWidth < 600 ? 88 : 104;
  }
  private width(): number {
    return Math.max(10, this.canvas.clientWidth - this.left - 14);
  }
  private timeAt(x: number): number {
    const time = this.from + ((x - this.left) / this.width()) * (this.to - this.from);
    return Math.min(this.last, Math.max(this.first, time));
  }
  /** Place of a moment, CSS pixels from the canvas' left. */
  xOf(time: number): number {
    return this.left + ((time - this.from) / (this.to - this.from)) * this.width();
  }
  /** Place of a lane, CSS pixels from the canvas' top. */
  yOf(lane: string): number {
    return (this.lanes.findIndex((one) => one.name === lane) + 0.5) * laneHeight + 2;
  }

  private zoomTo(from: number, to: number): void {
    const width = Math.min(this.last - this.first, Math.max(10, to - from));
    this.from = Math.min(this.last - width, Math.max(this.first, from));
    this.to = this.from + width;
    this.draw(this.now);
  }

  private eventAt(x: number, y: number): Event | null {
    const lane = this.lanes[Math.floor((y - 2) / laneHeight)];
    if (!lane || x < this.left) return null;
    let best: Event | null = null;
    let least = 4.5;
    for (const event of lane.events) {
      const distance = Math.abs(this.xOf(event.time) - x);
      if (distance < least) {
        least = distance;
        best = event;
      }
    }
    return best;
  }

  private changesAt(x: number): Change[] {
    return changesAt(this.run?.changes ?? [], x, (time) => this.xOf(time));
  }

  private showTip(x: number): void {
    this.tip.hidden = !this.hover && this.hoverChanges.length === 0;
    if (this.tip.hidden || !this.run) return;
    this.tip.textContent = this.hover ? `${this.hover.time.toFixed(0)} s: ${shortSentence(this.run, this.hover)}` : changeWords(this.hoverChanges);
    this.tip.style.left = `${Math.max(0, Math.min(x + 10, this.canvas.clientWidth - this.tip.clientWidth - 4))}px`;
  }

  draw(now: number): void {
    this.now = now;
    const ratio = window.devicePixelRatio || 1;
    const width = this.element.clientWidth;
    const height = this.element.clientHeight;
    if (width === 0) return;
    if (this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio)) {
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(height * ratio);
    }
    const g = this.canvas.getContext("2d")!;
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    g.clearRect(0, 0, width, height);
    g.font = "11px system-ui, sans-serif";
    g.textBaseline = "middle";
    const { left } = this;
    const { ink, muted, lanes } = theme();
    this.lanes.forEach((lane, i) => {
      const y = i * laneHeight + 2;
      g.fillStyle = lanes[i % 2];
      g.fillRect(left, y, this.width(), laneHeight);
      g.fillStyle = ink;
      g.textAlign = "left";
      g.fillText(lane.name, 8, y + laneHeight / 2);
      g.fillStyle = muted;
      g.textAlign = "right";
      g.fillText(String(lane.events.length), left - 8, y + laneHeight / 2);
      this.drawEvents(g, lane, y + 2, laneHeight - 4);
    });
    this.drawAxis(g, this.lanes.length * laneHeight + 2);
    this.drawChanges(g, this.lanes.length * laneHeight + 2);
    const x = this.xOf(now);
    if (x >= left - 1 && x <= left + this.width() + 1) {
      g.fillStyle = ink;
      g.fillRect(x - 0.75, 0, 1.5, this.lanes.length * laneHeight + 8);
      g.beginPath();
      g.moveTo(x - 5, this.lanes.length * laneHeight + 12);
      g.lineTo(x + 5, this.lanes.length * laneHeight + 12);
      g.lineTo(x, this.lanes.length * laneHeight + 4);
      g.fill();
    }
  }

  private drawEvents(g: CanvasRenderingContext2D, lane: Lane, y: number, height: number): void {
    const seen = lane.events.slice(firstAfter(lane.events, this.from - 1e-9), firstAfter(lane.events, this.to));
    if (!this.isDense(seen.length)) {
      for (const event of seen) {
        g.fillStyle = faded(colourOf(event.species), 0.85);
        g.fillRect(this.xOf(event.time) - 0.75, y, 1.5, height);
      }
      return;
    }
    const bins = new Map<number, Map<number, number>>();
    let most = 0;
    for (const event of seen) {
      const bin = Math.floor((this.xOf(event.time) - this.left) / binPixels);
      const bySpecies = bins.get(bin) ?? new Map<number, number>();
      bins.set(bin, bySpecies.set(event.species, (bySpecies.get(event.species) ?? 0) + 1));
      most = Math.max(most, [...bySpecies.values()].reduce((a, b) => a + b));
    }
    for (const [bin, bySpecies] of bins) {
      let bottom = y + height;
      const total = [...bySpecies.values()].reduce((a, b) => a + b);
      for (const [species, count] of [...bySpecies].sort((a, b) => a[0] - b[0])) {
        const tall = height * Math.sqrt(total / most) * (count / total);
        g.fillStyle = colourOf(species);
        g.fillRect(this.left + bin * binPixels, bottom - tall, binPixels - 0.5, tall);
        bottom -= tall;
      }
    }
  }

  /** Whether so many events in view are drawn by density. */
  private isDense(count: number): boolean {
    return count > densestPerPixel * this.width();
  }

  /** The lanes that are drawn by density now. */
  get denseLanes(): string[] {
    return this.lanes.filter(({ events }) => this.isDense(firstAfter(events, this.to) - firstAfter(events, this.from - 1e-9))).map(({ name }) => name);
  }

  /** A line with a diamond at its foot where parameters changed. */
  private drawChanges(g: CanvasRenderingContext2D, bottom: number): void {
    g.fillStyle = theme().change;
    for (const { time_s } of this.run?.changes ?? []) {
      const x = this.xOf(time_s);
      if (x < this.left - 1 || x > this.left + this.width() + 1) continue;
      g.fillRect(x - 0.75, 0, 1.5, bottom);
      g.beginPath();
      for (const [dx, dy] of [[-4.5, 0], [0, -4.5], [4.5, 0], [0, 4.5]]) g.lineTo(x + dx, bottom + dy);
      g.fill();
    }
  }

  private drawAxis(g: CanvasRenderingContext2D, y: number): void {
    const rough = (this.to - this.from) / Math.max(2, this.width() / 90);
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].map((n) => n * power).find((n) => n >= rough)!;
    g.fillStyle = theme().muted;
    g.textAlign = "center";
    for (let time = Math.ceil(this.from / step) * step; time <= this.to + 1e-9; time += step) {
      g.fillRect(this.xOf(time), y, 1, 3);
      g.fillText(`${Number(time.toFixed(3))} s`, Math.min(this.xOf(time), this.left + this.width() - 8), y + 11);
    }
  }
}
