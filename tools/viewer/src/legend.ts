// SPDX-License-Identifier: MIT
// Names every colour and mark of a run's world.
import { branchColour, catchColour, colourOf } from "./colours";
import { make } from "./element";
import { foodColour } from "./food";
import type { Run } from "./run";
import { theme } from "./theme";

const tagName = (tag: number): string => `tag ${tag > 0 ? "+" : ""}${tag}`;

function sign(kind: string, text: string, colour = ""): HTMLElement {
  const item = make("li", "", text);
  const mark = make("i", kind);
  if (colour) mark.style.setProperty("--mark", colour);
  item.prepend(mark);
  return item;
}

/** The list's items, counting who lives at a moment: `counts` has a number a species. */
export function legendOf(run: Run): { items: HTMLElement[]; counts: HTMLElement[] } {
  const counts: HTMLElement[] = [];
  const { species, tags } = run.index;
  const items = species.map((name, number) => {
    const item = sign("species", name, colourOf(number));
    const count = make("b", "count");
    counts.push(count);
    item.append(" ", count);
    return item;
  });
  if (run.hasTags) items.push(sign("filled", tagName(Math.max(...tags))), sign("hollow", tags.length === 2 ? tagName(Math.min(...tags)) : "other tags"));
  if (run.fills("activation")) items.push(sign("grey", "not yet active"));
  if (run.fills("capture")) items.push(sign("caught", "caught", catchColour));
  if (run.fills("starvation", "metabolism", "senescence", "minimum_predators")) items.push(sign("dead", "other death"));
  if (run.fills("activation")) items.push(sign("awake", "becomes active", colourOf(0)));
  items.push(
    sign("selected", "selected"),
    sign("branch", "its branch", branchColour),
    sign("trail", "trail", colourOf(0)),
    sign("link", "perceives", colourOf(species.length > 1 ? 1 : 0)),
  );
  for (const name of new Set(run.recording.head.arena.zones?.map((zone) => zone.name))) items.push(sign("zone", name, theme().zone));
  for (const [place, { name, most }] of run.foods.entries()) items.push(sign("food", `${name}, up to ${Number(most.toPrecision(3))} J a cell`, foodColour(place)));
  return { items, counts };
}
