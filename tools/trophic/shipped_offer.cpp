// SPDX-License-Identifier: MIT
// Definitions of shipped_offer.hpp.
#include "shipped_offer.hpp"

#include <trophic/experiment/table_experiment.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

namespace trophic::command {

namespace {

template <class Rules>
[[nodiscard]] std::unique_ptr<AnyExperiment> make(const BackendChoice& backend) {
  return std::make_unique<TableExperiment<Rules>>(backend);
}

}  // namespace

Offer shipped_offer() {
  return with_backends({.rule_tables = {{table_name<rules::Paper>(), &make<rules::Paper>},
                                        {table_name<rules::Released>(), &make<rules::Released>}}});
}

}  // namespace trophic::command
