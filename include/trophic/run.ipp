// SPDX-License-Identifier: MIT
// Definitions of run.hpp.
#pragma once

#include <iostream>
#include <trophic/io/next_free_folder.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/observe/both.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/run.hpp>

namespace trophic {

TROPHIC_INLINE std::filesystem::path run_in_new_folder(Simulation& ecology, double until_s, const std::filesystem::path& path,
                                                       observe::Audience& more) {
  io::RunFolder folder{io::next_free_folder(path), {}, {}, Opening::created, ecology.state_columns()};
  observe::Progress progress;
  observe::AudienceOf<io::RunFolder, observe::Progress> own{folder, progress};
  observe::Both both{own, more};
  ecology.run_before(both, until_s);
  progress.summary(std::cout, ecology.view());
  return folder.path();
}

TROPHIC_INLINE std::filesystem::path run_in_new_folder(Simulation& ecology, double until_s, const std::filesystem::path& path) {
  observe::AudienceOf<> none;
  return run_in_new_folder(ecology, until_s, path, static_cast<observe::Audience&>(none));
}

}  // namespace trophic
