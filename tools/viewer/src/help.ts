// SPDX-License-Identifier: MIT
// Help in a dialog: the legend, keys and pointer.
import { make, makeButton } from "./element";

/** Keys by the names of the browser, their names and meanings in the help, and their work. */
export interface Key {
  keys: string[];
  name: string;
  meaning: string;
  work: () => void;
}

const pointer: [string, string][] = [
  ["click a robot", "select it; on the floor: clear the selection"],
  ["drag, wheel, right drag", "turn, zoom, move"],
  ["click on the time bar or a curve", "go to that moment"],
  ["violet line", "a parameter changed; point at it to see which"],
  ["wheel, drag, double click on the time bar", "zoom, move, all of it"],
];

export class Help {
  readonly element = make("dialog", "help");
  readonly legend = make("ul", "legend");
  private readonly list = make("dl");

  constructor() {
    this.element.append(make("h2", "", "Marks"), this.legend, make("h2", "", "Keys and pointer"), this.list, makeButton("Close", "(Esc)", () => this.element.close()));
    this.element.addEventListener("click", (e) => {
      if (e.target === this.element) this.element.close();
    });
  }

  show(keys: Key[]): void {
    for (const [name, meaning] of [...keys.map((key): [string, string] => [key.name, key.meaning]), ...pointer]) {
      this.list.append(make("dt", "", name), make("dd", "", meaning));
    }
  }

  toggle(): void {
    if (this.element.open) this.element.close();
    else this.element.showModal();
  }
}
