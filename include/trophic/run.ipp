// SPDX-License-Identifier: MIT
// Definitions of run.hpp.
#pragma once

#include <iostream>
#include <memory>
#include <trophic/io/next_free_folder.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/observe/both.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/run.hpp>

namespace trophic {

namespace detail {

/// Makes the next free folder. Another program may take a name at the same moment.
[[nodiscard]] TROPHIC_INLINE std::unique_ptr<io::RunFolder> next_run_folder(const Simulation& ecology,
                                                                            const std::filesystem::path& path) {
  for (;;) {
    try {
      return std::make_unique<io::RunFolder>(io::next_free_folder(path), io::Provenance{}, io::OutputOptions{}, Opening::created,
                                             ecology.state_columns());
    } catch (const io::FolderExists&) {
    }
  }
}

}  // namespace detail

TROPHIC_INLINE std::filesystem::path run_in_new_folder(Simulation& ecology, double until_s, const std::filesystem::path& path,
                                                       observe::Audience& more) {
  const std::unique_ptr<io::RunFolder> made = detail::next_run_folder(ecology, path);
  io::RunFolder& folder = *made;
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
