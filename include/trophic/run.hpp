// SPDX-License-Identifier: MIT
// Runs an ecology into a new folder: the only include of a short program besides its rules and its backend.
#pragma once

#include <filesystem>
#include <trophic/ecology/ecology.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// Runs an ecology until its clock reaches `until_s` seconds, and writes its tables, recording and manifest into a new folder:
/// the first of PATH-1, PATH-2, ... that does not exist. Shows progress on a terminal and prints a summary. `more` also observe
/// the run. Returns the folder. Throws as `Simulation::run_until` and `io::RunFolder` do.
std::filesystem::path run_in_new_folder(Simulation& ecology, double until_s, const std::filesystem::path& path,
                                        observe::Audience& more);
std::filesystem::path run_in_new_folder(Simulation& ecology, double until_s, const std::filesystem::path& path);

/// The same with observers (trophic/observe/hooks.hpp).
template <class... Observers>
std::filesystem::path run_in_new_folder(Simulation& ecology, double until_s, const std::filesystem::path& path,
                                        Observers&... observers) {
  observe::AudienceOf<Observers...> more{observers...};
  return run_in_new_folder(ecology, until_s, path, static_cast<observe::Audience&>(more));
}

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/run.ipp>
#endif
