// SPDX-License-Identifier: MIT
// Makes built/viewer.html: the page with its code and style, and one line that `trophic show` replaces by the runs. Also makes
// built/viewer_page.cpp, the same page for programs to link with.
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
const octal = (byte) => `\\${byte.toString(8).padStart(3, "0")}`;
const escaped = (bytes) => [...bytes].map((b) => (b < 32 || b > 126 || b === 34 || b === 92 || b === 63 ? octal(b) : String.fromCharCode(b))).join("");
const bytes = Buffer.from(page, "utf8");
const lines = [];
for (let at = 0; at < bytes.length; at += 8192) lines.push(`    "${escaped(bytes.subarray(at, at + 8192))}"`);
await writeFile(
  join(here, "built/viewer_page.cpp"),
  `// Made by tools/viewer/build.mjs.
extern "C" {
extern const char trophic_viewer_page[];
extern const unsigned long trophic_viewer_page_size;
const char trophic_viewer_page[] =
${lines.join("\n")};
const unsigned long trophic_viewer_page_size = sizeof(trophic_viewer_page) - 1;
}
`,
);
console.log(`built/viewer.html: ${(page.length / 1024).toFixed(0)} KB`);
