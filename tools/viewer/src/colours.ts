// SPDX-License-Identifier: MIT
// Colours that any colour vision distinguishes (Okabe and Ito), one for each species, and those of marks. In dark surroundings the
// dark ones are lighter.
import { isDark } from "./theme";

const onLight = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7a5c00"];
const onDark = ["#389fe0", "#f5822a", "#2cc79b", "#dd95bc", "#f0b429", "#9ad6f7", "#b99a3c"];
export const inactiveColour = "#9aa1a9";
export const branchColour = "#e8b400";
export const catchColour = "#c2002f";

export function colourOf(species: number): string {
  const colours = isDark() ? onDark : onLight;
  return colours[((species % colours.length) + colours.length) % colours.length];
}

/** With an opacity, for canvases. */
export function faded(colour: string, opacity: number): string {
  return colour + Math.round(255 * opacity).toString(16).padStart(2, "0");
}
