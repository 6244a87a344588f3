// SPDX-License-Identifier: MIT
// The moment as a link: #t=1234&robot=17&run=2.

export interface Moment {
  time?: number;
  robot?: number;
  run?: number;
  view?: string;
}

export function readLink(hash: string): Moment {
  const words = new URLSearchParams(hash.replace(/^#/, ""));
  const number = (name: string): number | undefined => {
    const text = words.get(name);
    const value = Number(text);
    return text === null || text === "" || Number.isNaN(value) ? undefined : value;
  };
  return { time: number("t"), robot: number("robot"), run: number("run"), view: words.get("view") ?? undefined };
}

export function writeLink(moment: Moment): string {
  const words = [`t=${Number((moment.time ?? 0).toFixed(2))}`];
  if (moment.robot !== undefined) words.push(`robot=${moment.robot}`);
  if (moment.run !== undefined) words.push(`run=${moment.run}`);
  if (moment.view !== undefined && moment.view !== "orbit") words.push(`view=${moment.view}`);
  return `#${words.join("&")}`;
}
