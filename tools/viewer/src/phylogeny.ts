// SPDX-License-Identifier: MIT
// The phylogeny: a line for each life, over time, below its parent's. The wheel zooms, a click selects a branch. Branches that died
// out can be collapsed.
import { hierarchy } from "d3-hierarchy";
import { colourOf, faded } from "./colours";
import { make, makeButton } from "./element";
import type { Individual, Run } from "./run";
import { deathWords, nameOf } from "./sentences";
import { theme } from "./theme";

/** Individuals with living descendants at the end, or alive themselves. */
export function lasting(run: Run): Set<number> {
  const found = new Set<number>();
  for (const one of run.individuals.values()) {
    if (one.death !== Infinity && one.death < run.lastTime) continue;
    for (let at: Individual | undefined = one; at && !found.has(at.id); at = run.individuals.get(at.parents[0])) found.add(at.id);
  }
  return found;
}

/** Gives all of `kept` a row, so that a branch is a block of rows; returns their number. Others have row -1. */
export function layOut(run: Run, kept: ReadonlySet<number>): number {
  let row = 0;
  const ours = (ones: Individual[]): Individual[] => ones.filter((one) => kept.has(one.id));
  for (const one of run.individuals.values()) one.row = -1;
  const tree = hierarchy<{ children: Individual[] }>({ children: ours(run.roots) }, (one) => ours(one.children));
  tree.count().sort((a, b) => (a.data as Individual).birth - (b.data as Individual).birth);
  tree.eachBefore((node) => {
    if (node.depth > 0) (node.data as Individual).row = row++;
  });
  return row;
}

/** An individual with its ancestors and all of its descendants. */
export function branchOf(run: Run, id: number): { ancestors: Set<number>; descendants: Set<number> } {
  const ancestors = new Set<number>();
  for (let one = run.individuals.get(id); one && !ancestors.has(one.id); one = run.individuals.get(one.parents[0])) ancestors.add(one.id);
  const descendants = new Set<number>();
  const waiting = [run.individuals.get(id)];
  while (waiting.length > 0) {
    const one = waiting.pop();
    if (!one || descendants.has(one.id)) continue;
    descendants.add(one.id);
    waiting.push(...one.children);
  }
  return { ancestors, descendants };
}

export class PhylogenyView {
  readonly canvas = document.createElement("canvas");
  readonly element = make("section", "tree");
  private readonly tip = make("div", "tip");
  private readonly count = make("span", "hint");
  private readonly collapse = make("input");
  private kept: ReadonlySet<number> = new Set();
  private run: Run | null = null;
  private rows = 1;
  private fromTime = 0;
  private toTime = 1;
  private fromRow = 0;
  private toRow = 1;
  private now = 0;
  private selected = NaN;
  private branch: { ancestors: Set<number>; descendants: Set<number> } = { ancestors: new Set(), descendants: new Set() };

  constructor(onSelect: (id: number, time: number) => void) {
    this.canvas.className = "phylogeny";
    this.tip.hidden = true;
    this.build();
    this.canvas.addEventListener("wheel", (e) => {
      e.preventDefault();
      this.zoom(e.offsetX / this.canvas.clientWidth, e.offsetY / this.canvas.clientHeight, Math.exp(0.0016 * e.deltaY));
    }, { passive: false });
    let dragFrom: [number, number] | null = null;
    let moved = false;
    this.canvas.addEventListener("pointerdown", (e) => {
      dragFrom = [e.offsetX, e.offsetY];
      moved = false;
      this.canvas.setPointerCapture(e.pointerId);
    });
    this.canvas.addEventListener("pointermove", (e) => {
      if (!dragFrom) this.showTip(e.offsetX, e.offsetY);
      if (!dragFrom || Math.hypot(e.offsetX - dragFrom[0], e.offsetY - dragFrom[1]) < (moved ? 1 : 5)) return;
      moved = true;
      this.move(dragFrom[0] - e.offsetX, dragFrom[1] - e.offsetY);
      dragFrom = [e.offsetX, e.offsetY];
    });
    this.canvas.addEventListener("pointerup", (e) => {
      if (dragFrom && !moved) {
        const one = this.individualAt(e.offsetX, e.offsetY);
        onSelect(one ? one.id : NaN, this.fromTime + (e.offsetX / this.canvas.clientWidth) * (this.toTime - this.fromTime));
      }
      dragFrom = null;
    });
    this.canvas.addEventListener("dblclick", () => this.whole());
    this.canvas.addEventListener("pointerleave", () => (this.tip.hidden = true));
  }

  private build(): void {
    const head = make("h3", "", "phylogeny: one line per life, over time");
    const drawing = make("div");
    drawing.append(this.canvas, this.tip);
    this.collapse.type = "checkbox";
    this.collapse.addEventListener("change", () => this.layOut());
    const label = make("label", "", "collapse extinct branches");
    label.prepend(this.collapse);
    const tools = make("div", "tools");
    tools.append(label, this.count, make("span", "space"), makeButton("−", "zoom out (wheel)", () => this.zoom(0.5, 0.5, 1.6)), makeButton("+", "zoom in (wheel)", () => this.zoom(0.5, 0.5, 1 / 1.6)), makeButton("all", "all of it (double click)", () => this.whole()));
    this.element.append(head, tools, drawing);
  }

  private showTip(x: number, y: number): void {
    const one = this.individualAt(x, y);
    this.tip.hidden = !one;
    this.canvas.style.cursor = one ? "pointer" : "crosshair";
    if (!one || !this.run) return;
    const end = one.death === Infinity ? "lives at the end" : `${deathWords(one.cause)} at ${one.death.toFixed(0)} s`;
    this.tip.textContent = `${nameOf(this.run, one.id)}: born at ${one.birth.toFixed(0)} s, ${end}, ${one.children.length} offspring`;
    this.tip.style.left = `${Math.max(0, Math.min(x + 10, this.canvas.clientWidth - this.tip.clientWidth - 4))}px`;
    this.tip.style.top = `${y > 30 ? y - 26 : y + 16}px`;
  }

  show(run: Run): void {
    this.run = run;
    this.layOut();
  }

  /** As `show` for a run that has grown: what is looked at closely stays. */
  grow(run: Run): void {
    this.run = run;
    const isWhole = this.fromRow <= -1 && this.toRow >= this.rows + 1;
    const seen = [this.fromTime, this.toTime, this.fromRow, this.toRow];
    this.layOut();
    if (!isWhole) [this.fromTime, this.toTime, this.fromRow, this.toRow] = seen;
    this.select(this.selected);
  }

  private layOut(): void {
    const { run } = this;
    if (!run) return;
    this.kept = this.collapse.checked ? lasting(run) : new Set(run.individuals.keys());
    this.count.textContent = this.collapse.checked ? `${run.individuals.size - this.kept.size} hidden` : "";
    this.rows = Math.max(1, layOut(run, this.kept));
    this.whole();
  }

  /** Individuals whose lives have a line. */
  private get drawnOnes(): Individual[] {
    return [...(this.run?.individuals.values() ?? [])].filter((one) => this.kept.has(one.id));
  }

  /** How many lives have a line. */
  get lines(): number {
    return this.kept.size;
  }

  private whole(): void {
    if (!this.run) return;
    this.fromTime = this.run.firstTime;
    this.toTime = this.run.lastTime;
    this.fromRow = -1;
    this.toRow = this.rows + 1;
    this.draw(this.now);
  }

  select(id: number): void {
    this.selected = id;
    this.branch = this.run && !Number.isNaN(id) ? branchOf(this.run, id) : { ancestors: new Set(), descendants: new Set() };
    this.draw(this.now);
  }

  private zoom(x: number, y: number, factor: number): void {
    const time = this.fromTime + x * (this.toTime - this.fromTime);
    const row = this.fromRow + y * (this.toRow - this.fromRow);
    if ((this.toRow - this.fromRow) * factor > 1.2 * this.rows) return this.whole();
    if ((this.toRow - this.fromRow) * factor < 6) return;
    this.fromTime = time - (time - this.fromTime) * factor;
    this.toTime = time + (this.toTime - time) * factor;
    this.fromRow = row - (row - this.fromRow) * factor;
    this.toRow = row + (this.toRow - row) * factor;
    this.draw(this.now);
  }

  private move(dx: number, dy: number): void {
    const time = (dx / this.canvas.clientWidth) * (this.toTime - this.fromTime);
    const row = (dy / this.canvas.clientHeight) * (this.toRow - this.fromRow);
    this.fromTime += time;
    this.toTime += time;
    this.fromRow += row;
    this.toRow += row;
    this.draw(this.now);
  }

  private xOf(time: number): number {
    return ((Math.min(time, this.run!.lastTime) - this.fromTime) / (this.toTime - this.fromTime)) * this.canvas.clientWidth;
  }
  private yOf(row: number): number {
    return ((row - this.fromRow) / (this.toRow - this.fromRow)) * this.canvas.clientHeight;
  }

  /** Place of an individual's life in the drawing, CSS pixels. */
  placeOf(id: number): [number, number] {
    const one = this.run!.individuals.get(id)!;
    return [(this.xOf(one.birth) + this.xOf(one.death)) / 2, this.yOf(one.row)];
  }

  private individualAt(x: number, y: number): Individual | null {
    let best: Individual | null = null;
    let least = 6;
    for (const one of this.drawnOnes) {
      const x0 = this.xOf(one.birth);
      const x1 = this.xOf(one.death);
      const dx = x < x0 ? x0 - x : x > x1 ? x - x1 : 0;
      const distance = Math.hypot(dx, this.yOf(one.row) - y);
      if (distance < least) {
        least = distance;
        best = one;
      }
    }
    return best;
  }

  draw(now: number): void {
    this.now = now;
    const { run } = this;
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    if (!run || width === 0) return;
    const ratio = window.devicePixelRatio || 1;
    if (this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio)) {
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(height * ratio);
    }
    const g = this.canvas.getContext("2d")!;
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    g.clearRect(0, 0, width, height);
    const any = this.branch.descendants.size > 0;
    const thick = Math.min(3, Math.max(0.8, (0.6 * height) / (this.toRow - this.fromRow)));
    const inBranch = (one: Individual): boolean => this.branch.descendants.has(one.id) || this.branch.ancestors.has(one.id);
    const paint = (ones: Individual[], opacity: number, extra: number): void => {
      for (const one of ones) {
        const y = this.yOf(one.row);
        if (y < -2 && one.children.length === 0) continue;
        g.fillStyle = faded(colourOf(one.species), opacity);
        const x0 = this.xOf(one.birth);
        g.fillRect(x0, y - (thick + extra) / 2, Math.max(0.8, this.xOf(one.death) - x0), thick + extra);
        const parent = run.individuals.get(one.parents[0]);
        if (!parent) continue;
        g.fillStyle = faded(theme().muted, opacity * (extra > 0 ? 1 : 0.55));
        const py = this.yOf(parent.row);
        g.fillRect(x0 - 0.35, Math.min(py, y), extra > 0 ? 1.2 : 0.7, Math.abs(y - py));
      }
    };
    const everybody = this.drawnOnes;
    paint(any ? everybody.filter((one) => !inBranch(one)) : everybody, any ? 0.18 : 0.85, 0);
    if (any) paint(everybody.filter(inBranch), 1, 0.8);
    const x = this.xOf(now);
    g.fillStyle = theme().ink;
    g.fillRect(x - 0.5, 0, 1.2, height);
    const chosen = run.individuals.get(this.selected);
    if (!chosen || chosen.row < 0) return;
    g.beginPath();
    g.arc(this.xOf(chosen.birth), this.yOf(chosen.row), 3.2, 0, 7);
    g.fill();
  }
}
