// SPDX-License-Identifier: MIT
// A run's place in the page: its world and its caption.
import { make } from "./element";
import type { Run } from "./run";
import { World } from "./world";

export interface FrameActions {
  pick: (body: number) => void; // -1: none
  redraw: () => void;
  press: () => void;
}

/** Without a world where the browser has no WebGL: the frame then says so. */
export function makeFrame(run: Run, actions: FrameActions): { frame: HTMLElement; world: World | null } {
  const frame = make("figure", "view");
  const { head } = run.recording;
  const caption = make("figcaption");
  caption.append(make("b", "", run.index.label), " ", make("span", "rules", run.index.name ?? head.rule_table), `, ${head.backend}, seed ${head.seed}`);
  if (run.index.shadow) caption.append(make("em", "", " neutral shadow"));
  if (run.index.status !== "complete") caption.append(make("em", "", ` ${run.index.status}`));
  frame.addEventListener("pointerdown", actions.press);
  try {
    const world = new World(run, actions.pick, actions.redraw);
    frame.append(world.canvas, world.labels.element, caption);
    return { frame, world };
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error);
    frame.append(make("p", "error", `This browser cannot draw the world (WebGL: ${why}). Curves, phylogeny and events are shown.`), caption);
    return { frame, world: null };
  }
}
