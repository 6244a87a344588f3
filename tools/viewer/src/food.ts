// SPDX-License-Identifier: MIT
// The food in the cells of the floor over time, and its colour: the lightness changes evenly from the floor's to that of the most.
import { Color } from "three";
import { firstAfter } from "./moments";
import { theme } from "./theme";

export class Food {
  /** Cells of a square grid, row by row from the corner of least x and y. */
  private readonly moments: { time: number; cells: ArrayLike<number> }[] = [];
  /** The most that a cell had, J. */
  most = 0;

  add(time: number, cells: ArrayLike<number>): void {
    this.moments.push({ time, cells });
    for (let i = 0; i < cells.length; ++i) this.most = Math.max(this.most, cells[i]);
  }

  /** Cells in a row. */
  get side(): number {
    return Math.round(Math.sqrt(this.moments[0].cells.length));
  }

  /** Writes the colours of all cells at a moment as red, green, blue and opacity. */
  paint(pixels: Uint8Array, time: number): void {
    const next = firstAfter(this.moments, time);
    const a = this.moments[Math.max(0, next - 1)];
    const b = this.moments[next] ?? a;
    const part = b.time > a.time ? Math.max(0, (time - a.time) / (b.time - a.time)) : 0;
    const [bare, rich] = [theme().floor, theme().food].map((colour) => new Color(colour).convertLinearToSRGB().toArray());
    for (let cell = 0; cell < a.cells.length; ++cell) {
      const share = this.most > 0 ? (a.cells[cell] + part * (b.cells[cell] - a.cells[cell])) / this.most : 0;
      for (let i = 0; i < 3; ++i) pixels[4 * cell + i] = 255 * (bare[i] + share * (rich[i] - bare[i]));
      pixels[4 * cell + 3] = 255;
    }
  }
}
