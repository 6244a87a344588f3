// SPDX-License-Identifier: MIT
// Keys, in the order in which the help lists them.
import type { App } from "./app";
import type { Key } from "./help";

function keysOf(app: App): Key[] {
  return [
    { keys: [" "], name: "space", meaning: "play or pause", work: () => app.play(!app.playing) },
    { keys: ["ArrowLeft"], name: "←", meaning: "one tick back", work: () => app.step(-1) },
    { keys: ["ArrowRight"], name: "→", meaning: "one tick forward", work: () => app.step(1) },
    { keys: ["ArrowUp", "+"], name: "↑, +", meaning: "faster", work: () => app.faster(1) },
    { keys: ["ArrowDown", "-"], name: "↓, −", meaning: "slower", work: () => app.faster(-1) },
    { keys: ["Home"], name: "Home", meaning: "to the start", work: () => app.seek(app.firstTime) },
    { keys: ["End"], name: "End", meaning: app.live ? "to the present" : "to the end", work: () => app.toEnd() },
    { keys: ["n"], name: "n", meaning: "the next catch, from some seconds before it", work: () => app.nextCatch(1) },
    { keys: ["p"], name: "p", meaning: "the previous catch", work: () => app.nextCatch(-1) },
    { keys: ["o"], name: "o", meaning: "turn, zoom and move freely", work: () => app.look("orbit") },
    { keys: ["t"], name: "t", meaning: "from above", work: () => app.look("top") },
    { keys: ["f"], name: "f", meaning: "follow the selected robot", work: () => app.look("follow") },
    { keys: ["e"], name: "e", meaning: "the list of events", work: () => app.openTab("events") },
    {
      keys: ["/"],
      name: "/",
      meaning: "search the list of events",
      work: () => {
        app.openTab("events");
        app.side.events.search.focus();
      },
    },
    { keys: ["Escape"], name: "Esc", meaning: "close, end the scene, clear the selection", work: () => app.leave() },
    { keys: ["?"], name: "?", meaning: "this help", work: () => app.help.toggle() },
  ];
}

/** Lists the keys in the help of an app, and calls the work of a pressed one, unless a text is typed. */
export function listenToKeys(app: App): void {
  const { help, signal } = app;
  const keys = keysOf(app);
  help.show(keys);
  window.addEventListener("keydown", (e) => {
    const isText = e.target instanceof HTMLSelectElement || (e.target instanceof HTMLInputElement && ["search", "number", "range"].includes(e.target.type) && e.key !== "Escape");
    if (isText || e.ctrlKey || e.metaKey || e.altKey || (help.element.open && e.key !== "?")) return;
    const key = keys.find((one) => one.keys.includes(e.key));
    if (!key) return;
    e.preventDefault();
    key.work();
  }, { signal });
}
