// SPDX-License-Identifier: MIT
// Makes built/viewer.html: the page with its code and style inside, and one line where `trophic show` puts the runs. The built page
// is kept in page/.
import { build } from "esbuild";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const { outputFiles } = await build({
  entryPoints: [join(here, "src/main.ts")],
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  legalComments: "none",
  loader: { ".css": "text" },
  write: false,
});
// A script inside a page must not contain the end of a script.
const code = outputFiles[0].text.replaceAll("</script", "<\\/script");
const licences = await Promise.all(
  ["three", "uplot", "d3-hierarchy"].map(async (name) => {
    const text = await readFile(join(here, "node_modules", name, "LICENSE"), "utf8");
    return `${name}\n${text.trim()}`;
  }),
);
const page = (await readFile(join(here, "src/page.html"), "utf8"))
  .replace("@LICENCES@", () => licences.join("\n\n").replaceAll("--", "- -"))
  .replace("@CODE@", () => code);
if (page.split("<!--RUNS-->").length !== 2) throw new Error("the page needs exactly one line <!--RUNS-->");
await mkdir(join(here, "built"), { recursive: true });
await writeFile(join(here, "built/viewer.html"), page);
console.log(`built/viewer.html: ${(page.length / 1024).toFixed(0)} KB`);
