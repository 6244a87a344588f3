// SPDX-License-Identifier: MIT
// All flips of the table `paper`.
#include <tools/ablations/run_swap.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

template std::vector<std::string> trophic::command::run_swap<trophic::rules::Paper, trophic::rules::Released>(const std::string&,
                                                                                                              const Study&);
