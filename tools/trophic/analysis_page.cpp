// SPDX-License-Identifier: MIT
// Definitions of analysis_page.hpp.
#include <tools/trophic/analysis_page.hpp>

#include <cstddef>
#include <stdexcept>
#include <string_view>
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
body { font: 15px/1.45 system-ui, sans-serif; color: #1b2430; max-width: 76rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin-top: 2.2rem; border-bottom: 1px solid #ccd2d9; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 0.15rem 1rem; } dt { color: #5b6673; } dd { margin: 0; }
pre { font: 12.5px/1.4 ui-monospace, monospace; overflow-x: auto; background: #f5f7f9; padding: 0.8rem; }
.figures { columns: 22rem; column-gap: 1.2rem; } figure { break-inside: avoid; margin: 0 0 1.2rem; }
figure.wide { column-span: all; } figcaption { font-size: 12.5px; color: #5b6673; } img { max-width: 100%; }
.replays button { font: inherit; margin: 0 0.4rem 0.4rem 0; padding: 0.25rem 0.7rem; border: 1px solid #8d98a5; border-radius: 4px; background: #fff; }
.replays button[aria-pressed="true"] { background: #1b2430; color: #fff; }
iframe { width: 100%; height: min(92vh, 56rem); border: 1px solid #ccd2d9; display: none; }
</style>
)";

/// The viewer is carried once; a replay is a frame of its own that is made when it is asked for.
constexpr std::string_view script = R"(<script>
"use strict";
const decoded = (id) => new TextDecoder().decode(Uint8Array.from(atob(document.getElementById(id).textContent.trim()), (c) => c.charCodeAt(0)));
const buttons = [...document.querySelectorAll(".replays button")];
let address = "";
for (const button of buttons) {
  button.addEventListener("click", () => {
    const part = document.querySelector(`template[data-replay="${button.dataset.replay}"]`).innerHTML;
    const page = decoded("viewer").replace("<!--RUNS-->", () => part);
    if (address) URL.revokeObjectURL(address);
    address = URL.createObjectURL(new Blob([page], { type: "text/html" }));
    const frame = document.querySelector("iframe");
    frame.style.display = "block";
    frame.src = address;
    for (const other of buttons) other.setAttribute("aria-pressed", String(other === button));
  });
}
</script>
)";

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
  page.append("<h2>Replays</h2>\n<p class=\"replays\">\n");
  for (std::size_t i = 0; i < replays.size(); ++i) {
    page.append("<button data-replay=\"").append(std::to_string(i)).append("\" aria-pressed=\"false\">");
    page.append(escaped(replays[i].label)).append("</button>\n");
  }
  page.append("</p>\n<iframe title=\"replay\"></iframe>\n<script type=\"text/plain\" id=\"viewer\">");
  page.append(replay::base64(replay::viewer_page())).append("</script>\n");
  for (std::size_t i = 0; i < replays.size(); ++i) {
    page.append("<template data-replay=\"")
        .append(std::to_string(i))
        .append("\">")
        .append(replays[i].part)
        .append("</template>\n");
  }
  page.append(script);
}

}  // namespace

std::string html_of(const AnalysisPage& what) {
  std::string page{head};
  page.append("<title>").append(escaped(what.title)).append("</title>\n</head>\n<body>\n<h1>").append(escaped(what.title));
  page.append("</h1>\n<dl>\n");
  for (const auto& [name, text] : what.facts) {
    page.append("<dt>").append(escaped(name)).append("</dt><dd>").append(escaped(text)).append("</dd>\n");
  }
  page.append("</dl>\n<h2>Results</h2>\n<pre>").append(escaped(what.table)).append("</pre>\n");
  append_figures(page, what.figures);
  append_replays(page, what.replays);
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
