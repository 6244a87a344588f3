// SPDX-License-Identifier: MIT
// Definitions of run_description.hpp.
#pragma once

#include <trophic/observe/run_description.hpp>

namespace trophic::observe {

TROPHIC_INLINE std::string fingerprint(const RunDescription& run, std::string_view models) {
  std::string text = run.backend + "\n";
  for (const auto& [slot, policy] : run.slots) text += slot + "=" + policy + "\n";
  for (const NamedParam& param : run.named_params) {
    if (param.path == "seed" || param.path == "ecology.duration_s" || param.path == "backend.threads") continue;
    text += param.path + "=" + value_text(param) + "\n";
  }
  return hash_text(text.append(models));
}

}  // namespace trophic::observe
