// SPDX-License-Identifier: MIT
// The ecology of an invalid rule table: empty, so that the only compile error is the one about the table.
#pragma once

#include <trophic/backend/backend_choice.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/rules/check.hpp>
#include <trophic/rules/params.hpp>

namespace trophic {

template <class Rules, bool is_table = is_rule_table<Rules>>
class Ecology;

/// Has the interface of an ecology but no definitions: a program that uses it does not compile.
template <class Rules>
class Ecology<Rules, false> final : public Simulation {
  static_assert(sizeof(RuleParams<Rules>) > 0);  // reports the error in the table

 public:
  using Params = Experiment<Rules>;
  Ecology(const Params& params, const BackendChoice& backend);
  Ecology(const Params& params, const BackendChoice& backend, const Habitat& habitat);
  void persist(Archive& archive) override;
  [[nodiscard]] double time_s() const override;
  [[nodiscard]] std::int64_t tick() const override;
  [[nodiscard]] const Params& params() const;
  [[nodiscard]] const Habitat& habitat() const;
  [[nodiscard]] const AnyBackend& backend() const override;
  [[nodiscard]] View view() const override;
  [[nodiscard]] observe::RunDescription describe(double until_s) const override;
  [[nodiscard]] io::StateColumns state_columns() const override;

 private:
  void run(double until_s, observe::Audience& audience) override;
};

}  // namespace trophic
