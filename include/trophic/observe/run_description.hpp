// SPDX-License-Identifier: MIT
// The rules, parameters, seed and versions of a run, for observers and manifests.
#pragma once

#include <cstddef>
#include <trophic/params/named_params.hpp>

namespace trophic::observe {

/// Everything that determines a run's results.
struct RunDescription {
  std::string rules;                                       ///< name of the rule table
  std::vector<std::pair<std::string, std::string>> slots;  ///< (slot, policy name) for every slot
  NamedParams named_params;                                ///< every parameter with its path: "rules.tag_switch.cool_down_s"
  std::vector<int> tags;                                   ///< the tags that the table's brain may choose
  std::vector<std::string> inputs = {};                    ///< the brain's inputs, by sensor name
  std::string backend;                                     ///< name and version of the engine
  std::vector<std::string> remarks;                        ///< where the engine deviates from the parameters
  std::uint64_t seed = 0;
  double tick_s = 0.0;           ///< ecology seconds
  double clock_scale = 1.0;      ///< simulated seconds per ecology second
  double until_s = 0.0;          ///< the end of this run, ecology seconds
  std::string fingerprint;       ///< see `fingerprint`
  std::size_t spare_bodies = 0;  ///< bodies that start without an individual
  bool brains_grow = false;      ///< whether the number of a brain's genes may change
  bool bodies_differ = false;    ///< whether robots have bodies of their own
  bool inherits_bodies = false;  ///< whether these are inherited
  bool has_more_genes = false;   ///< whether genomes have a gait or a body, or brains grow
};

/// Two runs may be pooled as replicates if this is equal: 16 hexadecimal digits of rules, parameters, models and backend, not of
/// the seed, the duration and the number of threads. `models` is the text of the models' parameters.
[[nodiscard]] std::string fingerprint(const RunDescription& run, std::string_view models);

}  // namespace trophic::observe

#if TROPHIC_HEADER_ONLY
#include <trophic/observe/run_description.ipp>
#endif
