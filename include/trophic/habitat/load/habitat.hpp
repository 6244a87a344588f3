// SPDX-License-Identifier: MIT
// Loads the models that an experiment names.
#pragma once

#include <string_view>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/habitat/load/installed_models.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// Loads and checks the three models. Throws std::invalid_argument, naming file and key, for a file that is missing or invalid,
/// or whose content does not fit.
[[nodiscard]] Habitat load_habitat(const EcologyParams& ecology, std::string_view installed = TROPHIC_MODEL_DIR);

/// The same with the models that rules name.
[[nodiscard]] Habitat load_habitat(const EcologyParams& ecology, const ModelNames& names, std::string_view installed);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/load/habitat.ipp>
#endif
