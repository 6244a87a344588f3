// SPDX-License-Identifier: MIT
// `trophic contest`: hunters of one epoch against victims of another, drawn and judged by the Python module.
#include <memory>
#include <tools/command/run_python.hpp>

#include "commands.hpp"

namespace trophic::command {

namespace detail::contest_command {

struct Options {
  std::vector<std::string> runs;
  std::optional<std::string> shadow;
  std::optional<std::string> panel;
  std::string epochs;
  std::string against = "others";
  std::uint64_t teams = 6;
  std::optional<std::uint64_t> team_size;
  double duration_s = 300.0;
  double reach_m = 1.0;
  std::optional<double> split_s;
  std::uint64_t seed = 1;
  std::optional<std::string> backend;
  std::string program = "trophic-predator-prey";
  std::optional<std::uint64_t> jobs;
  std::optional<std::string> out;
  bool accept_other_build = false;
};

}  // namespace detail::contest_command

/// Contests across generations.
Command contest_command() {
  using detail::contest_command::Options;
  const auto options = std::make_shared<Options>();
  Command command{
      .name = "contest",
      .about =
          "Lets hunters of one epoch of the runs meet victims of another, in the runs' arena without catches, births and deaths. "
          "Progress of a species is how much sooner its later hunters reach the victims of all epochs, or how much later its "
          "later victims are reached; against opponents of other replicates it is global, against those from the same run "
          "historical. It is compared with the neutral shadow, which is found in RUNS/shadow. Needs Python with pandas and "
          "scipy.",
      .options = {{.name = "runs", .target = &options->runs, .help = "folders of runs, or of replicates", .required = true},
                  {"--shadow", &options->shadow, "folder of the shadow (RUNS/shadow, if there is one)"},
                  {"--epochs", &options->epochs, "comma-separated times, e.g. 0,2000,6000 (default: four, evenly spaced)"},
                  {"--against",
                   &options->against,
                   "opponents: others, of another replicate; own; or both (others)",
                   {"others", "own", "both"}},
                  {"--panel", &options->panel, "folder of runs whose last living are the opponents of all, instead of --against"},
                  {"--split", &options->split_s, "the epoch at which the late period begins (that in the middle)"},
                  {"--teams", &options->teams, "teams drawn for each epoch and species, at least 2 (6)"},
                  {"--team-size", &options->team_size, "robots in a team (half of the runs' robots)"},
                  {"--duration", &options->duration_s, "length of a contest, seconds of the ecology's clock (300)"},
                  {"--reach", &options->reach_m, "distance in metres at which a hunter reaches a victim (1)"},
                  {"--seed", &options->seed, "of teams, partners and places (1)"},
                  {"--backend", &options->backend, "play on this backend, with its default parameters (the runs')"},
                  {"--program", &options->program, "the program that made the runs (trophic-predator-prey)"},
                  {"--jobs", &options->jobs, "contests at a time (one per core); results do not depend on it"},
                  {"--accept-other-build", &options->accept_other_build, "take runs that several builds of a program made"},
                  {"--out", &options->out,
                   "new folder for contests.csv and progress.csv (the next free contests, contests-1, ...)"}},
      .work = {},
      .examples = {"trophic contest runs/study", "trophic contest runs/study --against both --epochs 0,2000,4000,6000",
                   "trophic contest runs/mine --program build/my_experiment"}};
  return python_command("trophic", std::move(command), [options](Json& request) { request["experiment"] = options->program; });
}

}  // namespace trophic::command
