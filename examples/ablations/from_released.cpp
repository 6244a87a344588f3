// SPDX-License-Identifier: MIT
// All flips of the table `released`.
#include <tools/ablations/run_swap.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

template std::vector<std::string> trophic::command::run_swap<trophic::rules::Released, trophic::rules::Paper>(const std::string&,
                                                                                                              const Study&);
