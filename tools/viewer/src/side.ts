// SPDX-License-Identifier: MIT
// The side bar, on a phone a sheet from below: the selected robot, curves, phylogeny and the list of events.
import { make, makeButton } from "./element";
import { EventList } from "./eventlist";
import { Inspector } from "./inspector";
import type { NumbersPanel } from "./numbers";
import { PhylogenyView } from "./phylogeny";
import { Plot, seriesOf } from "./plots";
import type { Event, Run } from "./run";

export type Tab = "overview" | "phylogeny" | "events" | "numbers";
const tabs: [Tab, string, string][] = [
  ["overview", "Overview", "curves and phylogeny"],
  ["phylogeny", "Phylogeny", "the phylogeny alone"],
  ["events", "Events", "what happened, as a list (e)"],
  ["numbers", "Parameters", "the rule parameters, which can change while the run continues"],
];

export interface SideActions {
  select: (id: number) => void;
  seek: (time: number) => void;
  jump: (event: Event) => void;
}

export class Side {
  readonly element = make("aside");
  readonly inspector: Inspector;
  readonly phylogeny: PhylogenyView;
  readonly events: EventList;
  private readonly buttons = new Map<Tab, HTMLButtonElement>();
  private readonly curves = make("div", "curves");
  readonly plots: { population: Plot; energy: Plot; tags: Plot; speed: Plot };
  private drawnTab: Tab = "overview";

  /** `numbers`: of a live run. */
  constructor(actions: SideActions, readonly numbers: NumbersPanel | null = null) {
    const { select, seek, jump } = actions;
    this.inspector = new Inspector(select);
    this.phylogeny = new PhylogenyView(select);
    this.events = new EventList(jump);
    this.plots = {
      population: new Plot("individuals", null, seek),
      energy: new Plot("energy, J", null, seek),
      tags: new Plot("share that shows the filled tag", [0, 1], seek),
      speed: new Plot("speed over a minute, mean and middle half, cm/s", null, seek, true),
    };
    this.curves.append(...Object.values(this.plots).map((plot) => plot.element));
    const row = make("nav", "tabs");
    for (const [tab, text, title] of tabs) {
      if (tab === "numbers" && !numbers) continue;
      const button = makeButton(text, title, () => this.show(tab));
      this.buttons.set(tab, button);
      row.append(button);
    }
    row.append(make("span", "space"), makeButton("×", "close (Esc)", () => this.open(false)));
    row.lastElementChild!.className = "close";
    this.element.append(row, this.inspector.element, this.curves, this.phylogeny.element, this.events.element);
    if (numbers) this.element.append(numbers.element);
    this.show("overview");
  }

  get tab(): Tab {
    return this.drawnTab;
  }
  /** Next to the parameters too: what they do is seen while they change. */
  private get showsCurves(): boolean {
    return this.tab === "overview" || this.tab === "numbers";
  }

  show(tab: Tab): void {
    this.drawnTab = tab;
    for (const [name, button] of this.buttons) button.setAttribute("aria-pressed", String(name === tab));
    this.curves.hidden = !this.showsCurves;
    this.curves.classList.toggle("brief", tab === "numbers");
    this.inspector.element.hidden = tab === "numbers";
    this.phylogeny.element.hidden = tab === "events" || tab === "numbers";
    if (this.numbers) this.numbers.element.hidden = tab !== "numbers";
    this.events.element.hidden = tab !== "events";
    this.resize();
  }

  /** On a phone: brings the sheet up or puts it away. */
  open(isOpen: boolean): void {
    this.element.classList.toggle("open", isOpen);
    this.resize();
  }
  get isOpen(): boolean {
    return this.element.classList.contains("open");
  }

  /** Shows the curves of a run; the speed once its recording was read through. */
  showPlots(run: Run, first: number, last: number): void {
    const series = seriesOf(run);
    this.plots.population.show(series.population, run, first, last);
    this.plots.energy.element.hidden = !series.energy;
    if (series.energy) this.plots.energy.show(series.energy, run, first, last);
    this.plots.tags.element.hidden = !run.hasTags;
    if (run.hasTags) this.plots.tags.show(series.tags, run, first, last);
    this.plots.speed.show(series.speed, run, first, last);
  }

  showRun(run: Run): void {
    this.phylogeny.show(run);
    this.events.show(run);
  }

  /** The run has grown. */
  grow(run: Run, first: number, last: number): void {
    this.phylogeny.grow(run);
    if (this.tab === "events") this.events.grow(run);
    if (this.showsCurves) this.showPlots(run, first, last);
  }

  at(time: number): void {
    for (const plot of Object.values(this.plots)) plot.at(time);
    this.phylogeny.draw(time);
    this.events.at(time);
  }

  resize(): void {
    for (const plot of Object.values(this.plots)) plot.resize();
  }
}
