// SPDX-License-Identifier: MIT
// Definitions of analysis_page.hpp.
#include <tools/trophic/analysis_page.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <tools/trophic/replay/base64.hpp>
#include <tools/trophic/replay/page.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::command {

namespace {

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '&':
        safe += "&amp;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

constexpr std::string_view head = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:; frame-src blob:">
<link rel="icon" href="data:,">
<style>
:root { color-scheme: light dark; --page: #fff; --ink: #1b2430; --soft: #5b6673; --line: #ccd2d9; --faint: #f3f5f7; --up: #0072b2; --down: #d55e00; --strong: #1b2430; --on-strong: #fff; --link: #0b5cad; }
@media (prefers-color-scheme: dark) { :root { --page: #161b21; --ink: #e8ecf0; --soft: #9aa6b2; --line: #36414c; --faint: #1f262e; --up: #389fe0; --down: #f5822a; --strong: #e8ecf0; --on-strong: #161b21; --link: #7db8f0; } }
* { box-sizing: border-box; }
body { font: 15px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--page); max-width: 76rem; margin: 1.5rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; margin: 0 0 0.2rem; } h2 { font-size: 1.15rem; margin-top: 2.2rem; border-bottom: 1px solid var(--line); }
.question { font-size: 1.1rem; color: var(--soft); margin: 0 0 1rem; max-width: 50rem; }
.findings { font-size: 1.05rem; padding: 0.8rem 1.2rem 0.8rem 2.2rem; background: var(--faint); border-radius: 8px; max-width: 60rem; } .findings li { margin: 0.3rem 0; }
dl { display: grid; grid-template-columns: minmax(7rem, max-content) 1fr; gap: 0.15rem 1rem; overflow-wrap: anywhere; } dt { color: var(--soft); } dd { margin: 0; }
.scroll { overflow-x: auto; } table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; font-size: 0.92rem; }
th, td { text-align: left; padding: 0.25rem 0.7rem 0.25rem 0; border-bottom: 1px solid var(--line); vertical-align: top; } td { white-space: nowrap; } td:first-child { white-space: normal; min-width: 10rem; }
th button { font: inherit; font-weight: 600; color: inherit; border: none; background: none; padding: 0; cursor: pointer; text-align: left; } th[aria-sort="ascending"] button::after { content: " \25b2"; } th[aria-sort="descending"] button::after { content: " \25bc"; }
svg.bar { width: 9rem; height: 1rem; display: block; } .bar .axis { stroke: var(--soft); } .bar .range { stroke-width: 4; } .bar .dot { stroke: none; }
.above { stroke: var(--up); fill: var(--up); } .below { stroke: var(--down); fill: var(--down); } .neither { stroke: var(--soft); fill: var(--soft); }
pre { font: 12.5px/1.4 ui-monospace, monospace; overflow-x: auto; background: var(--faint); padding: 0.8rem; border-radius: 6px; } summary { cursor: pointer; color: var(--soft); margin: 0.8rem 0; }
.figures { columns: 22rem; column-gap: 1.2rem; } figure { break-inside: avoid; margin: 0 0 1.2rem; }
figure.wide { column-span: all; } figcaption { font-size: 12.5px; color: var(--soft); } img { max-width: 100%; background: #fff; }
.replays button, .downloads a { font: inherit; color: inherit; display: inline-block; margin: 0 0.4rem 0.4rem 0; padding: 0.25rem 0.7rem; border: 1px solid var(--line); border-radius: 4px; background: var(--faint); text-decoration: none; cursor: pointer; }
.replays button[aria-pressed="true"] { background: var(--strong); color: var(--on-strong); }
iframe { width: 100%; height: min(92vh, 56rem); border: 1px solid var(--line); border-radius: 6px; background: var(--faint); }
@media (max-width: 40rem) { body { margin: 0.8rem auto; } h1 { font-size: 1.3rem; } dl { grid-template-columns: 1fr; } dd { margin-bottom: 0.4rem; } .figures { columns: 1; } .findings { padding-right: 0.8rem; } iframe { height: 80vh; } }
</style>
)";

/// The viewer is carried once; a replay is a frame of its own that is made when it is asked for, the first when it comes into
/// view.
constexpr std::string_view replay_script = R"(<script>
"use strict";
{
  const decoded = (id) => new TextDecoder().decode(Uint8Array.from(atob(document.getElementById(id).textContent.trim()), (c) => c.charCodeAt(0)));
  const buttons = [...document.querySelectorAll(".replays button")];
  const frame = document.querySelector("iframe");
  let address = "";
  const play = (button) => {
    const part = document.querySelector(`template[data-replay="${button.dataset.replay}"]`).innerHTML;
    const page = decoded("viewer").replace("<!--RUNS-->", () => part);
    if (address) URL.revokeObjectURL(address);
    address = URL.createObjectURL(new Blob([page], { type: "text/html" }));
    frame.src = address;
    for (const other of buttons) other.setAttribute("aria-pressed", String(other === button));
  };
  for (const button of buttons) {
    button.addEventListener("click", () => {
      play(button);
      frame.scrollIntoView({ behavior: "smooth", block: "nearest" });
    });
  }
  const first = new IntersectionObserver((seen) => {
    if (!seen.some((one) => one.isIntersecting)) return;
    first.disconnect();
    if (!address) play(buttons[0]);
  });
  first.observe(frame);
}
</script>
)";

constexpr std::string_view table_script = R"(<script>
"use strict";
for (const [column, head] of document.querySelectorAll(".results th").entries()) {
  head.firstElementChild.addEventListener("click", () => {
    const rises = head.getAttribute("aria-sort") !== "ascending";
    for (const other of document.querySelectorAll(".results th")) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", rises ? "ascending" : "descending");
    const body = document.querySelector(".results tbody");
    const key = (row) => row.cells[column].dataset.key ?? row.cells[column].textContent;
    const order = (a, b) => {
      const [x, y] = [key(a), key(b)];
      if ((x === "") !== (y === "")) return x === "" ? 1 : -1;
      return (rises ? 1 : -1) * (x !== "" && !Number.isNaN(Number(x)) ? Number(x) - Number(y) : x.localeCompare(y));
    };
    body.append(...[...body.rows].sort(order));
  });
}
</script>
)";

std::string digits(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

/// A difference with its interval, and zero, as a bar.
std::string bar_of(const AnalysisPage::Row& row) {
  if (!row.value) return "";
  const double most = std::max({std::abs(row.lower), std::abs(row.upper), 1e-300});
  const auto x = [&](double value) { return digits(70.0 + 64.0 * value / most); };
  const char* side = row.conclusion == "above" ? "above" : row.conclusion == "below" ? "below" : "neither";
  return "<svg class=\"bar\" viewBox=\"0 0 140 16\" aria-hidden=\"true\"><line class=\"axis\" x1=\"70\" x2=\"70\" y1=\"0\" "
         "y2=\"16\"/><line class=\"range " +
         std::string{side} + "\" x1=\"" + x(row.lower) + "\" x2=\"" + x(row.upper) +
         "\" y1=\"8\" y2=\"8\"/><circle class=\"dot " + side + "\" cx=\"" + x(*row.value) + "\" cy=\"8\" r=\"5\"/></svg>";
}

void append_rows(std::string& page, const AnalysisPage& what) {
  page.append("<h2>Results</h2>\n");
  if (!what.rows.empty()) {
    const bool has_sets = std::ranges::any_of(what.rows, [&](const auto& row) { return row.set != what.rows.front().set; });
    page.append(
        "<p>Each metric as mean over runs with its 95 % interval, and its difference from a null: from its lower to its upper "
        "bound, scaled to the line's width. A click on a heading sorts.</p>\n<div class=\"scroll\"><table "
        "class=\"results\"><thead><tr>");
    for (const char* heading : {"set", "metric", "ours [95 %]", "null", "ours - null [95 %]", "", "conclusion"}) {
      if (std::string_view{heading} == "set" && !has_sets) continue;
      page.append("<th scope=\"col\"><button type=\"button\">").append(heading).append("</button></th>");
    }
    page.append("</tr></thead><tbody>\n");
    const auto cell = [&](const std::string& text, const std::string& key = {}) {
      page.append("<td").append(key.empty() ? "" : " data-key=\"" + key + "\"").append(">").append(escaped(text)).append("</td>");
    };
    for (const AnalysisPage::Row& row : what.rows) {
      page.append("<tr>");
      if (has_sets) cell(row.set);
      cell(row.metric);
      cell(row.ours, digits(row.mean));
      cell(row.baseline);
      cell(row.difference, row.value ? digits(*row.value) : "");
      page.append("<td>").append(bar_of(row)).append("</td>");
      cell(row.conclusion);
      page.append("</tr>\n");
    }
    page.append("</tbody></table></div>\n").append(table_script);
  }
  page.append("<details><summary>The table as the terminal prints it</summary>\n<pre>").append(escaped(what.table));
  page.append("</pre></details>\n");
}

void append_rules(std::string& page, const AnalysisPage& what) {
  if (!what.rules.empty()) {
    page.append("<h2>Rules</h2>\n<dl class=\"rules\">\n");
    for (const auto& [slot, policy] : what.rules) {
      page.append("<dt>").append(escaped(slot)).append("</dt><dd>").append(escaped(policy)).append("</dd>\n");
    }
    page.append("</dl>\n");
  }
  if (!what.commands.empty()) {
    page.append("<h2>To make it again</h2>\n<pre class=\"commands\">");
    for (const std::string& command : what.commands) page.append(escaped(command)).append("\n");
    page.append("</pre>\n");
  }
  if (what.downloads.empty()) return;
  page.append("<h2>Data</h2>\n<p class=\"downloads\">");
  for (const AnalysisPage::Download& file : what.downloads) {
    page.append("<a download=\"").append(escaped(file.name)).append("\" href=\"data:text/csv;base64,");
    page.append(replay::base64(file.content)).append("\">").append(escaped(file.name)).append("</a>\n");
  }
  page.append("</p>\n");
}

void append_figures(std::string& page, const std::vector<AnalysisPage::Figure>& figures) {
  if (figures.empty()) return;
  page.append("<h2>Figures</h2>\n<div class=\"figures\">\n");
  for (const AnalysisPage::Figure& figure : figures) {
    page.append(figure.name.ends_with("film_strip") ? "<figure class=\"wide\">" : "<figure>");
    page.append("<img alt=\"").append(escaped(figure.name + ": " + figure.caption)).append("\" src=\"data:image/png;base64,");
    page.append(replay::base64(figure.png))
        .append("\"><figcaption>")
        .append(escaped(figure.caption))
        .append("</figcaption></figure>\n");
  }
  page.append("</div>\n");
}

void append_replays(std::string& page, const std::vector<AnalysisPage::Replay>& replays) {
  if (replays.empty()) return;
  page.append("<h2>Replay</h2>\n<p class=\"replays\">\n");
  for (std::size_t i = 0; i < replays.size(); ++i) {
    page.append("<button data-replay=\"").append(std::to_string(i)).append("\" aria-pressed=\"false\">");
    page.append(escaped(replays[i].label)).append("</button>\n");
  }
  page.append("</p>\n<iframe title=\"replay\" allow=\"fullscreen\"></iframe>\n<script type=\"text/plain\" id=\"viewer\">");
  page.append(replay::base64(replay::viewer_page())).append("</script>\n");
  for (std::size_t i = 0; i < replays.size(); ++i) {
    page.append("<template data-replay=\"")
        .append(std::to_string(i))
        .append("\">")
        .append(replays[i].part)
        .append("</template>\n");
  }
  page.append(replay_script);
}

}  // namespace

std::string html_of(const AnalysisPage& what) {
  std::string page{head};
  page.append("<title>").append(escaped(what.title)).append("</title>\n</head>\n<body>\n<h1>").append(escaped(what.title));
  page.append("</h1>\n");
  if (!what.question.empty()) page.append("<p class=\"question\">").append(escaped(what.question)).append("</p>\n");
  if (!what.findings.empty()) {
    page.append("<ul class=\"findings\">\n");
    for (const std::string& finding : what.findings) page.append("<li>").append(escaped(finding)).append("</li>\n");
    page.append("</ul>\n");
  }
  page.append("<dl>\n");
  for (const auto& [name, text] : what.facts) {
    page.append("<dt>").append(escaped(name)).append("</dt><dd>").append(escaped(text)).append("</dd>\n");
  }
  page.append("</dl>\n");
  append_replays(page, what.replays);
  append_rows(page, what);
  append_figures(page, what.figures);
  append_rules(page, what);
  return page.append("</body>\n</html>\n");
}

std::vector<AnalysisPage::Figure> read_figures(const std::filesystem::path& folder) {
  const auto captions = parse_json_or_null(read_whole_file(folder / "captions.json"));
  if (!captions.is_object()) throw std::invalid_argument{(folder / "captions.json").string() + ": is not a JSON object"};
  std::vector<AnalysisPage::Figure> figures;
  for (const auto& [name, caption] : captions.items()) {
    if (!caption.is_string() || std::filesystem::path{name}.has_parent_path()) {
      throw std::invalid_argument{(folder / "captions.json").string() + ": \"" + name +
                                  "\": must be the name of a figure, and its caption a text"};
    }
    figures.push_back({.name = name, .caption = caption.get<std::string>(), .png = read_whole_file(folder / (name + ".png"))});
    if (!figures.back().png.starts_with("\x89PNG"))
      throw std::invalid_argument{(folder / (name + ".png")).string() + ": is not a PNG"};
  }
  return figures;
}

}  // namespace trophic::command
