// SPDX-License-Identifier: MIT
// The foods in the cells of the floor over time, and the floor's colour: each food filters its light, the more the more there is.
import { Color } from "three";
import { firstAfter } from "./moments";
import { theme } from "./theme";

export class Food {
  /** Cells of a square grid, row by row from the corner of least x and y. */
  private readonly moments: { time: number; cells: ArrayLike<number> }[] = [];
  /** The most that a cell had, J. */
  most = 0;

  constructor(readonly name: string) {}

  add(time: number, cells: ArrayLike<number>): void {
    this.moments.push({ time, cells });
    for (let i = 0; i < cells.length; ++i) this.most = Math.max(this.most, cells[i]);
  }

  /** Cells in a row. */
  get side(): number {
    return Math.round(Math.sqrt(this.moments[0].cells.length));
  }

  /** The food of a cell at a moment, as a part of the most. */
  at(time: number): (cell: number) => number {
    const next = firstAfter(this.moments, time);
    const a = this.moments[Math.max(0, next - 1)];
    const b = this.moments[next] ?? a;
    const part = b.time > a.time ? Math.max(0, (time - a.time) / (b.time - a.time)) : 0;
    return (cell) => (this.most > 0 ? (a.cells[cell] + part * (b.cells[cell] - a.cells[cell])) / this.most : 0);
  }
}

/** The colour of a floor with the most of a food, by its place among the foods. */
export function foodColour(place: number): string {
  const colours = theme().foods;
  return colours[place % colours.length];
}

/** Writes the floor's colours at a moment, `side` x `side` of red, green, blue and opacity. */
export function paintFoods(foods: Food[], side: number, pixels: Uint8Array, time: number): void {
  const [bare, ...rich] = [theme().floor, ...foods.map((_, place) => foodColour(place))].map((colour) => new Color(colour).convertLinearToSRGB().toArray());
  const shares = foods.map((food) => food.at(time));
  const sides = foods.map((food) => food.side);
  for (let pixel = 0; pixel < side * side; ++pixel) {
    const [x, y] = [pixel % side, Math.floor(pixel / side)];
    const here = shares.map((share, place) => share(Math.floor((y * sides[place]) / side) * sides[place] + Math.floor((x * sides[place]) / side)));
    for (let i = 0; i < 3; ++i) {
      const light = here.reduce((left, share, place) => left * (1 + share * (rich[place][i] / bare[i] - 1)), bare[i]);
      pixels[4 * pixel + i] = 255 * Math.min(1, light);
    }
    pixels[4 * pixel + 3] = 255;
  }
}
