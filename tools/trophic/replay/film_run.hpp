// SPDX-License-Identifier: MIT
// From a recorded run to what a renderer draws, moment by moment, and into a file. Empty for who does not link trophic::film.
#pragma once

#ifdef TROPHIC_WITH_FILM
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <tools/trophic/replay/recorded_run.hpp>
#include <utility>

namespace trophic::command::replay {

/// Stretch, robots and look of a film.
struct FilmPlan {
  std::filesystem::path folder;
  std::filesystem::path out;
  Window window;
  std::optional<std::uint64_t> follow;
  std::string sheet;
  std::string size;  ///< of each picture; empty: 1280x720, in a sheet 480x360
  bool from_above = false;
  std::optional<double> speed;        ///< ecology seconds a second; empty: 10, of a catch 1
  std::optional<std::string> catch_;  ///< the catch that is shown: its number in the run, from 1, or "best"
  bool has_lines = true;              ///< trails, and who perceives whom
  bool has_legend = true;             ///< with counts, and a scale
  std::optional<std::string> title;   ///< empty: the run's name, rules, backend and seed
  std::uint64_t fps = 30;
  bool fine = false;
};

/// "1280x720" as two numbers from 1 to `most`. Throws std::invalid_argument naming the option.
[[nodiscard]] std::pair<std::size_t, std::size_t> two_numbers(std::string_view option, std::string_view text, std::size_t most);

/// Draws the film of a plan into its file and prints a line about it. Throws std::invalid_argument for errors in the plan or the
/// run, std::runtime_error for later ones.
[[nodiscard]] int film_run(const FilmPlan& plan);

}  // namespace trophic::command::replay
#endif
