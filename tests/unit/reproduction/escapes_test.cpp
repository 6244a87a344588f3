// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <support/hand_population.hpp>
#include <trophic/reproduction/parent/fastest_escape.hpp>
#include <trophic/reproduction/parent/last_escapee.hpp>
#include <trophic/reproduction/parent/most_escapes.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;
using reproduction::parent::FastestEscape;
using reproduction::parent::LastEscapee;
using reproduction::parent::MostEscapes;

namespace {

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

}  // namespace

TEST_CASE("most escapes: from within 3 m to beyond 5 m -> one escape, whatever the way between") {
  Walks<MostEscapes> walks{1};
  for (const double x_m : {4.0, 6.0, 3.0, 5.0, 4.0, 5.0}) walks.to({x_m});
  CHECK(walks.states()[1].escapes == 0);
  CHECK(walks.parent() == std::nullopt);
  walks.to({5.01});
  CHECK(walks.states()[1].escapes == 1);
  CHECK(walks.parent() == 1);
  walks.to({9.0});
  CHECK(walks.states()[1].escapes == 1);
}

TEST_CASE("most escapes: greatest number of escapes -> parent; equal numbers -> the closest") {
  Walks<MostEscapes> walks{2};
  walks.to({2.0, 2.5});
  walks.to({6.0, 7.0});
  CHECK(walks.parent() == 1);
  walks.to({6.0, 1.0});
  walks.to({6.0, 8.0});
  CHECK(walks.parent() == 2);
  walks.robots().individuals[2].active = false;
  CHECK(walks.parent() == 1);
  CHECK(walks.parent(predator) == std::nullopt);
}

TEST_CASE("most escapes: the pursuer died -> no escape; an inactive newborn -> not pursued") {
  Walks<MostEscapes> walks{2};
  walks.robots().individuals[2].active = false;
  walks.to({2.0, 2.0});
  walks.robots().individuals[0].id = 77;
  walks.robots().individuals[2].active = true;
  walks.to({9.0, 9.0});
  CHECK(walks.states()[1].escapes == 0);
  CHECK(walks.states()[1].pursuers.empty());
  CHECK(walks.states()[2].escapes == 0);
}

TEST_CASE("last escapee: the latest escape from the dying predator -> parent, not from another one") {
  Walks<LastEscapee> walks{3};
  walks.robots().individuals[3].species = predator;  // at 20 m, then close to prey 2
  walks.to({2.0, 2.0, 20.0});
  walks.to({6.0, 2.0, 20.0});
  CHECK(walks.parent() == 1);
  walks.to({6.0, 6.0, 20.0});
  CHECK(walks.parent() == 2);
  walks.to({6.0, 18.0, 20.0});
  walks.to({19.0, 12.0, 20.0});
  walks.to({6.0, 12.0, 20.0});  // prey 1 escapes from the other predator, after prey 2 did
  CHECK(walks.parent() == 2);
  walks.robots().individuals[0].id = 77;
  CHECK(walks.parent() == std::nullopt);
}

TEST_CASE("last escapee: two at one tick -> the closest; a dead predator -> forgotten at the next escape") {
  Walks<LastEscapee> walks{2};
  walks.to({2.0, 1.0});
  walks.to({8.0, 7.0});
  CHECK(walks.parent() == 2);
  walks.robots().individuals[0].id = 77;
  walks.to({2.0, 1.0});
  walks.to({8.0, 7.0});
  CHECK(walks.states()[1].hunters == std::vector<IndividualId>{77});
  CHECK(walks.parent() == 2);
}

TEST_CASE("fastest escape: greatest gain of distance within the window -> parent") {
  Walks<FastestEscape> walks{2, FastestEscape{{.window_ticks = 2}}};
  walks.to({1.0, 5.0});
  CHECK(walks.parent() == std::nullopt);
  walks.to({4.0, 5.5});
  CHECK(walks.parent() == 1);  // 3 m against 0.5 m
  walks.to({4.0, 6.0});
  CHECK(walks.parent() == 1);
  walks.to({4.0, 6.5});
  CHECK(walks.parent() == 2);  // 0 m against 1 m
  CHECK(walks.states()[1].x_m == std::vector<double>{4.0, 4.0, 4.0});
  walks.to({3.0, 1.0});
  walks.to({3.0, 1.0});
  CHECK(walks.parent() == std::nullopt);
}

TEST_CASE("fastest escape: a prey younger than the window -> its gain since birth") {
  Walks<FastestEscape> walks{1};
  walks.to({2.0});
  walks.to({3.0});
  CHECK(walks.parent() == 1);
}
