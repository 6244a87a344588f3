// SPDX-License-Identifier: MIT
// The models that an experiment names, from their files.
#pragma once

#include <string_view>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/habitat/load/installed_models.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// Loads and checks the three models. Throws std::invalid_argument for a file that is missing or broken, or whose content does
/// not fit, naming file and key.
[[nodiscard]] Habitat load_habitat(const EcologyParams& ecology, std::string_view installed = TROPHIC_MODEL_DIR);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/load/habitat.ipp>
#endif
