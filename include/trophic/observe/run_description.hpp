// SPDX-License-Identifier: MIT
// The rules, parameters, seed and versions of a run, for observers and manifests.
#pragma once

#include <cstddef>
#include <optional>
#include <trophic/params/named_params.hpp>

namespace trophic::observe {

/// A parameter that differs from the rule table's.
struct OtherParam {
  std::string path;
  std::string value;
  std::string table;  ///< the table's own value
};

/// A parameter that changed during the run.
struct ParameterChange {
  double time_s = 0.0;    ///< time by the ecology's clock; the change acts on all later ticks
  std::int64_t tick = 0;  ///< index of the last tick before the change
  std::string number = {};
  std::string value = {};
  std::string before = {};
  static constexpr auto saved() {
    return std::tuple{&ParameterChange::time_s, &ParameterChange::tick, &ParameterChange::number, &ParameterChange::value,
                      &ParameterChange::before};
  }
};

/// The moment of another run at which a run starts, as texts.
struct Branch {
  std::string run;
  std::string at_s;
  std::string seed;
  std::string fingerprint;
};

/// Everything that determines a run's results.
struct RunDescription {
  std::string rules;                                       ///< name of the rule table
  std::vector<std::pair<std::string, std::string>> slots;  ///< (slot, policy name) for every slot
  NamedParams named_params;                                ///< every parameter with its path: "rules.tag_switch.cool_down_s"
  std::vector<int> tags;                                   ///< the tags that the table's brain can choose
  std::vector<std::string> inputs = {};                    ///< the brain's inputs, by sensor name
  std::vector<std::string> outputs = {};  ///< the brain's outputs, by act; empty in a table with the paper's acts
  std::string backend;                    ///< name and version of the engine
  std::vector<std::string> remarks;       ///< remarks on parameters without effect and limits of the engine
  std::uint64_t seed = 0;
  double tick_s = 0.0;                            ///< length of a tick, seconds of the ecology's clock
  double clock_scale = 1.0;                       ///< simulated seconds per second of the ecology's clock
  double until_s = 0.0;                           ///< the end of this run, seconds of the ecology's clock
  std::string fingerprint;                        ///< see `fingerprint`
  std::vector<OtherParam> other_params = {};      ///< parameters that differ from the table's; without seed, duration and threads
  std::vector<ParameterChange> changes = {};      ///< in the order in which they were made
  std::optional<Branch> branch = std::nullopt;    ///< empty for a run from time 0
  std::size_t spare_bodies = 0;                   ///< bodies that start without an individual
  std::vector<std::string> traits = {};           ///< names of the traits of the rule Traits
  bool several_parents = false;                   ///< whether the rule Recruitment may name several parents of a birth
  bool has_energy = false;                        ///< whether there is a rule Metabolism
  bool has_resource = false;                      ///< whether there is a rule Resource
  std::optional<std::size_t> brain_weights = {};  ///< weights of the largest brain of a species; empty if brains grow
  bool bodies_differ = false;                     ///< whether robots have their own bodies
  bool inherits_bodies = false;                   ///< whether these are inherited
  bool has_more_genes = false;                    ///< whether genomes have a gait or a body, or brains grow
};

/// Whether a different value of a parameter makes it a different experiment: all but the seed, duration, ends_when and the number
/// of threads.
[[nodiscard]] bool makes_another_experiment(std::string_view path);

/// 16 hexadecimal digits, a hash of rules, parameters, models and backend at the start, without the seed, the duration and the
/// number of threads. `models` is the text of the models' parameters.
[[nodiscard]] std::string fingerprint(const RunDescription& run, std::string_view models);

/// The parameters of a run that differ from those of its table, except for seed, duration and threads.
[[nodiscard]] std::vector<OtherParam> other_params(const NamedParams& own, const NamedParams& table);

/// Changes that had an effect, by tick and parameter: for each tick the last value of a parameter, unless it equals the value
/// before the tick.
[[nodiscard]] std::vector<ParameterChange> effective(std::vector<ParameterChange> changes);

/// Two runs may be pooled as replicates if this is equal: the fingerprint and, if parameters changed during the run or it started
/// from another one, "+" and 8 hexadecimal digits of those changes and that moment.
[[nodiscard]] std::string identity(const RunDescription& run);

/// Short name of a run's rules: the table's name with the differing parameters in parentheses: "paper (capture.reach_m 0.5 at 100
/// s)".
[[nodiscard]] std::string short_name(const RunDescription& run);

/// The same as a part of a sentence: "rule table `paper` and its parameters; begins at 700 s of runs/a (seed 7)".
[[nodiscard]] std::string sentence(const RunDescription& run);

}  // namespace trophic::observe

#if TROPHIC_HEADER_ONLY
#include <trophic/observe/run_description.ipp>
#endif
