// SPDX-License-Identifier: MIT
// Ecologies of ecologies.hpp: criteria and ageing in `paper`.
#include "ecologies.hpp"

using namespace trophic::arms_race;

template std::unique_ptr<trophic::AnyExperiment> trophic::make_experiment<PaperLastEscapee>(const trophic::BackendChoice&,
                                                                                            std::string_view);
template std::unique_ptr<trophic::AnyExperiment> trophic::make_experiment<PaperMostEscapes>(const trophic::BackendChoice&,
                                                                                            std::string_view);
template std::unique_ptr<trophic::AnyExperiment> trophic::make_experiment<PaperFastestEscape>(const trophic::BackendChoice&,
                                                                                              std::string_view);
template std::unique_ptr<trophic::AnyExperiment> trophic::make_experiment<PaperAgeing>(const trophic::BackendChoice&,
                                                                                       std::string_view);
template std::unique_ptr<trophic::AnyExperiment> trophic::make_experiment<PaperLastEscapeeAgeing>(const trophic::BackendChoice&,
                                                                                                  std::string_view);
template std::unique_ptr<trophic::AnyExperiment> trophic::make_experiment<PaperMostEscapesAgeing>(const trophic::BackendChoice&,
                                                                                                  std::string_view);
template std::unique_ptr<trophic::AnyExperiment> trophic::make_experiment<PaperFastestEscapeAgeing>(const trophic::BackendChoice&,
                                                                                                    std::string_view);
