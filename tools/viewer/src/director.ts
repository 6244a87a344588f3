// SPDX-License-Identifier: MIT
// A catch as one can see it: from some seconds before it, at the ecology's own speed, with both in the picture; the moment itself stands still
// for a second of the viewer's time.
import type { Event, Run } from "./run";

/** Ecology seconds before and after the catch. */
export const leadSeconds = 8;
export const tailSeconds = 4;
/** How long the moment itself is shown, seconds of the viewer. */
export const holdSeconds = 1.2;

export interface Step {
  time: number;
  isOver: boolean;
}

/** One catch while it is played. */
export class CatchScene {
  private held = 0;

  constructor(
    readonly event: Event,
    private readonly end: number,
  ) {}

  /** The moment after `passed` seconds of the viewer at a speed, from a moment. */
  advance(time: number, passed: number, speed: number): Step {
    const { event } = this;
    if (time < event.time) return { time: Math.min(event.time, time + passed * speed), isOver: false };
    if (this.isHeld(time)) {
      this.held += passed;
      return { time, isOver: false };
    }
    const next = Math.min(this.end, time + passed * speed);
    return { time: next, isOver: next >= Math.min(this.end, event.time + tailSeconds) };
  }

  /** Whether the moment of the catch is on show: both still live in their bodies. */
  isHeld(time: number): boolean {
    return time === this.event.time && this.held < holdSeconds;
  }
}

export function catchesOf(run: Run): Event[] {
  return run.events.filter((event) => event.kind === "catch" && event.time >= run.firstTime && event.time <= run.lastTime);
}

/** The catch that a page opens at: the first by an inherited hunter, with time to see both approach; else the first. */
export function firstToShow(run: Run): Event | undefined {
  const catches = catchesOf(run).filter((event) => event.time >= run.firstTime + leadSeconds);
  return catches.find((event) => run.individuals.get(event.id)?.origin === "inherited") ?? catches[0];
}
