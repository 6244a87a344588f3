// SPDX-License-Identifier: MIT
// Controls above the time bar: playing, catches, views.
import { make, makeButton } from "./element";
import type { Shown, View } from "./world";

export const speeds = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50, 100];

export interface ControlActions {
  play: (playing: boolean) => void;
  step: (ticks: number) => void;
  setSpeed: (speed: number) => void;
  nextCatch: (direction: number) => void;
  look: (view: View) => void;
  redraw: () => void;
  copyLink: () => void;
  help: () => void;
  toEnd: () => void;
  sheet: () => void;
}

const looks: [View, string, string][] = [
  ["orbit", "Orbit", "turn, zoom and move freely (o)"],
  ["top", "Top", "from above (t)"],
  ["follow", "Follow", "stay with the selected robot (f)"],
];

export class Controls {
  readonly element = make("div", "controls");
  private readonly clock = make("output", "clock");
  private readonly playButton = make("button", "play", "Play");
  private readonly speedBox = make("select");
  private readonly nowButton = make("button", "now", "Now");
  private readonly viewButtons = new Map<View, HTMLButtonElement>();
  private playing = false;

  /** `isLive`: of a live run, which can be as fast as it goes. */
  constructor(actions: ControlActions, shown: Shown, isLive = false) {
    this.playButton.title = "play or pause (space)";
    this.playButton.addEventListener("click", () => actions.play(!this.playing));
    for (const speed of speeds) this.speedBox.append(new Option(`${speed}×`, String(speed)));
    if (isLive) this.speedBox.append(new Option("max", "0"));
    this.speedBox.title = "ecology seconds a second (up, down)";
    this.speedBox.addEventListener("change", () => {
      actions.setSpeed(Number(this.speedBox.value));
      this.speedBox.blur(); // so that keys go to the page
    });
    const views = make("span", "group");
    for (const [view, text, title] of looks) {
      const made = makeButton(text, title, () => actions.look(view));
      this.viewButtons.set(view, made);
      views.append(made);
    }
    const toggle = (text: string, key: keyof Shown): HTMLElement => {
      const label = make("label", "wide", text);
      const box = make("input");
      box.type = "checkbox";
      box.checked = shown[key];
      box.addEventListener("change", () => {
        shown[key] = box.checked;
        actions.redraw();
      });
      label.prepend(box);
      return label;
    };
    const withClass = (name: string, element: HTMLElement): HTMLElement => {
      element.classList.add(name);
      return element;
    };
    this.element.append(
      withClass("wide", makeButton("−1", "one tick back (←)", () => actions.step(-1))),
      this.playButton,
      withClass(isLive ? "tick" : "wide", makeButton("+1", "one tick forward (→)", () => actions.step(1))),
      this.speedBox,
      this.clock,
      makeButton("◂ catch", "the previous catch, from some seconds before it (p)", () => actions.nextCatch(-1)),
      makeButton("Next catch ▸", "from some seconds before it, both in the picture (n)", () => actions.nextCatch(1)),
      make("span", "space"),
      toggle("trails", "trails"),
      toggle("who perceives whom", "links"),
      views,
    );
    if (isLive) this.element.append(this.nowButton);
    this.nowButton.addEventListener("click", actions.toEnd);
    // A page that stands in another one has no address that leads there, nor does a live run.
    if (location.protocol !== "blob:" && !isLive) this.element.append(withClass("wide", makeButton("Copy link", "a link to this moment and robot", actions.copyLink)));
    this.element.append(withClass("narrow", makeButton("Details", "the robot, curves, phylogeny, events", actions.sheet)), makeButton("?", "keys and marks (?)", actions.help));
  }

  show(time: number, playing: boolean, speed: number): void {
    this.playing = playing;
    this.clock.textContent = `${time.toFixed(1)} s`;
    this.playButton.textContent = playing ? "Pause" : "Play";
    this.speedBox.value = String(speed);
  }

  /** Marks the view in use; null: none of them. */
  showView(view: View | null): void {
    for (const [name, button] of this.viewButtons) button.classList.toggle("on", name === view);
  }

  /** Whether a live run is shown as it is now. */
  showNow(isNow: boolean): void {
    this.nowButton.classList.toggle("on", isNow);
    this.nowButton.title = isNow ? "the page shows the present" : "to the present (End)";
  }

  /** Whether this page steers the run. */
  enable(isEnabled: boolean): void {
    this.playButton.disabled = !isEnabled;
    this.speedBox.disabled = !isEnabled;
  }

  isView(view: string | undefined): view is View {
    return looks.some(([name]) => name === view);
  }
}
