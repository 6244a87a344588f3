// SPDX-License-Identifier: MIT
// What each flip of `ablations` changes: one table over all flips and metrics, corrected for their number.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <trophic/analysis/metrics/run_set.hpp>
#include <trophic/analysis/report/compare_sets.hpp>
#include <trophic/analysis/report/flip_tables.hpp>
#include <trophic/analysis/report/flips.hpp>
#include <trophic/observe/csv.hpp>
#include <trophic/observe/run_folder.hpp>
#include <trophic/replicates/parallel.hpp>
#include <utility>
#include <vector>

#include "ablations/flips.hpp"
#include "command.hpp"

namespace {

namespace examples = trophic::examples;
namespace analysis = trophic::analysis;

struct Options {
  std::filesystem::path runs;
  std::size_t jobs = 1;
  std::filesystem::path out = "flips";
};

analysis::ShadowedSet read(const std::filesystem::path& folder) {
  return analysis::read_shadowed_set(std::array{folder});
}

/// All flips of one table against its base.
struct Direction {
  std::string name;
  std::optional<analysis::ShadowedSet> base;
  std::vector<analysis::FlipEffect> effects;
};

/// The sets beside the base: every folder with a list of replicates, by name.
std::vector<std::string> flips_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator{folder}) {
    const std::string name = entry.path().filename().string();
    if (name != examples::base_name && std::filesystem::exists(entry.path() / "replicates.json")) names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

void check_complete(const analysis::ShadowedSet& set) {
  const auto check = [](const analysis::RunSet& runs) {
    for (const analysis::RunFacts& facts : runs.facts) {
      if (facts.status != "complete") {
        throw std::invalid_argument{facts.folder.string() + ": status \"" + facts.status + "\": must be complete"};
      }
    }
    if (!runs.remarks.empty()) throw std::invalid_argument{runs.remarks.front()};
  };
  check(set.ours);
  if (set.shadow) check(*set.shadow);
}

Direction read_direction(const std::filesystem::path& folder, std::size_t jobs) {
  Direction direction{folder.filename().string(), read(folder / examples::base_name), {}};
  check_complete(*direction.base);
  const std::vector<std::string> names = flips_in(folder);
  std::vector<std::vector<analysis::FlipEffect>> parts(names.size());
  const auto compare = [&](std::size_t i) {
    const analysis::ShadowedSet flipped = read(folder / names[i]);
    check_complete(flipped);
    analysis::check_comparable(direction.base->ours.facts.front(), flipped.ours.facts.front());
    if (direction.base->shadow.has_value() != flipped.shadow.has_value()) {
      throw std::invalid_argument{(folder / names[i]).string() + ": one of it and its base has a shadow, the other has none"};
    }
    parts[i] = analysis::effects_of(names[i], analysis::compare_sets(*direction.base, flipped));
  };
  const auto attempts = trophic::replicates::in_parallel(names.size(), jobs, compare, [] { return true; });
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!attempts[i].error.empty()) throw std::invalid_argument{names[i] + ": " + attempts[i].error};
    direction.effects.insert(direction.effects.end(), parts[i].begin(), parts[i].end());
  }
  analysis::adjust_together(direction.effects);
  return direction;
}

void write(const Options& options) {
  std::vector<Direction> directions;
  for (const char* name : {"from_paper", "from_released"}) {
    if (std::filesystem::is_directory(options.runs / name)) {
      directions.push_back(read_direction(options.runs / name, options.jobs));
    }
  }
  if (directions.empty()) throw std::invalid_argument{options.runs.string() + ": has neither from_paper nor from_released"};

  const auto out = trophic::observe::make_new_folder(options.out);
  trophic::observe::CsvFile<analysis::FlipRow> csv{out / "flips.csv"};
  const auto write_rows = [&csv](const std::string& direction, std::span<const analysis::FlipEffect> effects) {
    for (const analysis::FlipEffect& effect : effects) csv.write(analysis::row_of(effect, direction));
    csv.flush();
  };
  std::ofstream text{out / "flips.md"};
  for (const Direction& direction : directions) {
    write_rows(direction.name, direction.effects);
    text << "## " << direction.name << "\n\n";
    analysis::print_decided(text, direction.effects);
    text << "\np: corrected for all flips and metrics of this direction; intervals are those of single comparisons.\n\n";
  }
  if (directions.size() == 2) {
    const auto& [paper, released] = std::pair{&directions[0], &directions[1]};
    analysis::check_comparable(paper->base->ours.facts.front(), released->base->ours.facts.front());
    auto whole = analysis::effects_of("released", analysis::compare_sets(*paper->base, *released->base));
    analysis::adjust_together(whole);
    write_rows("paper_to_released", whole);
    std::vector<std::string> groups;
    for (const examples::SlotGroup& group : examples::slot_groups) groups.emplace_back(group.name);
    text << "## Together\n\nFirst: paper. Second: released. Each group of rules alone put into the first, and taken out of the "
            "second.\n\n";
    analysis::print_shares(text, whole, paper->effects, released->effects, groups);
    text << "\n*: decided in its direction. Sums that miss the whole difference show that the groups act on each other.\n";
  }
  text.close();
  if (!text) throw std::runtime_error{"cannot write " + (out / "flips.md").string()};
  std::cout << "files   " << out.string() << "/{flips.csv,flips.md}" << std::endl;
  if (!std::cout) throw std::runtime_error{"cannot write to standard output"};
}

}  // namespace

int main(int argc, char** argv) {
  using namespace trophic::examples;
  Options options;
  CLI::App app{"Reads the sets of ablations and writes what each flip changes: flips.csv (all) and flips.md (what is decided)."};
  app.add_option("runs", options.runs, "the OUT of ablations")->required();
  app.add_option("--jobs", options.jobs, "sets measured at a time (1)");
  app.add_option("--out", options.out, "new folder for the tables (flips)");
  return run_command(app, argc, argv, "flip_table", [&] {
    if (options.jobs == 0) throw std::invalid_argument{"--jobs 0: must be >= 1"};
    write(options);
    return 0;
  });
}
