// SPDX-License-Identifier: MIT
// Colours that people with any colour vision can distinguish (Okabe and Ito), one for each species.

export const speciesColours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7a5c00"];
export const inactiveColour = "#9aa1a9";
export const inkColour = "#1d2733";
export const selectedColour = "#111111";

export function colourOf(species: number): string {
  return speciesColours[((species % speciesColours.length) + speciesColours.length) % speciesColours.length];
}

/** With an opacity, for canvases. */
export function faded(colour: string, opacity: number): string {
  return colour + Math.round(255 * opacity).toString(16).padStart(2, "0");
}
