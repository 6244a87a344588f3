// SPDX-License-Identifier: MIT
// Values and events in the order of time.

/** Curves by species, one value a point of time. */
export interface Curves {
  time: number[];
  bySpecies: (number | null)[][]; // null: nothing is known
  /** The bounds of each species' band, if there is one. */
  bands?: { low: (number | null)[]; high: (number | null)[] }[];
}

/** The first event later than a moment. */
export function firstAfter(events: readonly { time: number }[], time: number): number {
  let low = 0;
  let high = events.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (events[middle].time <= time) low = middle + 1;
    else high = middle;
  }
  return low;
}
