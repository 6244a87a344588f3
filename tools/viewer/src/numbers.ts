// SPDX-License-Identifier: MIT
// The rule parameters of a live run on sliders, and how it begins again.
import { make, makeButton } from "./element";
import type { Live, LiveNumber } from "./live";
import { changeWords, short, shortPath } from "./sentences";

/** "> 0 and ≤ 1". */
export function boundWords({ lower, upper, lower_excluded }: LiveNumber): string {
  const low = lower === null || lower === undefined ? "" : `${lower_excluded ? ">" : "≥"} ${short(String(lower))}`;
  const high = upper === null || upper === undefined ? "" : `≤ ${short(String(upper))}`;
  return [low, high].filter(Boolean).join(" and ") || "any number";
}

/** The range of a slider: the bounds, or as far as four times the value where there are none. */
export function sliderRange(number: LiveNumber): [number, number] {
  const value = Number(number.value);
  const reach = 4 * Math.max(Math.abs(value), 0.25);
  return [number.lower ?? Math.min(0, value - reach), number.upper ?? Math.max(number.lower ?? 0, value) + reach];
}

interface Row {
  number: LiveNumber;
  element: HTMLElement;
  inputs: HTMLInputElement[];
  back: HTMLButtonElement; // to the table's value
}

export class NumbersPanel {
  readonly element = make("section", "numbers");
  private readonly remark = make("p", "hint");
  private readonly problem = make("p", "problem");
  private readonly seed = make("input");
  private readonly tables = make("select");
  private readonly search = make("input");
  private readonly list = make("div", "list");
  private readonly made = make("ol");
  private rows: Row[] = [];
  private live: Live | null = null;

  constructor(onJump: (time: number) => void) {
    this.seed.type = "number";
    this.seed.min = "0";
    this.seed.title = "seed of the next run";
    this.tables.title = "rule table of the next run";
    const again = make("div", "again");
    again.append(make("label", "", "seed"), this.seed, this.tables, makeButton("Start again", "a new run in a folder of its own, with the parameters as they are now", () => this.live?.restart(Number(this.seed.value), this.tables.value)));
    this.search.type = "search";
    this.search.placeholder = "search: reach, mutation …";
    this.search.addEventListener("input", () => this.filter());
    this.problem.setAttribute("role", "alert");
    this.made.addEventListener("click", (e) => {
      const line = (e.target as HTMLElement).closest<HTMLElement>("[data-time]");
      if (line) onJump(Number(line.dataset.time));
    });
    this.element.append(this.remark, this.problem, again, this.search, this.list, make("h3", "", "changes"), this.made);
  }

  show(live: Live): void {
    this.live = live;
    this.seed.value = String(live.facts.head.seed + 1);
    this.tables.replaceChildren(...live.facts.rule_tables.map((name) => new Option(name, name)));
    this.tables.value = live.facts.head.rule_table;
    this.rows = live.facts.numbers.filter(({ kind }) => kind !== "text").map((number) => this.rowOf(number));
    this.list.replaceChildren(...this.rows.map(({ element }) => element));
    this.filter();
    this.update();
  }

  /** Shows what the run has now. */
  update(): void {
    const { live } = this;
    if (!live) return;
    const { state } = live;
    this.remark.textContent = !live.isConnected
      ? "The program has ended."
      : !state.steers
        ? "Another page steers this run; this one only shows it."
        : state.over
          ? `The run has ended; its files are in ${live.facts.folder}.`
          : `A change acts from the next tick on and is a row of ${live.facts.folder}/changes.csv.`;
    const isOff = !live.isConnected || !state.steers;
    for (const input of this.element.querySelectorAll<HTMLInputElement>(".again input, .again select, .again button")) input.disabled = isOff;
    for (const { number, inputs, back } of this.rows) {
      const value = live.changed.get(number.path) ?? number.value;
      back.hidden = value === number.table;
      back.disabled = isOff || state.over;
      for (const input of inputs) {
        input.disabled = isOff || state.over;
        if (input === document.activeElement) continue;
        if (input.type === "checkbox") input.checked = value === "true";
        else input.value = short(value);
      }
    }
    this.made.replaceChildren(
      ...live.changes.map((change) => {
        const item = make("li");
        const line = makeButton(changeWords([change]), "show this moment", () => undefined);
        line.dataset.time = String(change.time_s);
        item.append(line);
        return item;
      }),
    );
  }

  /** Says why a wish was refused; the parameters go back to what the run has. */
  complain(sentence: string): void {
    this.problem.textContent = sentence;
    (document.activeElement as HTMLElement | null)?.blur?.();
    this.update();
  }

  private rowOf(number: LiveNumber): Row {
    const element = make("div", "number");
    const name = make("label", "", shortPath(number.path));
    name.title = number.path;
    const inputs: HTMLInputElement[] = [];
    const send = (value: string): void => {
      this.problem.textContent = "";
      this.live?.set(number.path, value);
    };
    const box = make("input");
    box.setAttribute("aria-label", number.path);
    inputs.push(box);
    const back = makeButton("↺", `back to the rule table's ${short(number.table)}`, () => send(number.table));
    back.className = "back";
    back.setAttribute("aria-label", `${number.path}, back to the table's value`);
    element.append(name, back);
    if (number.kind === "switch") {
      box.type = "checkbox";
      box.addEventListener("change", () => send(String(box.checked)));
      element.append(box);
    } else {
      const slider = make("input");
      const [low, high] = sliderRange(number);
      slider.type = "range";
      slider.min = String(low);
      slider.max = String(high);
      slider.step = number.kind === "whole" ? "1" : String((high - low) / 400);
      slider.setAttribute("aria-label", `${number.path}, slider`);
      slider.addEventListener("input", () => (box.value = String(Number(Number(slider.value).toPrecision(4)))));
      slider.addEventListener("change", () => send(String(Number(Number(slider.value).toPrecision(4)))));
      slider.addEventListener("pointerup", () => slider.blur());
      box.type = "number";
      box.step = "any";
      box.addEventListener("change", () => send(box.value.trim()));
      inputs.push(slider);
      element.append(box, slider);
    }
    const meaning = [number.help, number.kind === "switch" ? "on or off" : boundWords(number), number.acts_at_start ? "acts when a run starts" : ""];
    element.append(make("p", "hint", meaning.filter(Boolean).join("; ")));
    return { number, element, inputs, back };
  }

  private filter(): void {
    const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const { number, element } of this.rows) {
      const text = `${number.path} ${number.help}`.toLowerCase();
      element.hidden = !words.every((word) => text.includes(word));
    }
  }
}
