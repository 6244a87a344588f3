// SPDX-License-Identifier: MIT
// Events as a list to read, search and click.
import { colourOf } from "./colours";
import { make } from "./element";
import { firstAfter } from "./moments";
import type { Event, Run } from "./run";
import { sentence } from "./sentences";

/** A list of more is cut; the search finds the rest. */
const most = 400;
const kinds = [["", "all"], ["catch", "catches"], ["death", "deaths"], ["birth", "births"], ["tag_switch", "tag switches"], ["activation", "activations"]];
/** What of them happens in a run, as far as its rules say. */
const happens: Record<string, (run: Run) => boolean> = { catch: (run) => run.fills("capture"), tag_switch: (run) => run.hasTags, activation: (run) => run.fills("activation") };

export class EventList {
  readonly element = make("section", "events");
  readonly search = make("input");
  private readonly kind = make("select");
  private readonly list = make("ol");
  private readonly remark = make("p", "hint");
  private run: Run | null = null;
  private shown: Event[] = [];
  private near = -1;
  private listedFrom = 0;

  constructor(onJump: (event: Event) => void) {
    this.search.type = "search";
    this.search.placeholder = "search: 19, caught, prey …";
    this.search.title = "words that a line must have, in any order (/)";
    this.search.addEventListener("input", () => this.fill());
    for (const [value, text] of kinds) this.kind.append(new Option(text, value));
    this.kind.title = "which events";
    this.kind.value = "catch";
    this.kind.addEventListener("change", () => this.fill());
    const head = make("div", "search");
    head.append(this.kind, this.search);
    this.list.addEventListener("click", (e) => {
      const line = (e.target as HTMLElement).closest("button");
      if (line) onJump(this.shown[Number(line.dataset.at)]);
    });
    this.element.append(head, this.remark, this.list);
  }

  show(run: Run): void {
    this.run = run;
    for (const option of this.kind.options) option.hidden = !(happens[option.value]?.(run) ?? true);
    if (this.kind.selectedOptions[0]?.hidden) this.kind.value = "";
    this.fill();
  }

  /** As `show`, if there are more events than were listed from. */
  grow(run: Run): void {
    if (run !== this.run || run.events.length !== this.listedFrom) this.show(run);
  }

  private fill(): void {
    const { run } = this;
    if (!run) return;
    this.listedFrom = run.events.length;
    const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    // A catch is also the death of its victim: one line for both, unless deaths are asked for.
    const isAsked = ({ kind, cause }: Event): boolean => (this.kind.value ? kind === this.kind.value : !(kind === "death" && cause === "caught"));
    const found: [Event, string][] = [];
    for (const event of run.events) {
      if (!isAsked(event)) continue;
      const text = sentence(run, event);
      const all = `${event.time.toFixed(0)} s ${text}`.toLowerCase().split(/[\s:,]+/);
      if (words.every((word) => all.some((one) => (/^\d+$/.test(word) ? one === word : one.includes(word))))) found.push([event, text]);
    }
    this.remark.textContent = found.length > most ? `${found.length} events, the first ${most} are listed` : found.length === 1 ? "1 event" : `${found.length} events`;
    this.shown = found.slice(0, most).map(([event]) => event);
    this.near = -1;
    this.list.replaceChildren(
      ...found.slice(0, most).map(([event, text], number) => {
        const item = make("li");
        const line = make("button");
        const dot = make("i");
        dot.style.background = colourOf(event.species);
        line.type = "button";
        line.dataset.at = String(number);
        line.append(make("time", "", `${event.time.toFixed(0)} s`), dot, text);
        item.append(line);
        return item;
      }),
    );
  }

  /** Marks the last event at or before a moment, and keeps it in view. */
  at(time: number): void {
    const near = firstAfter(this.shown, time) - 1;
    if (near === this.near || this.element.hidden) return;
    this.list.children[this.near]?.classList.remove("now");
    this.near = near;
    const line = this.list.children[near] as HTMLElement | undefined;
    if (!line) return;
    line.classList.add("now");
    const { list } = this;
    if (line.offsetTop < list.scrollTop || line.offsetTop + line.offsetHeight > list.scrollTop + list.clientHeight) list.scrollTop = line.offsetTop - list.clientHeight / 2;
  }
}
