// SPDX-License-Identifier: MIT
// `trophic plot`: figures of an analysis, drawn by the Python module.
#include <memory>
#include <optional>
#include <tools/command/check_folder.hpp>
#include <tools/command/output.hpp>
#include <tools/command/run_python.hpp>
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

}  // namespace detail::plot

/// Draws the figures of an analysis.
Command plot() {
  const auto options = std::make_shared<detail::plot::Options>();
  Command command{
      .name = "plot",
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
      .work = {},
      .examples = {"trophic plot analysis", "trophic plot analysis --style ieee --out figures",
                   "trophic plot analysis/sweep --metric velocity:predator:inherited"}};
  return python_command("trophic", std::move(command), [options](Json&) {
    const std::filesystem::path analysis = options->analysis;
    check_folder(analysis);
    check_new_file("--out", options->out ? std::filesystem::path{*options->out} : analysis / "figures");
  });
}

}  // namespace trophic::command
