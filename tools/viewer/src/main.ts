// SPDX-License-Identifier: MIT
// The page: worlds side by side on one time bar, next to the data of the run and the selected robot.
import uPlotStyle from "uplot/dist/uPlot.min.css";
import { Inspector } from "./inspector";
import { colourOf } from "./colours";
import { readLink, writeLink } from "./link";
import { branchOf, PhylogenyView } from "./phylogeny";
import { Plot, seriesOf } from "./plots";
import { type Event, Run, type RunIndex } from "./run";
import style from "./style.css";
import { TimeBar } from "./timebar";
import { World, type View } from "./world";

const speeds = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50, 100];

function make<K extends keyof HTMLElementTagNameMap>(tag: K, className = "", text = ""): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  element.className = className;
  element.textContent = text;
  return element;
}

class App {
  time = 0;
  playing = false;
  speed = 10;
  current = 0;
  /** The selected individual; NaN: none. */
  selected = NaN;
  readonly worlds: World[] = [];
  private readonly branches = new Map<number, Set<number>>();
  private readonly shown = { trails: true, links: true };
  private dirty = true;
  private drawing = false;
  private last = 0;
  private pictureTimes: number[] = [];
  private readonly legend = make("ul", "legend");
  private readonly clock = make("output", "clock");
  private readonly playButton = make("button", "play", "Play");
  private readonly speedBox = make("select");
  private readonly viewButtons = new Map<View, HTMLButtonElement>();
  private readonly views = make("div", "views");
  private readonly frames: HTMLElement[] = [];
  readonly timebar = new TimeBar((time, event) => this.jump(time, event));
  private readonly inspector = new Inspector((id) => this.select(id));
  readonly phylogeny = new PhylogenyView((id) => this.select(id));
  private readonly plots = {
    population: new Plot("individuals", null, (time) => this.seek(time)),
    tags: new Plot("share that shows the filled tag", [0, 1], (time) => this.seek(time)),
    speed: new Plot("speed over a minute, cm/s", null, (time) => this.seek(time)),
  };

  constructor(readonly runs: Run[]) {
    const app = document.getElementById("app")!;
    app.replaceChildren(this.header(), this.main(), this.footer());
    runs.forEach((run, number) => this.addWorld(run, number));
    this.views.style.setProperty("--columns", String(Math.ceil(Math.sqrt(runs.length))));
    this.time = this.firstTime;
    new ResizeObserver(() => this.resize()).observe(this.views);
    window.addEventListener("hashchange", () => this.follow());
    window.addEventListener("keydown", (e) => this.key(e));
    this.setCurrent(0);
    this.follow();
    this.resize();
    requestAnimationFrame((now) => this.tick(now));
  }

  get run(): Run {
    return this.runs[this.current];
  }
  get firstTime(): number {
    return Math.min(...this.runs.map((run) => run.firstTime));
  }
  get lastTime(): number {
    return Math.max(...this.runs.map((run) => run.lastTime));
  }

  private header(): HTMLElement {
    const header = make("header");
    header.append(make("h1", "", "trophic"), this.legend);
    return header;
  }
  /** Names the colours and marks of the current run. */
  private showLegend(): void {
    const { legend } = this;
    legend.replaceChildren();
    this.run.index.species.forEach((name, species) => {
      const item = make("li", "", name);
      const dot = make("i");
      dot.style.background = colourOf(species);
      item.prepend(dot);
      legend.append(item);
    });
    legend.append(
      this.sign("filled", this.tagName(Math.max(...this.run.index.tags))),
      this.sign("hollow", this.run.index.tags.length === 2 ? this.tagName(Math.min(...this.run.index.tags)) : "other tags"),
      this.sign("grey", "not yet active"),
      this.sign("caught", "death"),
    );
  }
  private tagName(tag: number): string {
    return `tag ${tag > 0 ? "+" : ""}${tag}`;
  }
  private sign(kind: string, text: string): HTMLElement {
    const item = make("li", "", text);
    item.prepend(make("i", kind));
    return item;
  }

  private main(): HTMLElement {
    const main = make("main");
    const side = make("aside");
    const tree = make("section", "tree");
    const drawing = make("div");
    drawing.append(this.phylogeny.canvas);
    tree.append(make("h3", "", "phylogeny: a line a life, over time"), drawing);
    side.append(this.inspector.element, this.plots.population.element, this.plots.tags.element, this.plots.speed.element, tree);
    main.append(this.views, side);
    return main;
  }

  private footer(): HTMLElement {
    const footer = make("footer");
    const controls = make("div", "controls");
    const button = (text: string, title: string, work: () => void): HTMLButtonElement => {
      const made = make("button", "", text);
      made.title = title;
      made.addEventListener("click", work);
      return made;
    };
    this.playButton.title = "play or pause (space)";
    this.playButton.addEventListener("click", () => this.play(!this.playing));
    for (const speed of speeds) this.speedBox.append(new Option(`${speed}×`, String(speed), false, speed === this.speed));
    this.speedBox.title = "ecology seconds a second";
    this.speedBox.addEventListener("change", () => (this.speed = Number(this.speedBox.value)));
    const looks: [View, string, string][] = [["orbit", "Orbit", "turn, zoom and move freely (o)"], ["top", "Top", "from above (t)"], ["follow", "Follow", "stay with the selected robot (f)"]];
    const viewGroup = make("span", "group");
    for (const [view, text, title] of looks) {
      const made = button(text, title, () => this.look(view));
      this.viewButtons.set(view, made);
      viewGroup.append(made);
    }
    const toggle = (text: string, key: "trails" | "links"): HTMLElement => {
      const label = make("label", "", text);
      const box = make("input");
      box.type = "checkbox";
      box.checked = this.shown[key];
      box.addEventListener("change", () => {
        this.shown[key] = box.checked;
        this.dirty = true;
      });
      label.prepend(box);
      return label;
    };
    const copy = button("Copy link", "a link to this moment and robot", () => {
      history.replaceState(null, "", this.link());
      void navigator.clipboard?.writeText(location.href).catch(() => undefined);
    });
    controls.append(
      button("−1", "a decision back (←)", () => this.step(-1)),
      this.playButton,
      button("+1", "a decision forward (→)", () => this.step(1)),
      this.speedBox,
      this.clock,
      button("Previous catch", "(p)", () => this.nextCatch(-1)),
      button("Next catch", "(n)", () => this.nextCatch(1)),
      make("span", "space"),
      toggle("trails", "trails"),
      toggle("who perceives whom", "links"),
      viewGroup,
    );
    // A page inside another one has no address of its own.
    if (location.protocol !== "blob:") controls.append(copy);
    footer.append(controls, this.timebar.element);
    return footer;
  }

  private addWorld(run: Run, number: number): void {
    const frame = make("figure", "view");
    const world = new World(
      run,
      (body) => {
        if (number !== this.current) this.setCurrent(number);
        this.select(body < 0 ? NaN : run.agents.id[run.rowAt(this.time) + body]);
      },
      () => (this.dirty = true),
    );
    const { head } = run.recording;
    const caption = make("figcaption");
    caption.append(make("b", "", run.index.label), ` ${head.rule_table}, ${head.backend}, seed ${head.seed}`);
    if (run.index.status !== "complete") caption.append(make("em", "", ` ${run.index.status}`));
    frame.append(world.canvas, world.label, caption);
    frame.addEventListener("pointerdown", () => {
      if (number !== this.current) this.setCurrent(number);
    });
    this.views.append(frame);
    this.frames.push(frame);
    this.worlds.push(world);
  }

  setCurrent(number: number): void {
    if (number !== this.current) this.selected = NaN;
    this.current = number;
    this.frames.forEach((frame, i) => frame.classList.toggle("current", this.runs.length > 1 && i === number));
    this.showLegend();
    this.timebar.show(this.run, this.firstTime, this.lastTime);
    this.phylogeny.show(this.run);
    this.showPlots();
    this.select(this.selected);
  }

  /** Draws the current run's curves again; the speed follows when its recording has been read. */
  showPlots(): void {
    const series = seriesOf(this.run);
    const { species } = this.run.index;
    this.plots.population.show(series.population, species, this.firstTime, this.lastTime);
    this.plots.tags.show(series.tags, species, this.firstTime, this.lastTime);
    this.plots.speed.show(series.speed, species, this.firstTime, this.lastTime);
    this.dirty = true;
  }

  select(id: number): void {
    this.selected = this.run.individuals.has(id) ? id : NaN;
    this.branches.clear();
    if (!Number.isNaN(this.selected)) this.branches.set(this.current, branchOf(this.run, this.selected).descendants);
    this.phylogeny.select(this.selected);
    this.dirty = true;
  }

  look(view: View): void {
    for (const world of this.worlds) world.look(view);
    for (const [name, button] of this.viewButtons) button.classList.toggle("on", name === view);
    this.dirty = true;
  }

  play(playing: boolean): void {
    if (playing && this.time >= this.lastTime) this.time = this.firstTime;
    this.playing = playing;
    this.playButton.textContent = playing ? "Pause" : "Play";
    this.dirty = true;
  }

  seek(time: number): void {
    this.time = Math.min(this.lastTime, Math.max(this.firstTime, time));
    this.dirty = true;
  }

  private jump(time: number, event: Event | null): void {
    this.seek(time);
    if (event) this.select(event.id);
  }

  step(ticks: number): void {
    const { tick_s } = this.run.recording.head;
    this.play(false);
    const now = this.time / tick_s;
    this.seek((ticks > 0 ? Math.floor(now + 1e-9) + ticks : Math.ceil(now - 1e-9) + ticks) * tick_s);
  }

  nextCatch(direction: number): void {
    const catches = this.run.events.filter((event) => event.kind === "catch");
    const next = direction > 0 ? catches.find((e) => e.time > this.time + 1e-6) : catches.reverse().find((e) => e.time < this.time - 1e-6);
    if (next) this.jump(next.time, next);
  }

  private key(e: KeyboardEvent): void {
    if (e.target instanceof HTMLSelectElement || e.ctrlKey || e.metaKey || e.altKey) return;
    const work: Record<string, () => void> = {
      " ": () => this.play(!this.playing),
      ArrowLeft: () => this.step(-1),
      ArrowRight: () => this.step(1),
      n: () => this.nextCatch(1),
      p: () => this.nextCatch(-1),
      o: () => this.look("orbit"),
      t: () => this.look("top"),
      f: () => this.look("follow"),
    };
    if (!work[e.key]) return;
    e.preventDefault();
    work[e.key]();
  }

  link(): string {
    const view = this.worlds[this.current].view;
    return writeLink({
      time: this.time,
      robot: Number.isNaN(this.selected) ? undefined : this.selected,
      run: this.current > 0 ? this.current : undefined,
      view,
    });
  }

  /** Opens the moment, robot and view of the link. */
  private follow(): void {
    const moment = readLink(location.hash);
    if (moment.run !== undefined && this.runs[moment.run]) this.setCurrent(moment.run);
    if (moment.time !== undefined) this.seek(moment.time);
    if (moment.robot !== undefined) this.select(moment.robot);
    const view = moment.view as View | undefined;
    this.look(view && this.viewButtons.has(view) ? view : this.worlds[this.current].view);
  }

  private resize(): void {
    this.frames.forEach((frame, i) => this.worlds[i].resize(frame.clientWidth, frame.clientHeight));
    for (const plot of Object.values(this.plots)) plot.resize();
    this.dirty = true;
  }

  private tick(now: number): void {
    const passed = Math.min(0.25, (now - this.last) / 1000);
    this.last = now;
    if (this.playing && !this.drawing) {
      this.seek(this.time + passed * this.speed);
      if (this.time >= this.lastTime) this.play(false);
    }
    if (this.dirty && !this.drawing) void this.draw();
    requestAnimationFrame((next) => this.tick(next));
  }

  private async draw(): Promise<void> {
    this.drawing = true;
    this.dirty = false;
    const time = this.time;
    const within = (run: Run): number => Math.min(run.lastTime, Math.max(run.firstTime, time));
    await Promise.all(this.runs.map((run) => run.recording.prepare(run.recording.frameAt(within(run)))));
    const start = performance.now();
    this.worlds.forEach((world, number) => {
      const { run } = world;
      const body = number === this.current && !Number.isNaN(this.selected) ? run.bodyOf(this.selected, within(run)) : -1;
      world.draw(within(run), body, this.branches.get(number) ?? new Set(), this.shown);
    });
    this.clock.textContent = `${time.toFixed(1)} s`;
    this.timebar.draw(time);
    for (const plot of Object.values(this.plots)) plot.at(time);
    this.phylogeny.draw(time);
    this.showInspector(within(this.run));
    this.pictureTimes.push(performance.now() - start);
    if (this.pictureTimes.length > 30) this.pictureTimes.shift();
    this.drawing = false;
  }

  private showInspector(time: number): void {
    const { run } = this;
    const row = run.rowAt(time);
    const branch = this.branches.get(this.current);
    let living = 0;
    for (let body = 0; branch && body < run.robots; ++body) if (branch.has(run.agents.id[row + body])) ++living;
    this.inspector.show(run, this.selected, time, this.worlds[this.current].drawn, living);
  }

  /** Times of the last pictures, ms each. */
  get pictureMs(): number[] {
    return [...this.pictureTimes];
  }

  /** Whether the requested moment is drawn. */
  get settled(): boolean {
    return !this.dirty && !this.drawing;
  }
}

declare global {
  interface Window {
    trophic?: App;
    trophicError?: string;
  }
}

async function open(): Promise<void> {
  const sheet = make("style", "", uPlotStyle + style);
  document.head.append(sheet);
  const index = JSON.parse(document.getElementById("trophic-index")!.textContent!) as { title: string; runs: RunIndex[] };
  document.title = index.title;
  const runs: Run[] = [];
  for (const [number, one] of index.runs.entries()) runs.push(await Run.open(one, number));
  const app = new App(runs);
  window.trophic = app;
  const pause = (): Promise<void> => new Promise((resume) => setTimeout(resume));
  for (const run of runs) {
    await run.readTracks(pause);
    if (run === app.run) app.showPlots();
  }
}

open().catch((error: unknown) => {
  window.trophicError = String(error);
  const message = make("p", "error", `This page cannot be shown: ${error instanceof Error ? error.message : String(error)}`);
  document.getElementById("app")!.replaceChildren(message);
  console.error(error);
});
