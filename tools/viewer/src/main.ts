// SPDX-License-Identifier: MIT
// Opens the runs that the page carries, and shows them.
import uPlotStyle from "uplot/dist/uPlot.min.css";
import { App } from "./app";
import { make } from "./element";
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
  const index = JSON.parse(document.getElementById("trophic-index")!.textContent!) as { title: string; runs: RunIndex[] };
  document.title = index.title;
  const opening = document.getElementById("opening");
  const pause = (): Promise<void> => new Promise((resume) => setTimeout(resume));
  const runs: Run[] = [];
  for (const [number, one] of index.runs.entries()) {
    if (opening) opening.textContent = `opening ${one.label}${index.runs.length > 1 ? ` (${number + 1} of ${index.runs.length})` : ""} …`;
    await pause();
    runs.push(await Run.open(one, number));
  }
  const app = new App(runs);
  window.trophic = app;
  for (const run of runs) {
    await run.readTracks(async (part) => {
      if (run === app.run) app.side.plots.speed.progress(part);
      await pause();
    });
    if (run === app.run) app.showPlots();
  }
}

open().catch((error: unknown) => {
  window.trophicError = String(error);
  const message = make("p", "error", `This page cannot be shown: ${error instanceof Error ? error.message : String(error)}`);
  document.getElementById("app")!.replaceChildren(message);
  console.error(error);
});
