// SPDX-License-Identifier: MIT
// Worlds on one time bar, with a side bar of the run and the selected robot.
import { Controls, speeds } from "./controls";
import { Player } from "./director";
import { make } from "./element";
import { makeFrame } from "./frame";
import { Help } from "./help";
import { legendOf } from "./legend";
import { readLink, writeLink } from "./link";
import type { Live } from "./live";
import { NumbersPanel } from "./numbers";
import { branchOf } from "./phylogeny";
import type { Event, Run } from "./run";
import { sentence } from "./sentences";
import { Side, type Tab } from "./side";
import { onThemeChange } from "./theme";
import { TimeBar } from "./timebar";
import type { View, World } from "./world";

/** A death is seen for at least so long, ecology seconds, and for at least a second of the viewer's. */
const leastFlashSeconds = 6;
/** More deaths than those of that time would hide the robots, ecology seconds. */
const mostFlashSeconds = 1000;
/** The sentence about an event stands for so many ecology seconds. */
const bannerSeconds = 10;

export class App {
  time = 0;
  playing = false;
  speed = 10;
  current = 0;
  /** The selected individual; NaN: none. */
  selected = NaN;
  /** Empty places are runs that cannot be drawn, as without WebGL. */
  readonly worlds: (World | null)[] = [];
  /** The event at hand, and the scene in which it is played. */
  event: Event | null = null;
  scene: Player | null = null;
  private before: { speed: number; playing: boolean } | null = null;
  private readonly branches = new Map<number, Set<number>>();
  private readonly shown = { trails: true, links: true };
  private dirty = true;
  private drawing = false;
  private last = 0;
  private addressAt = 0;
  private counts: HTMLElement[] = [];
  private readonly legend = make("ul", "legend");
  private readonly views = make("div", "views");
  private readonly banner = make("p", "banner");
  private readonly frames: HTMLElement[] = [];
  readonly timebar = new TimeBar((time, event) => (event ? this.show(event) : this.seek(time)));
  readonly side: Side;
  readonly help = new Help();
  private readonly controls: Controls;
  private readonly stopping = new AbortController();
  /** For a live run: whether it is shown as it is now, and whether it has grown since the page was drawn. */
  private isNow = false;
  private hasGrown = false;
  private grownAt = -Infinity;
  private readonly notice = make("p", "notice");

  /** `live`: of a live run, the only one. */
  constructor(readonly runs: Run[], readonly live: Live | null = null) {
    const seek = (time: number): void => this.seek(time);
    this.side = new Side({ select: (id) => this.select(id), seek, jump: (event) => this.jump(event) }, live ? new NumbersPanel(seek) : null);
    this.isNow = live !== null;
    this.controls = new Controls(
      {
        play: (playing) => this.play(playing),
        step: (ticks) => this.step(ticks),
        setSpeed: (speed) => this.setSpeed(speed),
        nextCatch: (direction) => this.nextCatch(direction),
        look: (view) => this.look(view),
        redraw: () => (this.dirty = true),
        copyLink: () => void navigator.clipboard?.writeText(this.writeAddress()).catch(() => undefined),
        help: () => this.help.toggle(),
        sheet: () => this.side.open(!this.side.isOpen),
        toEnd: () => this.toEnd(),
      },
      this.shown,
      live !== null,
    );
    this.build();
    runs.forEach((run, number) => this.addWorld(run, number));
    this.views.style.setProperty("--columns", String(Math.ceil(Math.sqrt(runs.length))));
    this.time = this.firstTime;
    new ResizeObserver(() => this.resize()).observe(this.views);
    const { signal } = this;
    window.addEventListener("hashchange", () => this.follow(), { signal });
    onThemeChange(() => this.paint(), signal);
    this.setCurrent(0);
    if (live) {
      this.side.numbers?.show(live);
      this.showState();
      this.toEnd();
    } else {
      this.follow();
    }
    this.resize();
    requestAnimationFrame((now) => this.tick(now));
  }

  get run(): Run {
    return this.runs[this.current];
  }
  get phylogeny(): Side["phylogeny"] {
    return this.side.phylogeny;
  }
  get firstTime(): number {
    return Math.min(...this.runs.map((run) => run.firstTime));
  }
  get lastTime(): number {
    return this.live?.newest ?? Math.max(...this.runs.map((run) => run.lastTime));
  }

  private build(): void {
    const header = make("header");
    this.notice.hidden = true;
    header.append(make("h1", "", "trophic"), this.legend);
    const main = make("main");
    main.append(this.views, this.side.element);
    const footer = make("footer");
    footer.append(this.controls.element, this.timebar.element);
    document.getElementById("app")!.replaceChildren(header, main, footer, this.notice, this.help.element);
  }

  private addWorld(run: Run, number: number): void {
    const { frame, world } = makeFrame(run, {
      pick: (body) => {
        if (number !== this.current) this.setCurrent(number);
        this.select(body < 0 ? NaN : run.agents.id[run.rowAt(this.rowTime) + body]);
        if (body >= 0) this.side.open(true);
      },
      redraw: () => (this.dirty = true),
      press: () => {
        if (number !== this.current) this.setCurrent(number);
      },
    });
    this.views.append(frame);
    this.frames.push(frame);
    this.worlds.push(world);
  }

  setCurrent(number: number): void {
    if (number !== this.current) {
      this.selected = NaN;
      this.leaveScene();
      this.event = null;
    }
    this.current = number;
    this.frames.forEach((frame, i) => frame.classList.toggle("current", this.runs.length > 1 && i === number));
    this.frames[number].append(this.banner);
    this.showLegend();
    this.timebar.show(this.run, this.firstTime, this.lastTime);
    this.side.showRun(this.run);
    this.showPlots();
    this.select(this.selected);
  }

  private showLegend(): void {
    const { items, counts } = legendOf(this.run);
    counts.forEach((count, species) => (count.textContent = this.counts[species]?.textContent ?? ""));
    this.counts = counts;
    this.legend.replaceChildren(...items);
    this.help.legend.replaceChildren(...legendOf(this.run).items);
  }

  /** Draws the current run's curves anew; the speed comes once its recording was read through. */
  showPlots(): void {
    this.side.showPlots(this.run, this.firstTime, this.lastTime);
    this.dirty = true;
  }

  private paint(): void {
    for (const world of this.worlds) world?.paint();
    this.showLegend();
    this.side.events.show(this.run);
    this.showPlots();
  }

  select(id: number): void {
    this.selected = this.run.individuals.has(id) ? id : NaN;
    this.branches.clear();
    if (!Number.isNaN(this.selected)) this.branches.set(this.current, branchOf(this.run, this.selected).descendants);
    this.phylogeny.select(this.selected);
    this.dirty = true;
  }

  look(view: View): void {
    this.leaveScene();
    for (const world of this.worlds) world?.look(view);
    this.controls.showView(view);
    this.dirty = true;
  }
  get view(): View {
    return this.worlds[this.current]?.view ?? "orbit";
  }

  /** Aborted when the page is left to another app. */
  get signal(): AbortSignal {
    return this.stopping.signal;
  }
  /** Leaves the page to another app. */
  stop(): void {
    this.stopping.abort();
    for (const world of this.worlds) world?.stop();
  }

  /** The run has grown: what is drawn of all of it follows when there is time. */
  grown(): void {
    this.hasGrown = true;
    this.dirty = true;
  }
  private showGrowth(now: number): void {
    if (!this.hasGrown || now - this.grownAt < 700) return;
    this.hasGrown = false;
    this.timebar.show(this.run, this.firstTime, this.lastTime);
    this.side.grow(this.run, this.firstTime, this.lastTime);
    if (this.run.foods.length > 0) this.showLegend();
    // Half of the time is for the world.
    this.grownAt = performance.now() + (performance.now() - now);
  }

  /** Shows what the live run is asked to do. */
  showState(): void {
    const { live } = this;
    if (!live) return;
    const { paused, speed, steers, over } = live.state;
    this.playing = !paused && !over && live.isConnected;
    this.speed = speed;
    this.controls.enable(steers && !over && live.isConnected);
    this.frames[0].querySelector(".rules")!.textContent = live.state.name;
    this.side.numbers?.update();
    this.dirty = true;
  }

  /** A sentence from the program. */
  say(sentence: string): void {
    this.notice.textContent = sentence;
    this.notice.hidden = false;
    this.side.numbers?.complain(sentence);
    const { notice } = this;
    setTimeout(() => (notice.hidden = notice.hidden || notice.textContent === sentence), 8000);
  }

  toEnd(): void {
    this.seek(this.lastTime);
    this.isNow = this.live !== null;
  }

  play(playing: boolean): void {
    if (this.live && !this.scene) return this.live.play(playing);
    if (playing && this.time >= this.lastTime) this.time = this.firstTime;
    this.playing = playing;
    if (this.before) this.before.playing = playing;
    this.dirty = true;
  }

  setSpeed(speed: number): void {
    if (this.live && !this.scene) return this.live.setSpeed(speed);
    this.speed = speed;
    if (this.before) this.before.speed = speed;
    this.dirty = true;
  }
  /** The next speed of the list. */
  faster(steps: number): void {
    const all = this.live ? [...speeds, 0] : speeds; // 0: as fast as it goes
    this.setSpeed(all[Math.min(all.length - 1, Math.max(0, all.indexOf(this.speed) + steps))]);
  }

  /** Goes to a moment; what was played is left. */
  seek(time: number): void {
    this.leaveScene();
    this.isNow = false;
    this.goTo(time);
  }
  private goTo(time: number): void {
    this.time = Math.min(this.lastTime, Math.max(this.firstTime, time));
    this.dirty = true;
  }

  /** Shows the moment of an event and whom it happened to. */
  show(event: Event): void {
    this.seek(event.time);
    this.event = event;
    this.select(event.id);
  }

  /** Plays a catch from some seconds before it, or shows the moment of another event. */
  jump(event: Event): void {
    const { scene } = event;
    if (!scene) return this.show(event);
    const before = this.before ?? { speed: this.speed, playing: this.playing };
    this.leaveScene();
    this.event = event;
    this.scene = new Player(scene, this.run.lastTime);
    this.before = before;
    this.speed = 1;
    this.playing = true;
    this.controls.showView(null);
    this.worlds[this.current]?.take(scene.camera);
    this.goTo(Math.max(this.run.firstTime, scene.begins_s));
    this.select(event.id);
  }

  /** Ends the scene that is played; speed and view are those before it. */
  private leaveScene(): void {
    if (!this.scene || !this.before) return;
    this.scene = null;
    this.speed = this.before.speed;
    this.playing = this.before.playing;
    this.before = null;
    if (this.live) this.showState();
    this.worlds[this.current]?.look(this.view);
    this.controls.showView(this.view);
    this.dirty = true;
  }

  step(ticks: number): void {
    if (this.live && ticks > 0 && this.isNow) return this.live.tick();
    const { tick_s } = this.run.recording.head;
    this.leaveScene();
    if (!this.live) this.play(false);
    const now = this.time / tick_s;
    this.seek((ticks > 0 ? Math.floor(now + 1e-9) + ticks : Math.ceil(now - 1e-9) + ticks) * tick_s);
  }

  nextCatch(direction: number): void {
    const catches = this.run.catches.filter(({ time }) => time >= this.run.firstTime && time <= this.run.lastTime);
    const isNear = this.event && Math.abs(this.time - this.event.time) <= bannerSeconds;
    const here = isNear ? catches.indexOf(this.event!) : -1;
    let next = here < 0 ? catches.findIndex((e) => e.time > this.time + 1e-6) : here + direction;
    if (here < 0 && direction < 0) next = (next < 0 ? catches.length : next) - 1;
    if (catches[next]) this.jump(catches[next]);
  }

  /** Esc: leaves what is open, then the scene, then the selection. */
  leave(): void {
    if (this.side.isOpen) this.side.open(false);
    else if (this.scene) this.leaveScene();
    else this.select(NaN);
    (document.activeElement as HTMLElement | null)?.blur?.();
  }
  openTab(tab: Tab): void {
    this.side.open(true);
    this.side.show(tab);
    this.dirty = true;
  }

  link(): string {
    return writeLink({
      time: this.time,
      robot: Number.isNaN(this.selected) ? undefined : this.selected,
      run: this.current > 0 ? this.current : undefined,
      view: this.view,
    });
  }
  private writeAddress(): string {
    if (location.protocol !== "blob:") history.replaceState(null, "", this.link());
    return location.href;
  }

  /** Goes where the link says; without one, plays a catch. */
  private follow(): void {
    const moment = readLink(location.hash);
    if (moment.run !== undefined && this.runs[moment.run]) this.setCurrent(moment.run);
    this.look(this.controls.isView(moment.view) ? moment.view : this.view);
    if (moment.time !== undefined) {
      this.play(false);
      this.seek(moment.time);
    }
    if (moment.robot !== undefined) this.select(moment.robot);
    const isStill = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (moment.time !== undefined || moment.robot !== undefined || isStill) return;
    const good = this.run.catches.find(({ scene }) => scene?.opens);
    this.play(true);
    if (good) this.jump(good);
  }

  resize(): void {
    this.frames.forEach((frame, i) => this.worlds[i]?.resize(frame.clientWidth, frame.clientHeight));
    this.side.resize();
    this.dirty = true;
  }

  private tick(now: number): void {
    if (this.stopping.signal.aborted) return;
    const passed = Math.min(0.25, (now - this.last) / 1000);
    this.last = now;
    this.showGrowth(now);
    if (!this.drawing && (this.scene || this.playing || this.isNow)) this.advance(passed);
    if (this.dirty && !this.drawing) void this.draw();
    if (now - this.addressAt > 1000 && this.settled && !this.live) {
      this.addressAt = now;
      if (location.hash !== this.link()) this.writeAddress();
    }
    requestAnimationFrame((next) => this.tick(next));
  }

  private advance(passed: number): void {
    if (this.scene) {
      const { time, isOver } = this.scene.advance(this.time, passed, this.speed);
      this.goTo(time);
      if (isOver) this.leaveScene();
      return;
    }
    if (this.live) return this.advanceLive(passed);
    this.goTo(this.time + passed * this.speed);
    if (this.time >= this.lastTime) this.play(false);
  }

  /** Keeps up with a live run, smoothly where its speed allows. */
  private advanceLive(passed: number): void {
    if (!this.isNow || !this.live) return;
    const { newest } = this.live;
    const behind = newest - this.time;
    if (behind <= 0) return;
    const { tick_s } = this.run.recording.head;
    const isSmooth = this.speed > 0 && behind <= 3 * tick_s;
    this.goTo(isSmooth ? Math.min(newest, this.time + passed * this.speed * (behind > 1.5 * tick_s ? 1.25 : 1)) : newest - (this.speed > 0 ? tick_s : 0));
  }

  /** Time of the occupants: just before a catch that is shown, because at its own tick the victim's body has its successor. */
  get rowTime(): number {
    const { event, time } = this;
    if (!event || event.kind !== "catch" || time !== event.time) return time;
    const isHeld = this.scene ? this.scene.isHeld(time) : !this.playing;
    return isHeld ? time - 0.5 * this.run.recording.head.tick_s : time;
  }

  private async draw(): Promise<void> {
    this.drawing = true;
    this.dirty = false;
    const { time, rowTime } = this;
    const within = (run: Run, moment: number): number => Math.min(run.lastTime, Math.max(run.firstTime, moment));
    await Promise.all(this.runs.map((run) => run.recording.prepare(run.recording.frameAt(within(run, time)))));
    this.worlds.forEach((world, number) => {
      if (!world) return;
      const { run } = world;
      const isCurrent = number === this.current;
      const body = isCurrent && !Number.isNaN(this.selected) ? run.bodyOf(this.selected, within(run, rowTime)) : -1;
      world.draw({
        time: within(run, time),
        rowTime: within(run, rowTime),
        selected: body,
        scene: isCurrent ? (this.scene?.scene ?? null) : null,
        victim: isCurrent && this.isNearEvent && this.event?.kind === "catch" ? this.event.other : NaN,
        highlighted: this.branches.get(number) ?? new Set(),
        flashSeconds: Math.min(mostFlashSeconds, Math.max(leastFlashSeconds, this.speed)), // a live run at its fastest, speed 0: the least
        shown: this.shown,
      });
    });
    this.controls.show(time, this.playing, this.speed);
    this.controls.showNow(this.isNow);
    this.timebar.draw(time);
    this.side.at(time);
    this.showTexts(within(this.run, rowTime));
    this.drawing = false;
  }

  private get isNearEvent(): boolean {
    return this.event !== null && Math.abs(this.time - this.event.time) <= Math.max(bannerSeconds, this.speed);
  }

  private showTexts(time: number): void {
    const { run, event } = this;
    const row = run.rowAt(time);
    const branch = this.branches.get(this.current);
    let living = 0;
    const alive = run.index.species.map(() => 0);
    for (let at = row; at < row + run.robots; ++at) {
      if (run.agents.id[at] < 0) continue;
      if (branch?.has(run.agents.id[at])) ++living;
      ++alive[run.agents.species[at]];
    }
    this.counts.forEach((count, species) => (count.textContent = alive[species] || run.diedOut(species) > time ? String(alive[species]) : `0, died out at ${run.diedOut(species).toFixed(0)} s`));
    this.side.inspector.show(run, this.selected, time, this.worlds[this.current], living);
    this.banner.hidden = !this.isNearEvent;
    if (!event || this.banner.hidden) return;
    const ahead = event.time - this.time;
    this.banner.textContent = sentence(run, event) + (ahead > 0 ? ` (in ${Math.ceil(ahead)} s)` : "") + (event.scene?.reach_m ? ` · reach ${event.scene.reach_m} m` : "") + (event.scene?.remark ? ` · ${event.scene.remark}` : "");
    this.banner.classList.toggle("happened", ahead <= 0 && (event.kind === "catch" || event.kind === "death"));
  }

  /** Whether what is drawn is the moment that was asked for. */
  get settled(): boolean {
    return !this.dirty && !this.drawing;
  }
}
