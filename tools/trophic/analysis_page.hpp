// SPDX-License-Identifier: MIT
// An analysis as one page that any browser opens from disk: question, findings, a table that can be sorted, figures, replays of
// its runs, rules, commands and tables to download.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace trophic::command {

/// Content of the page.
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
  /// A metric in words and its difference from a null, in the unit that people read.
  struct Row {
    std::string set;
    std::string metric;
    std::string ours;      ///< with its interval
    std::string baseline;  ///< name and value of the null; empty: there is none
    std::string difference;
    std::string conclusion;
    double mean = 0.0;  ///< what the table is sorted by
    std::optional<double> value;
    double lower = 0.0;  ///< of the difference's interval
    double upper = 0.0;
  };
  /// A file that the page carries.
  struct Download {
    std::string name;
    std::string content;
  };
  std::string title;
  std::string question = {};
  std::vector<std::string> findings = {};
  std::vector<std::pair<std::string, std::string>> facts;  ///< (what, which): rules, engine, runs
  std::vector<Row> rows = {};
  std::string table;                                            ///< as the terminal shows it
  std::vector<std::pair<std::string, std::string>> rules = {};  ///< (slot, policy)
  std::vector<std::string> commands = {};                       ///< that make it again
  std::vector<Download> downloads = {};
  std::vector<Figure> figures;
  std::vector<Replay> replays;
};

/// The page. Throws std::invalid_argument for replays in a program that was built without the viewer.
[[nodiscard]] std::string html_of(const AnalysisPage& what);

/// The pictures that a folder has for a page: every PNG that its captions.json names, in that order. Throws std::invalid_argument
/// for a folder without them.
[[nodiscard]] std::vector<AnalysisPage::Figure> read_figures(const std::filesystem::path& folder);

}  // namespace trophic::command
