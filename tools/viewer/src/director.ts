// SPDX-License-Identifier: MIT
// Plays a scene, which the director of trophic's films made: the ecology's own speed up to the moment of the catch, which stands still for a
// while of the viewer's time.
import type { Scene } from "./run";

export interface Step {
  time: number;
  isOver: boolean;
}

/** One scene while it is played. */
export class Player {
  private held = 0;
  private readonly end: number;

  /** `last`: the end of the run. */
  constructor(readonly scene: Scene, last: number) {
    this.end = Math.min(last, scene.ends_s);
  }

  /** The moment after `passed` seconds of the viewer at a speed, from a moment. */
  advance(time: number, passed: number, speed: number): Step {
    const { time_s } = this.scene;
    if (time < time_s) return { time: Math.min(time_s, time + passed * speed), isOver: false };
    if (this.isHeld(time)) {
      this.held += passed;
      return { time, isOver: false };
    }
    const next = Math.min(this.end, time + passed * speed);
    return { time: next, isOver: next >= this.end };
  }

  /** Whether the moment of the catch is on show: both still live in their bodies. */
  isHeld(time: number): boolean {
    return time === this.scene.time_s && this.held < this.scene.still_s;
  }
}
