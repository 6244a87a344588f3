// SPDX-License-Identifier: MIT
// Opens the runs that the page carries, and shows them.
import uPlotStyle from "uplot/dist/uPlot.min.css";
import { App } from "./app";
import { make } from "./element";
import { listenToKeys } from "./keys";
import { connect, type Live } from "./live";
import { Run, type RunIndex } from "./run";
import style from "./style.css";

declare global {
  interface Window {
    trophic?: App;
    trophicError?: string;
  }
}

async function open(): Promise<void> {
  document.head.append(make("style", "", uPlotStyle + style));
  const index = JSON.parse(document.getElementById("trophic-index")!.textContent!) as { title: string; live?: boolean; runs: RunIndex[] };
  document.title = index.title;
  if (index.live) return follow();
  const opening = document.getElementById("opening");
  const pause = (): Promise<void> => new Promise((resume) => setTimeout(resume));
  const runs: Run[] = [];
  for (const [number, one] of index.runs.entries()) {
    if (opening) opening.textContent = `opening ${one.label}${index.runs.length > 1 ? ` (${number + 1} of ${index.runs.length})` : ""} …`;
    await pause();
    runs.push(await Run.open(one, number));
  }
  const app = show(runs);
  for (const run of runs) {
    await run.readTracks(async (part) => {
      if (run === app.run) app.side.plots.speed.progress(part);
      await pause();
    });
    if (run === app.run) app.showPlots();
  }
}

function show(runs: Run[], live: Live | null = null): App {
  const app = new App(runs, live);
  listenToKeys(app);
  window.trophic = app;
  return app;
}

/** Shows a live run. */
function follow(): void {
  let app: App | null = null;
  document.getElementById("opening")!.textContent = "waiting for the run …";
  connect({
    begun: (live) => {
      app?.stop();
      document.title = `${live.facts.label}, live`;
      app = show([live.run], live);
    },
    grown: () => app?.grown(),
    state: () => app?.showState(),
    said: (sentence) => {
      if (app) app.say(sentence);
      else document.getElementById("opening")!.textContent = sentence;
    },
  });
}

open().catch((error: unknown) => {
  window.trophicError = String(error);
  const message = make("p", "error", `This page cannot be shown: ${error instanceof Error ? error.message : String(error)}`);
  document.getElementById("app")!.replaceChildren(message);
  console.error(error);
});
