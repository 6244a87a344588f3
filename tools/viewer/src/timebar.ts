// SPDX-License-Identifier: MIT
// The run's time as a bar with its events: births, catches and deaths by cause. A click jumps, the wheel zooms, a drag moves.
import { colourOf, faded, inkColour } from "./colours";
import type { Event, Run } from "./run";

interface Lane {
  name: string;
  events: Event[];
}

const left = 104;
const laneHeight = 15;
const axisHeight = 20;

export class TimeBar {
  readonly canvas = document.createElement("canvas");
  private lanes: Lane[] = [];
  private from = 0;
  private to = 1;
  private first = 0;
  private last = 1;
  private now = 0;
  private hover: Event | null = null;
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
      this.canvas.style.cursor = this.hover ? "pointer" : "default";
      this.showTip(e.offsetX);
    });
    this.canvas.addEventListener("pointerleave", () => {
      this.tip.hidden = true;
    });
    this.canvas.addEventListener("pointerup", (e) => {
      if (dragFrom && !moved) {
        const event = this.eventAt(e.offsetX, e.offsetY);
        onJump(event ? event.time : this.timeAt(e.offsetX), event);
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
    const causes = [...new Set(run.events.filter((e) => e.kind === "death" && e.cause !== "caught").map((e) => e.cause))].sort();
    this.lanes = [
      { name: "births", events: run.events.filter((e) => e.kind === "birth") },
      { name: "catches", events: run.events.filter((e) => e.kind === "catch") },
      ...causes.map((cause) => ({ name: cause, events: run.events.filter((e) => e.kind === "death" && e.cause === cause) })),
    ];
    this.element.style.height = `${this.lanes.length * laneHeight + axisHeight + 4}px`;
    this.draw(this.now);
  }

  private width(): number {
    return Math.max(10, this.canvas.clientWidth - left - 14);
  }
  private timeAt(x: number): number {
    const time = this.from + ((x - left) / this.width()) * (this.to - this.from);
    return Math.min(this.last, Math.max(this.first, time));
  }
  /** Place of a moment, CSS pixels from the canvas' left. */
  xOf(time: number): number {
    return left + ((time - this.from) / (this.to - this.from)) * this.width();
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
    if (!lane || x < left) return null;
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

  private showTip(x: number): void {
    this.tip.hidden = !this.hover;
    if (!this.hover) return;
    const { kind, id, other, time, cause } = this.hover;
    const what = kind === "catch" ? `${id} catches ${other}` : kind === "birth" ? `${id} is born` : `${id} ${cause}`;
    this.tip.textContent = `${time.toFixed(0)} s: ${what}`;
    this.tip.style.left = `${Math.min(x + 10, this.canvas.clientWidth - 150)}px`;
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
    this.lanes.forEach((lane, i) => {
      const y = i * laneHeight + 2;
      g.fillStyle = i % 2 ? "#f6f8f9" : "#eef1f4";
      g.fillRect(left, y, this.width(), laneHeight);
      g.fillStyle = inkColour;
      g.textAlign = "left";
      g.fillText(lane.name, 8, y + laneHeight / 2);
      g.fillStyle = "#6b7682";
      g.textAlign = "right";
      g.fillText(String(lane.events.length), left - 8, y + laneHeight / 2);
      for (const event of lane.events) {
        if (event.time < this.from || event.time > this.to) continue;
        g.fillStyle = faded(colourOf(event.species), 0.75);
        g.fillRect(this.xOf(event.time) - 0.75, y + 2, 1.5, laneHeight - 4);
      }
    });
    this.drawAxis(g, this.lanes.length * laneHeight + 2);
    const x = this.xOf(now);
    if (x >= left - 1 && x <= left + this.width() + 1) {
      g.fillStyle = "#111";
      g.fillRect(x - 0.75, 0, 1.5, this.lanes.length * laneHeight + 8);
      g.beginPath();
      g.moveTo(x - 5, this.lanes.length * laneHeight + 12);
      g.lineTo(x + 5, this.lanes.length * laneHeight + 12);
      g.lineTo(x, this.lanes.length * laneHeight + 4);
      g.fill();
    }
  }

  private drawAxis(g: CanvasRenderingContext2D, y: number): void {
    const rough = (this.to - this.from) / Math.max(2, this.width() / 90);
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].map((n) => n * power).find((n) => n >= rough)!;
    g.fillStyle = "#6b7682";
    g.textAlign = "center";
    for (let time = Math.ceil(this.from / step) * step; time <= this.to + 1e-9; time += step) {
      g.fillRect(this.xOf(time), y, 1, 3);
      g.fillText(`${Number(time.toFixed(3))} s`, Math.min(this.xOf(time), left + this.width() - 8), y + 11);
    }
  }
}
