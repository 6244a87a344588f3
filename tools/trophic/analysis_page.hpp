// SPDX-License-Identifier: MIT
// An analysis as one page that any browser opens from disk: its table, figures, and the replays of its runs.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace trophic::command {

/// What such a page shows.
struct AnalysisPage {
  struct Figure {
    std::string name;
    std::string caption;  ///< stands in the picture, too
    std::string png;
  };
  struct Replay {
    std::string label;
    std::string part;  ///< of a page of `show`: see replay::runs_part
  };
  std::string title;
  std::vector<std::pair<std::string, std::string>> facts;  ///< (what, which): rules, engine, runs
  std::string table;                                       ///< as the terminal shows it
  std::vector<Figure> figures;
  std::vector<Replay> replays;
};

/// The page. Throws std::invalid_argument for replays in a program that was built without the viewer.
[[nodiscard]] std::string html_of(const AnalysisPage& what);

/// The pictures that a folder has for a page: every PNG that its captions.json names, in that order. Throws std::invalid_argument
/// for a folder without them.
[[nodiscard]] std::vector<AnalysisPage::Figure> read_figures(const std::filesystem::path& folder);

}  // namespace trophic::command
