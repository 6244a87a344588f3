// SPDX-License-Identifier: MIT
// The experiments of the study, each compiled in one of three files.
#pragma once

#include <trophic/experiment/table_experiment.hpp>

#include "tables.hpp"

namespace trophic {

// In criteria.cpp.
extern template std::unique_ptr<AnyExperiment> make_experiment<arms_race::PaperLastEscapee>(const BackendChoice&,
                                                                                            std::string_view);
extern template std::unique_ptr<AnyExperiment> make_experiment<arms_race::PaperMostEscapes>(const BackendChoice&,
                                                                                            std::string_view);
extern template std::unique_ptr<AnyExperiment> make_experiment<arms_race::PaperFastestEscape>(const BackendChoice&,
                                                                                              std::string_view);
extern template std::unique_ptr<AnyExperiment> make_experiment<arms_race::PaperAgeing>(const BackendChoice&, std::string_view);
extern template std::unique_ptr<AnyExperiment> make_experiment<arms_race::PaperLastEscapeeAgeing>(const BackendChoice&,
                                                                                                  std::string_view);
extern template std::unique_ptr<AnyExperiment> make_experiment<arms_race::PaperMostEscapesAgeing>(const BackendChoice&,
                                                                                                  std::string_view);
extern template std::unique_ptr<AnyExperiment> make_experiment<arms_race::PaperFastestEscapeAgeing>(const BackendChoice&,
                                                                                                    std::string_view);

// In others.cpp.
extern template std::unique_ptr<AnyExperiment> make_experiment<arms_race::PaperAfterEscapes>(const BackendChoice&,
                                                                                             std::string_view);
extern template std::unique_ptr<AnyExperiment> make_experiment<arms_race::ReleasedMostEscapes>(const BackendChoice&,
                                                                                               std::string_view);
extern template std::unique_ptr<AnyExperiment> make_experiment<arms_race::ReleasedAgeing>(const BackendChoice&, std::string_view);
extern template std::unique_ptr<AnyExperiment> make_experiment<arms_race::ReleasedMostEscapesAgeing>(const BackendChoice&,
                                                                                                     std::string_view);
extern template std::unique_ptr<AnyExperiment> make_experiment<arms_race::PaperRoom>(const BackendChoice&, std::string_view);
extern template std::unique_ptr<AnyExperiment> make_experiment<arms_race::PaperMostEscapesRoom>(const BackendChoice&,
                                                                                                std::string_view);

// In sides.cpp.
extern template std::unique_ptr<AnyExperiment> make_experiment<arms_race::PaperBySide>(const BackendChoice&, std::string_view);
extern template std::unique_ptr<AnyExperiment> make_experiment<arms_race::ReleasedBySide>(const BackendChoice&, std::string_view);
extern template std::unique_ptr<AnyExperiment> make_experiment<arms_race::PondBySide>(const BackendChoice&, std::string_view);
extern template std::unique_ptr<AnyExperiment> make_experiment<arms_race::GrowingBySide>(const BackendChoice&, std::string_view);

}  // namespace trophic
