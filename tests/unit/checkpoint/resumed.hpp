// SPDX-License-Identifier: MIT
// Runs that are cut off and go on, held against one that is not.
#pragma once

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/run/checkpoint/resume.hpp>
#include <trophic/support/json.hpp>

namespace trophic::test {

[[nodiscard]] inline std::string content(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

/// What must be the same bytes however often a run was cut off: its tables and recording, its last checkpoint's ecology, and its
/// manifest but for who went on with it.
[[nodiscard]] inline std::vector<std::string> results_in(const std::filesystem::path& folder) {
  std::vector<std::string> results;
  for (const char* table : {"events.csv", "agents.csv", "phylogeny.csv", "genomes.csv", "replay.trp"})
    results.push_back(content(folder / table));
  for (const auto* name : {"senses.csv", "states.csv", "genes.csv", "bodies.csv"}) {
    if (std::filesystem::exists(folder / name)) results.push_back(content(folder / name));
  }
  results.push_back(checkpoint::read_last(folder).section(checkpoint::ecology_section));
  auto manifest = parse_json(content(folder / "manifest.json"));
  manifest.erase("continued");
  manifest.erase("crc32");
  manifest["params"]["backend"].erase("threads");  // results do not depend on it
  results.push_back(json_text(manifest));
  return results;
}

/// Throws in the middle of what observers do at a tick, when some of them have written and some have not.
struct Crash {
  std::int64_t at_tick = 0;
  void on_tick(const View& view) {
    if (view.tick >= at_tick) throw std::runtime_error{"crash"};
  }
};

inline constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();

/// Begins or goes on with a run in a folder, with a checkpoint every so many seconds of its clock, until it ends or crashes.
template <class Rules>
void run_part(const Experiment<Rules>& experiment, const BackendChoice& backend, const std::filesystem::path& folder,
              std::int64_t crash_tick, double every_s, const io::OutputOptions& output = {}) {
  Ecology<Rules> ecology{experiment, backend};
  const double until_s = experiment.ecology.duration_s;
  const auto run_state = checkpoint::run_state_in(folder, ecology.describe(until_s));
  Crash crash{.at_tick = crash_tick};
  io::RunFolder files{folder, {}, output, run_state.opening(), ecology.state_columns()};
  const checkpoint::Schedule schedule{.every_s = every_s, .most_share = std::numeric_limits<double>::infinity()};
  try {
    checkpoint::run_with_checkpoints(ecology, until_s, folder, schedule, run_state.from, files, crash);
  } catch (const std::runtime_error& error) {
    REQUIRE(std::string{error.what()} == "crash");
  }
}

/// To its end, cut off at each of these ticks. `before` is called with the number of each part and the backend's numbers, to
/// change what must not change results.
template <class Rules, class BackendParams, class Before>
void run_in_parts(const Experiment<Rules>& experiment, BackendParams backend, const std::filesystem::path& folder,
                  const std::vector<std::int64_t>& cuts, double every_s, Before&& before) {
  for (std::size_t part = 0; part <= cuts.size(); ++part) {
    before(part, backend);
    run_part(experiment, backend, folder, part < cuts.size() ? cuts[part] : never, every_s);
  }
}

/// The tables of a run that was cut off and of one that was not are the same bytes.
template <class Rules, class BackendParams, class Before>
void check_resumed(const Experiment<Rules>& experiment, const BackendParams& backend, const std::filesystem::path& folder,
                   const std::vector<std::int64_t>& cuts, double every_s, Before&& before) {
  run_in_parts(experiment, backend, folder / "whole", {}, every_s, [](std::size_t, auto&) {});
  run_in_parts(experiment, backend, folder / "parts", cuts, every_s, before);
  const auto whole = results_in(folder / "whole");
  const auto parts = results_in(folder / "parts");
  REQUIRE(whole.size() == parts.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    CAPTURE(i);
    CHECK(whole[i].size() > 100);
    CHECK(whole[i] == parts[i]);
  }
}

}  // namespace trophic::test
