// SPDX-License-Identifier: MIT
// Runs an ecology into a new folder: the only include of a short program besides its rules and its backend.
#pragma once

#include <iostream>
#include <trophic/ecology/shipped.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/io/next_free_folder.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/observe/progress.hpp>

namespace trophic {

/// Runs an ecology until its clock reaches `until_s`, s, and writes its tables, recording and manifest into a new folder: the
/// first of PATH-1, PATH-2, ... that does not exist. Shows progress on a terminal and prints a summary. `observers` also
/// observe the run. Returns the folder. Throws as `Simulation::run_until` and `io::RunFolder` do.
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
