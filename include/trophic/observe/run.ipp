// SPDX-License-Identifier: MIT
// Definitions of run.hpp.
#pragma once

#include <string>
#include <string_view>
#include <trophic/observe/run.hpp>
#include <trophic/params/settings.hpp>

namespace trophic::observe {

TROPHIC_INLINE std::string fingerprint(const Run& run, std::string_view models) {
  std::string text = run.backend + "\n";
  for (const auto& [slot, policy] : run.slots) text += slot + "=" + policy + "\n";
  for (const Setting& setting : run.settings) {
    if (setting.path == "seed" || setting.path == "world.duration_s" || setting.path == "backend.threads") continue;
    text += setting.path + "=" + value_text(setting) + "\n";
  }
  return hash_text(text.append(models));
}

}  // namespace trophic::observe
