// SPDX-License-Identifier: MIT
// Tables as columns. trophic writes plain cells; only lists of ancestors may stand in quotes.

export class Table {
  readonly names: string[];
  readonly rows: number;
  private readonly columns = new Map<string, string[]>();

  constructor(text: string) {
    const lines = text.split("\n");
    while (lines.length > 0 && lines[lines.length - 1] === "") lines.pop();
    this.names = (lines[0] ?? "").split(",");
    this.rows = Math.max(0, lines.length - 1);
    const cells: string[][] = this.names.map(() => new Array<string>(this.rows));
    for (let row = 0; row < this.rows; ++row) {
      const line = lines[row + 1];
      const values = line.includes('"') ? splitQuoted(line) : line.split(",");
      for (let column = 0; column < cells.length; ++column) cells[column][row] = values[column];
    }
    this.names.forEach((name, column) => this.columns.set(name, cells[column]));
  }

  has(name: string): boolean {
    return this.columns.has(name);
  }

  text(name: string): string[] {
    const column = this.columns.get(name);
    if (!column) throw new Error(`a table lacks the column ${name}`);
    return column;
  }

  /** Empty cells are NaN. */
  numbers(name: string): Float64Array {
    return Float64Array.from(this.text(name), (cell) => (cell === "" ? NaN : Number(cell)));
  }
}

function splitQuoted(line: string): string[] {
  const cells: string[] = [];
  for (const match of line.matchAll(/(?:^|,)(?:"([^"]*)"|([^,]*))/g)) cells.push(match[1] ?? match[2] ?? "");
  return cells;
}
