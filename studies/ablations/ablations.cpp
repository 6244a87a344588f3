// SPDX-License-Identifier: MIT
// The study of studies/results/ablations.md: `paper` and `released`, and each with one rule, or a group of rules, of the other.
#include <algorithm>
#include <iterator>
#include <trophic/experiment.hpp>

#include "swaps.hpp"

int main(int argc, char** argv) {
  using namespace trophic;
  return command::experiment_program(argc, argv, [] {
    Offer offer;
    offer.rule_tables = rule_tables<rules::Paper, rules::Released>();
    std::ranges::move(ablations::from_paper(), std::back_inserter(offer.rule_tables));
    std::ranges::move(ablations::from_released(), std::back_inserter(offer.rule_tables));
    return offer;
  });
}
