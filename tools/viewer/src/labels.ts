// SPDX-License-Identifier: MIT
// Name tags over the world: of the robot at hand, of a pair that is followed, and of all that are near.
import { make } from "./element";

const most = 40;

export class Labels {
  readonly element = make("div", "labels");
  private readonly tags: HTMLElement[] = [];
  private used = 0;

  clear(): void {
    this.used = 0;
  }

  /** A name next to a place, CSS pixels; `colour`: of its plate, empty for the usual one. */
  add(text: string, x: number, y: number, colour: string, isMain: boolean): void {
    if (this.used >= most) return;
    let tag = this.tags[this.used];
    if (!tag) {
      tag = make("span");
      this.tags.push(tag);
      this.element.append(tag);
    }
    ++this.used;
    tag.className = isMain ? "tag" : "tag small";
    tag.textContent = text;
    tag.hidden = false;
    tag.style.background = colour;
    tag.style.color = colour ? "#fff" : "";
    tag.style.transform = `translate(calc(${Math.round(x)}px - 50%), ${Math.round(y - 26)}px)`;
  }

  done(): void {
    for (let i = this.used; i < this.tags.length; ++i) this.tags[i].hidden = true;
  }
}
