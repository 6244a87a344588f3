// SPDX-License-Identifier: MIT
// What an experiment's runs are made of, for observers and manifests.
#pragma once

#include <string>
#include <string_view>
#include <trophic/backend/contract.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/params/named_params.hpp>
#include <trophic/params/numbers_text.hpp>
#include <trophic/rules/table.hpp>
#include <utility>
#include <vector>

namespace trophic {

/// Everything that determines a run of `experiment` in `habitat` until `until_s` (ecology seconds), and its fingerprint. `tags`:
/// those that the table's brains may choose.
template <class Rules, Backend B>
[[nodiscard]] observe::RunDescription describe(const Experiment<Rules, B>& experiment, const Habitat& habitat,
                                               std::vector<int> tags, double until_s) {
  observe::RunDescription run{.rules = table_name<Rules>(),
                              .slots = {},
                              .named_params = named_params_of(experiment),
                              .tags = std::move(tags),
                              .inputs = Rules::Sensors::value_names(),
                              .backend = std::string{B::name} + " " + B::version(),
                              .remarks = B::remarks(experiment.physics),
                              .seed = experiment.seed,
                              .tick_s = experiment.ecology.tick_s,
                              .clock_scale = experiment.ecology.clock_scale,
                              .until_s = until_s,
                              .fingerprint = {}};
  for_each_rule<Rules>([&](std::string_view slot, std::string_view policy) { run.slots.emplace_back(slot, policy); });
  run.fingerprint = observe::fingerprint(run, numbers_text(habitat));
  return run;
}

}  // namespace trophic
