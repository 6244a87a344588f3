// SPDX-License-Identifier: MIT
// `trophic ablation-table`, what each swap of an ablation study changes: one table over all swaps and metrics, corrected for
// their number.
#include "commands.hpp"

#include <sstream>
#include <tools/ablations/swaps.hpp>
#include <tools/analysis/metrics/run_set.hpp>
#include <tools/analysis/report/ablation_tables.hpp>
#include <tools/analysis/report/compare_sets.hpp>
#include <tools/analysis/report/swaps.hpp>
#include <tools/analysis/report/table_file.hpp>
#include <tools/command/option.hpp>
#include <tools/command/output.hpp>
#include <tools/replicates/parallel.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/support/new_file.hpp>

namespace trophic::command {

namespace detail::ablation_table {

struct Options {
  std::string runs;
  std::uint64_t jobs = 1;
  std::string out = "swaps";
};

[[nodiscard]] analysis::ShadowedSet read(const std::filesystem::path& folder) {
  return analysis::read_shadowed_set(std::array{folder});
}

/// All swaps of one table compared with its base.
struct Direction {
  std::string name;
  std::optional<analysis::ShadowedSet> base;
  std::vector<analysis::SwapEffect> effects;
};

/// The tables that a study starts from: every folder "from_TABLE" with a base, by name.
[[nodiscard]] std::vector<std::string> directions_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  if (!std::filesystem::is_directory(folder)) return names;
  for (const auto& entry : std::filesystem::directory_iterator{folder}) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(direction_prefix) && std::filesystem::is_directory(entry.path() / base_name)) names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

/// The sets next to the base: every folder with a list of replicates, by name.
[[nodiscard]] std::vector<std::string> swaps_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator{folder}) {
    const std::string name = entry.path().filename().string();
    if (name != base_name && std::filesystem::exists(entry.path() / "replicates.json")) names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

void check_complete(const analysis::ShadowedSet& set) {
  const auto check = [](const analysis::RunSet& runs) {
    for (const analysis::RunManifest& manifest : runs.manifests) {
      if (manifest.status != "complete") {
        throw std::invalid_argument{manifest.folder.string() + ": status \"" + manifest.status + "\": must be complete"};
      }
    }
    if (!runs.remarks.empty()) throw std::invalid_argument{runs.remarks.front()};
  };
  check(set.ours);
  if (set.shadow) check(*set.shadow);
}

[[nodiscard]] Direction read_direction(const std::filesystem::path& folder, std::size_t jobs) {
  Direction direction{folder.filename().string(), read(folder / base_name), {}};
  check_complete(*direction.base);
  const std::vector<std::string> names = swaps_in(folder);
  std::vector<std::vector<analysis::SwapEffect>> parts(names.size());
  const auto compare = [&](std::size_t i) {
    const analysis::ShadowedSet swapped = read(folder / names[i]);
    check_complete(swapped);
    analysis::check_comparable(direction.base->ours.manifests.front(), swapped.ours.manifests.front());
    if (direction.base->shadow.has_value() != swapped.shadow.has_value()) {
      throw std::invalid_argument{(folder / names[i]).string() + ": one of it and its base has a shadow, the other has none"};
    }
    parts[i] = analysis::effects_of(names[i], analysis::compare_sets(*direction.base, swapped));
  };
  const auto attempts = replicates::in_parallel(names.size(), jobs, compare, [] { return true; });
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!attempts[i].error.empty()) throw std::invalid_argument{names[i] + ": " + attempts[i].error};
    direction.effects.insert(direction.effects.end(), parts[i].begin(), parts[i].end());
  }
  analysis::adjust_together(direction.effects);
  return direction;
}

void write(const Options& options) {
  const std::filesystem::path runs = options.runs;
  std::vector<Direction> directions;
  for (const std::string& name : directions_in(runs)) directions.push_back(read_direction(runs / name, options.jobs));
  if (directions.empty()) throw std::invalid_argument{options.runs + ": has no folder from_TABLE with a base"};
  if (directions.size() > 2) throw std::invalid_argument{options.runs + ": has more than two folders from_TABLE"};

  const auto out = io::make_new_folder(options.out);
  analysis::TableFile<analysis::SwapRow> csv{out / "ablations.csv"};
  const auto write_rows = [&csv](const std::string& direction, std::span<const analysis::SwapEffect> effects) {
    for (const analysis::SwapEffect& effect : effects) csv.write(analysis::row_of(effect, direction));
  };
  std::ostringstream text;
  for (const Direction& direction : directions) {
    write_rows(direction.name, direction.effects);
    text << "## " << direction.name << "\n\n";
    analysis::print_significant(text, direction.effects);
    text << "\np: corrected for all swaps and metrics of this direction; intervals are those of single comparisons.\n\n";
  }
  if (directions.size() == 2) {
    const auto& [first, second] = std::pair{&directions[0], &directions[1]};
    const auto table_of = [](const Direction& direction) { return direction.name.substr(direction_prefix.size()); };
    analysis::check_comparable(first->base->ours.manifests.front(), second->base->ours.manifests.front());
    auto whole = analysis::effects_of(table_of(*second), analysis::compare_sets(*first->base, *second->base));
    analysis::adjust_together(whole);
    write_rows(table_of(*first) + "_to_" + table_of(*second), whole);
    std::vector<std::string> groups;
    for (const SlotGroup& group : slot_groups) groups.emplace_back(group.name);
    text << "## Together\n\nFirst: " << table_of(*first) << ". Second: " << table_of(*second)
         << ". Each group of rules alone put into the first, and taken out of the second.\n\n";
    analysis::print_shares(text, whole, first->effects, second->effects, groups);
    text << "\n*: significant in its direction. Sums that miss the whole difference show that the groups act on each other.\n";
  }
  csv.finish();
  write_new_file(out / "ablations.md", text.str());
  std::cout << "files   " << out.string() << "/{ablations.csv,ablations.md}\n";
  flush_output();
}

}  // namespace detail::ablation_table

/// One table over all swaps of an ablation study.
Command ablation_table() {
  const auto options = std::make_shared<detail::ablation_table::Options>();
  return {.name = "ablation-table",
          .about =
              "Reads the sets of an ablation study and writes what each swap changes: ablations.csv (all) and ablations.md (the "
              "significant ones).",
          .options = {{"runs", &options->runs, "the OUT of the study", {}, 0, true},
                      {"--jobs", &options->jobs, "sets measured at a time (1)"},
                      {"--out", &options->out, "new folder for the tables (swaps)"}},
          .work =
              [options] {
                if (options->jobs == 0) throw std::invalid_argument{"--jobs 0: must be >= 1"};
                detail::ablation_table::write(*options);
                return 0;
              },
          .subcommands = {},
          .version = {}};
}

}  // namespace trophic::command
