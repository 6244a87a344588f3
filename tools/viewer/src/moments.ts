// SPDX-License-Identifier: MIT
// Search in what is ordered by time.
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
