// SPDX-License-Identifier: MIT
// `trophic plot`: figures of an analysis, drawn by the Python module.
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <system_error>
#include <tools/command/check_folder.hpp>
#include <tools/command/output.hpp>
#include <tools/command/this_program.hpp>
#include <vector>

#include "commands.hpp"

namespace trophic::command {

namespace detail::plot {

struct Options {
  std::string analysis;
  std::optional<std::string> out;
  std::string style = "plain";
  std::string columns = "1";
  bool with_captions = false;
  std::optional<std::uint64_t> run;
  std::vector<std::string> metrics;
  std::vector<std::string> axes;
};

/// The folder of the Python module: PREFIX/share/trophic/python next to an installed PREFIX/bin, else that of the sources.
[[nodiscard]] std::filesystem::path module_folder(const std::filesystem::path& program) {
  const std::filesystem::path installed = program.parent_path().parent_path() / "share/trophic/python";
  std::error_code ignored;
  return std::filesystem::is_directory(installed, ignored) ? installed : std::filesystem::path{TROPHIC_PYTHON_DIR};
}

[[nodiscard]] int run(const Options& options) {
  const std::filesystem::path analysis = options.analysis;
  check_folder(analysis);
  check_new_file("--out", options.out ? std::filesystem::path{*options.out} : analysis / "figures");
  const std::filesystem::path program = program_path();
  const std::filesystem::path folder = module_folder(program);
  if (!std::filesystem::exists(folder / "trophic/plot.py")) {
    throw std::invalid_argument{"the Python module is not installed: there is no " + (folder / "trophic/plot.py").string()};
  }
  const char* path = std::getenv("PYTHONPATH");
  ::setenv("PYTHONPATH", (folder.string() + (path == nullptr || *path == '\0' ? "" : ":" + std::string{path})).c_str(), 1);
  const char* named = std::getenv("TROPHIC_PYTHON");
  const std::string python = named == nullptr ? "python3" : named;
  std::vector<std::string> words{python,           "-m",      "trophic.plot", options.analysis, "--trophic",
                                 program.string(), "--style", options.style,  "--columns",      options.columns};
  if (options.out) words.insert(words.end(), {"--out", *options.out});
  if (options.with_captions) words.emplace_back("--with-captions");
  if (options.run) words.insert(words.end(), {"--run", std::to_string(*options.run)});
  const auto add = [&](const char* option, const std::vector<std::string>& values) {
    if (values.empty()) return;
    words.emplace_back(option);
    words.insert(words.end(), values.begin(), values.end());
  };
  add("--metric", options.metrics);
  add("--axes", options.axes);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::cout.flush();
  ::execvp(python.c_str(), arguments.data());
  throw std::invalid_argument{python + ": " + std::strerror(errno) + "; TROPHIC_PYTHON names another Python"};
}

}  // namespace detail::plot

/// Draws the figures of an analysis.
Command plot() {
  const auto options = std::make_shared<detail::plot::Options>();
  return {.name = "plot",
          .about =
              "Draws the figures of what `trophic analyze` or `trophic cross-check` wrote, as PNG and PDF with captions.json and "
              "captions.tex: "
              "the paper's figures, a forest plot of a comparison, response curves and heat maps of a sweep. Needs Python with "
              "matplotlib, "
              "pandas and scipy.",
          .options =
              {{.name = "analysis", .target = &options->analysis, .help = "folder of the analysis", .required = true},
               {.name = "--out", .target = &options->out, .help = "new folder for the figures (ANALYSIS/figures)"},
               {.name = "--style",
                .target = &options->style,
                .help = "fonts and widths: plain, serif or ieee (plain)",
                .words = {"plain", "serif", "ieee"}},
               {.name = "--columns",
                .target = &options->columns,
                .help = "width of a figure in columns of the page, 1 or 2 (1)",
                .words = {"1", "2"}},
               {.name = "--with-captions", .target = &options->with_captions, .help = "draw the captions into the figures, too"},
               {.name = "--run",
                .target = &options->run,
                .help = "whose phylogeny, paths and catch are drawn: the N-th run of a set, from 0 (0)"},
               {.name = "--metric",
                .target = &options->metrics,
                .help = "for a sweep: draw only these; METRIC, METRIC:SPECIES or METRIC:SPECIES:GROUP"},
               {.name = "--axes", .target = &options->axes, .help = "for a sweep: what to draw along x, as lines and as panels"}},
          .work = [options] { return detail::plot::run(*options); },
          .subcommands = {},
          .version = {},
          .examples = {"trophic plot analysis", "trophic plot analysis --style ieee --out figures",
                       "trophic plot analysis/sweep --metric velocity:predator:inherited"}};
}

}  // namespace trophic::command
