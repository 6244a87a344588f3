// SPDX-License-Identifier: MIT
// `trophic show`: runs as one page that any browser opens from disk.
#include "commands.hpp"

#include <memory>
#include <tools/command/option.hpp>
#include <tools/command/output.hpp>
#include <tools/reading/run_folders.hpp>
#include <tools/trophic/replay/page.hpp>
#include <tools/trophic/replay/recorded_run.hpp>
#include <trophic/support/new_file.hpp>

namespace trophic::command {

namespace detail::show {

/// More worlds than that are too small to be seen side by side, and too much for a browser.
inline constexpr std::size_t most_runs = 9;

struct Options {
  std::vector<std::string> runs;
  std::string out;
  replay::Window window;
};

[[nodiscard]] std::vector<std::filesystem::path> folders_of(const Options& options) {
  std::vector<std::filesystem::path> folders;
  for (const std::string& name : options.runs) {
    std::vector<std::string> remarks;
    for (const auto& folder : analysis::run_folders(name, remarks)) {
      if (folder == name && !std::filesystem::exists(folder / "manifest.json"))
        throw std::invalid_argument{replay::runs_in(folder)};
      folders.push_back(folder);
    }
    for (const std::string& remark : remarks) std::cerr << "trophic show: " << remark << "\n";
  }
  if (folders.empty()) throw std::invalid_argument{"runs: no runs found"};
  if (folders.size() > most_runs) {
    throw std::invalid_argument{std::to_string(folders.size()) + " runs: must be <= " + std::to_string(most_runs) +
                                " in one page; choose some, such as " + folders.front().string()};
  }
  return folders;
}

[[nodiscard]] int run(Options options) {
  if (options.out.empty()) options.out = free_name(options.runs.front(), ".html");
  if (const auto ending = std::filesystem::path{options.out}.extension(); ending != ".html" && ending != ".htm") {
    throw std::invalid_argument{"--out " + options.out + ": must end in .html or .htm"};
  }
  check_new_file("--out", options.out);
  const auto folders = folders_of(options);
  static_cast<void>(replay::viewer_page());
  std::vector<replay::RecordedRun> runs;
  for (const auto& folder : folders) {
    runs.push_back(replay::open_run(folder));
    options.window.check(runs.back().recording);
    for (const std::string& remark : runs.back().remarks) std::cerr << "trophic show: " << remark << "\n";
  }
  const std::string page = replay::page_of(runs, options.window);
  write_new_file(options.out, page);
  std::cout << shown(options.out) << ": " << megabytes_text(page.size()) << ", opens in any browser and needs no server\n";
  flush_output();
  return 0;
}

}  // namespace detail::show

/// Makes a page of recorded runs.
Command show() {
  const auto options = std::make_shared<detail::show::Options>();
  return {
      .name = "show",
      .about =
          "Makes one HTML page of recorded runs: the world in 3-D, a timeline of events, population, tags, speed, the phylogeny "
          "and each robot's data. It opens from disk and needs no server.",
      .options =
          {{.name = "runs",
            .target = &options->runs,
            .help = "folders of runs, or of replicates; several are shown side by side",
            .required = true},
           {.name = "--out",
            .target = &options->out,
            .help = "new HTML file (default: RUN.html, or the next free RUN-2.html, ...)",
            .shorthand = "-o"},
           {.name = "--from", .target = &options->window.from_s, .help = "show only what happens after this time, in seconds"},
           {.name = "--to", .target = &options->window.to_s, .help = "show only what happens before this time, in seconds"}},
      .work = [options] { return detail::show::run(*options); },
      .examples = {"trophic show runs/quickstart-1"}};
}

}  // namespace trophic::command
