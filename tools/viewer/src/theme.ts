// SPDX-License-Identifier: MIT
// Colours of the page in light and in dark surroundings, as the browser prefers. style.css has the same for its elements.

export interface Theme {
  background: string;
  floor: string;
  foods: string[]; // of the floor where it has most of a food, by its place among the foods
  grid: string;
  wall: string;
  zone: string; // the edge of a named place on the floor
  shadow: string; // of a robot on the floor
  ink: string; // texts, the moment, the selection
  muted: string; // axes, counts
  faint: string; // lines of a grid
  change: string; // of a parameter
  lanes: [string, string];
}

const light: Theme = {
  background: "#f6f8f9", floor: "#dde3e8", foods: ["#9cc47f", "#c7a1db", "#edcc6b"], grid: "#cbd3da", wall: "#aab4be", zone: "#4a5968", shadow: "#bcc5cd", ink: "#111417", muted: "#5f6a76", faint: "#e3e8ec", change: "#8a2be2",
  lanes: ["#eef1f4", "#f6f8f9"],
};
const dark: Theme = {
  background: "#12171d", floor: "#2b343e", foods: ["#56733f", "#6d4d86", "#8a6f2c"], grid: "#3a4550", wall: "#5a6672", zone: "#a9b8c6", shadow: "#1c232b", ink: "#f2f5f7", muted: "#9aa6b2", faint: "#2a323b", change: "#c79bff",
  lanes: ["#1e252d", "#181e25"],
};

const preference = window.matchMedia("(prefers-color-scheme: dark)");

export function isDark(): boolean {
  return preference.matches;
}

/** The colours to draw with now. */
export function theme(): Theme {
  return isDark() ? dark : light;
}

/** Calls `work` when the browser prefers other colours. */
export function onThemeChange(work: () => void, signal: AbortSignal): void {
  preference.addEventListener("change", work, { signal });
}
