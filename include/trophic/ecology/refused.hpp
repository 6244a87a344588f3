// SPDX-License-Identifier: MIT
// The ecology of a table that does not compile: nothing, so that what is wrong with the table is the only error.
#pragma once

#include <cstdint>
#include <trophic/backend/contract.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/population/view.hpp>
#include <trophic/rules/check.hpp>
#include <trophic/rules/params.hpp>

namespace trophic {

template <class Rules, Backend B, bool is_table = is_rule_table<Rules>>
class Ecology;

/// Takes what an ecology takes and has no definitions: a program never gets as far.
template <class Rules, Backend B>
class Ecology<Rules, B, false> {
  static_assert(sizeof(RuleParams<Rules>) > 0);  // says what is wrong with the table

 public:
  using Params = Experiment<Rules, B>;
  explicit Ecology(const Params& params = {});
  Ecology(const Params& params, const Habitat& habitat);
  template <class... Observers>
  void run_until(double until_s, Observers&&... observers);
  template <class Archive>
  void persist(Archive& archive);
  [[nodiscard]] double time_s() const;
  [[nodiscard]] std::int64_t tick() const;
  [[nodiscard]] const Params& params() const;
  [[nodiscard]] const Habitat& habitat() const;
  [[nodiscard]] const B& backend() const;
  [[nodiscard]] View view() const;
  [[nodiscard]] observe::RunDescription describe(double until_s) const;
};

}  // namespace trophic
