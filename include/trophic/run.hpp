// SPDX-License-Identifier: MIT
// One run of an ecology into a folder of its own: all that a short program includes besides its rules and its backend.
#pragma once

#include <filesystem>
#include <iostream>
#include <trophic/ecology/ecology.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/io/next_free_folder.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/observe/progress.hpp>

namespace trophic {

/// Runs an ecology until its clock reaches `until_s`, s, and writes its tables, recording and manifest into a new folder: the
/// first of PATH-1, PATH-2, ... that does not exist. Shows progress on a terminal and prints a summary. `observers` observe the
/// run, too. Returns the folder. Throws as `Simulation::run_until` and `io::RunFolder` do.
template <class... Observers>
std::filesystem::path run_in_new_folder(Simulation& ecology, double until_s, const std::filesystem::path& path,
                                        Observers&... observers) {
  io::RunFolder folder{io::next_free_folder(path), {}, {}, Opening::created, ecology.state_columns()};
  observe::Progress progress;
  ecology.run_until(until_s, folder, progress, observers...);
  progress.summary(std::cout, ecology.view());
  return folder.path();
}

}  // namespace trophic
