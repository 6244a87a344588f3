// SPDX-License-Identifier: MIT
// Ecologies of ecologies.hpp: births without a death, criteria and ageing in `released`, and more room.
#include "ecologies.hpp"

using namespace trophic::arms_race;

template std::unique_ptr<trophic::AnyExperiment> trophic::make_experiment<PaperAfterEscapes>(const trophic::BackendChoice&,
                                                                                             std::string_view);
template std::unique_ptr<trophic::AnyExperiment> trophic::make_experiment<ReleasedMostEscapes>(const trophic::BackendChoice&,
                                                                                               std::string_view);
template std::unique_ptr<trophic::AnyExperiment> trophic::make_experiment<ReleasedAgeing>(const trophic::BackendChoice&,
                                                                                          std::string_view);
template std::unique_ptr<trophic::AnyExperiment> trophic::make_experiment<ReleasedMostEscapesAgeing>(
    const trophic::BackendChoice&, std::string_view);
template std::unique_ptr<trophic::AnyExperiment> trophic::make_experiment<PaperRoom>(const trophic::BackendChoice&,
                                                                                     std::string_view);
template std::unique_ptr<trophic::AnyExperiment> trophic::make_experiment<PaperMostEscapesRoom>(const trophic::BackendChoice&,
                                                                                                std::string_view);
