// SPDX-License-Identifier: MIT
// The rules, parameters, seed and versions of a run, for observers and manifests.
#pragma once

#include <cstddef>
#include <optional>
#include <trophic/params/named_params.hpp>

namespace trophic::observe {

/// A parameter that is not the rule table's.
struct OtherParam {
  std::string path;
  std::string value;
  std::string table;  ///< the table's own value
};

/// A parameter that another value replaced during the run.
struct ParameterChange {
  double time_s = 0.0;    ///< the ecology's clock; it acts on all ticks after that moment
  std::int64_t tick = 0;  ///< number of the last tick before it
  std::string number = {};
  std::string value = {};
  std::string before = {};
  static constexpr auto saved() {
    return std::tuple{&ParameterChange::time_s, &ParameterChange::tick, &ParameterChange::number, &ParameterChange::value,
                      &ParameterChange::before};
  }
};

/// The moment of another run at which a run begins, as texts.
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
  std::vector<int> tags;                                   ///< the tags that the table's brain may choose
  std::vector<std::string> inputs = {};                    ///< the brain's inputs, by sensor name
  std::vector<std::string> outputs = {};                   ///< the brain's outputs, by act; empty in a table with the paper's
  std::string backend;                                     ///< name and version of the engine
  std::vector<std::string> remarks;                        ///< parameters without effect, flaws of the engine
  std::uint64_t seed = 0;
  double tick_s = 0.0;                            ///< ecology seconds
  double clock_scale = 1.0;                       ///< simulated seconds per ecology second
  double until_s = 0.0;                           ///< the end of this run, ecology seconds
  std::string fingerprint;                        ///< see `fingerprint`
  std::vector<OtherParam> other_params = {};      ///< parameters that are not the table's; without seed, duration and threads
  std::vector<ParameterChange> changes = {};      ///< in the order in which they were made
  std::optional<Branch> branch = std::nullopt;    ///< none of a run from time 0
  std::size_t spare_bodies = 0;                   ///< bodies that start without an individual
  std::vector<std::string> traits = {};           ///< names of the rule Traits
  bool several_parents = false;                   ///< whether the rule Recruitment may name several of a birth
  bool has_energy = false;                        ///< whether there is a rule Metabolism
  bool has_resource = false;                      ///< whether there is a rule Resource
  std::optional<std::size_t> brain_weights = {};  ///< of the largest brain of a species; none if brains grow
  bool bodies_differ = false;                     ///< whether robots have bodies of their own
  bool inherits_bodies = false;                   ///< whether these are inherited
  bool has_more_genes = false;                    ///< whether genomes have a gait or a body, or brains grow
};

/// Whether the results of a parameter's other value are those of another experiment: not of the seed, of duration and
/// ends_when, and of the number of threads.
[[nodiscard]] bool makes_another_experiment(std::string_view path);

/// 16 hexadecimal digits of rules, parameters, models and backend at the start, not of the seed, the duration and the number of
/// threads. `models` is the text of the models' parameters.
[[nodiscard]] std::string fingerprint(const RunDescription& run, std::string_view models);

/// The parameters of a run that are not those of its table, but for seed, duration and threads.
[[nodiscard]] std::vector<OtherParam> other_params(const NamedParams& own, const NamedParams& table);

/// Changes that had an effect, by tick and parameter: of each tick the last value of a parameter, unless it is the first one.
[[nodiscard]] std::vector<ParameterChange> effective(std::vector<ParameterChange> changes);

/// Two runs may be pooled as replicates if this is equal: the fingerprint and, if parameters changed during the run or it
/// began from another one, "+" and 8 hexadecimal digits of those changes and that moment.
[[nodiscard]] std::string identity(const RunDescription& run);

/// Short name of a run's rules: the table's, with what differs from it in brackets: "paper (capture.reach_m 0.5 at 100 s)".
[[nodiscard]] std::string short_name(const RunDescription& run);

/// The same as a part of a sentence: "rule table `paper` and its parameters; begins at 700 s of runs/a (seed 7)".
[[nodiscard]] std::string sentence(const RunDescription& run);

}  // namespace trophic::observe

#if TROPHIC_HEADER_ONLY
#include <trophic/observe/run_description.ipp>
#endif
