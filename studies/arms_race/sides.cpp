// SPDX-License-Identifier: MIT
// Ecologies of ecologies.hpp in which one side may evolve alone.
#include "ecologies.hpp"

using namespace trophic::arms_race;

template std::unique_ptr<trophic::AnyExperiment> trophic::make_experiment<PaperBySide>(const trophic::BackendChoice&,
                                                                                       std::string_view);
template std::unique_ptr<trophic::AnyExperiment> trophic::make_experiment<ReleasedBySide>(const trophic::BackendChoice&,
                                                                                          std::string_view);
template std::unique_ptr<trophic::AnyExperiment> trophic::make_experiment<PondBySide>(const trophic::BackendChoice&,
                                                                                      std::string_view);
template std::unique_ptr<trophic::AnyExperiment> trophic::make_experiment<GrowingBySide>(const trophic::BackendChoice&,
                                                                                         std::string_view);
