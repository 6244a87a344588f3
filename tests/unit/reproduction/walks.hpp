// SPDX-License-Identifier: MIT
// A predator and prey that walk by hand, for parent rules that remember.
#pragma once

#include <support/hand_population.hpp>
#include <trophic/reproduction/parent/contract.hpp>

namespace trophic::test {

/// A rule with the states of all robots: the first is a predator at the origin, the others are prey on the x axis.
template <class Rule>
class Walks {
 public:
  explicit Walks(std::size_t prey_count, const Rule& rule = {}) : rule_{rule}, robots_{with_predators(1, prey_count + 1)} {
    for (const Individual& one : robots_.individuals) states_.push_back(rule_.born(one, nullptr, {}));
  }

  HandPopulation& robots() { return robots_; }
  const std::vector<typename Rule::State>& states() const { return states_; }

  /// A tick later the prey stand at these x.
  void to(const std::vector<double>& x_m) {
    robots_.at_tick(robots_.tick + 1);
    for (std::size_t i = 0; i < x_m.size(); ++i) robots_.poses[i + 1].x_m = x_m[i];
    for (BodyIndex body = 0; body < states_.size(); ++body) rule_.on_walk(states_[body], body, 0.0, robots_.view());
  }

  /// The predator starves.
  std::optional<IndividualId> parent(std::optional<Species> successor = {}) {
    Rng rng{1, Stream::parent};
    const auto found = rule_.parent({.body = 0, .cause = Cause::starved, .successor = successor}, robots_.view(), rng, states_);
    return found ? std::optional{found->id} : std::nullopt;
  }

 private:
  Rule rule_;
  HandPopulation robots_;
  std::vector<typename Rule::State> states_;
};

}  // namespace trophic::test
