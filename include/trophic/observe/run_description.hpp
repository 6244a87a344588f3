// SPDX-License-Identifier: MIT
// What a run is made of, as observers and manifests are told: rules, numbers, seed, versions.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <trophic/params/named_params.hpp>
#include <trophic/support/linkage.hpp>
#include <utility>
#include <vector>

namespace trophic::observe {

/// Everything that determines a run's results.
struct RunDescription {
  std::string rules;                                       ///< name of the rule table
  std::vector<std::pair<std::string, std::string>> slots;  ///< (slot, policy name) for every slot
  NamedParams named_params;                                ///< every number with its path: "rules.tag_switch.cool_down_s"
  std::vector<int> tags;                                   ///< that the table's brain may choose
  std::vector<std::string> inputs = {};                    ///< of the brain, each by the name of its sensor
  std::string backend;                                     ///< name and version of the engine
  std::vector<std::string> remarks;                        ///< what the engine does otherwise than the numbers say
  std::uint64_t seed = 0;
  double tick_s = 0.0;       ///< ecology seconds
  double clock_scale = 1.0;  ///< simulated seconds per ecology second
  double until_s = 0.0;      ///< when this run is to end, ecology seconds
  std::string fingerprint;   ///< see `fingerprint`
};

/// Whether two runs may be pooled as replicates: 16 hexadecimal digits of rules, numbers, models and backend; not of the seed,
/// the duration and the number of threads. `models` is the text of the models' numbers.
[[nodiscard]] std::string fingerprint(const RunDescription& run, std::string_view models);

}  // namespace trophic::observe

#if TROPHIC_HEADER_ONLY
#include <trophic/observe/run_description.ipp>
#endif
