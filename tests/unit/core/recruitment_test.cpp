// SPDX-License-Identifier: MIT
// Births without a death, and the bodies for them.
#include <doctest/doctest.h>

#include <map>
#include <set>
#include <support/hand_population.hpp>
#include <support/temporary_folder.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/reproduction/parent/most_escapes.hpp>
#include <trophic/reproduction/recruitment/after_escapes.hpp>
#include <trophic/rules/by_species.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/with_ageing_victims.hpp>
#include <trophic/support/rule_error.hpp>

using namespace trophic;
using namespace trophic::test;
using reproduction::recruitment::AfterEscapes;

namespace {

using Recruiting = with_recruitment<rules::Paper, AfterEscapes>;

/// Follows who lives in which body, by events alone, and compares with the view.
struct Occupants {
  static BodyIndex body_of(const View& view, IndividualId id) {
    return static_cast<BodyIndex>(std::ranges::find(view.robots, id, &Individual::id) - view.robots.begin());
  }
  void on_event(const observe::Event& event, const View& view) {
    if (event.kind == observe::EventKind::birth) {
      CHECK(!occupants.contains(event.body));
      occupants[event.body] = event.individual.id;
      most = std::max(most, occupants.size());
      if (!event.individual.parent() || died_now.contains(event.body)) return;
      const BodyIndex parent = body_of(view, *event.individual.parent());
      CHECK(view.distance_m(event.body, parent) < 4.0 * view.robot_radius_m);
      CHECK(view.distance_m(event.body, parent) >= 2.0 * view.robot_radius_m);
      ++recruits;
      CHECK(event.individual.species == prey);
      CHECK(event.individual.origin == Origin::inherited);
      CHECK(event.individual.mutation_distance > 0.0);
    } else if (event.kind == observe::EventKind::death) {
      CHECK(occupants.at(event.body) == event.individual.id);
      occupants.erase(event.body);
      died_now.insert(event.body);
    }
  }
  void on_tick(const View& view) {
    died_now.clear();
    fewest = std::min(fewest, occupants.size());
    const std::size_t members = view.count(prey) + view.count(predator);
    CHECK(members == occupants.size());
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      const Individual& one = view.robots[body];
      CHECK(one.lives() == occupants.contains(body));
      if (one.lives()) CHECK(one.id == occupants.at(body));
      if (one.adversary) CHECK(view.robots[*one.adversary].lives());
    }
  }

  std::map<BodyIndex, IndividualId> occupants;
  std::set<BodyIndex> died_now;
  std::size_t most = 0;
  std::size_t fewest = 30;
  std::size_t recruits = 0;
};

/// Recruits as told.
struct Told {
  static constexpr std::string_view name = "told";
  static inline std::vector<reproduction::Recruit> births;
  static inline std::size_t spare = 1;
  [[nodiscard]] std::size_t spare_bodies() const { return spare; }
  [[nodiscard]] bool leaves_spare(const Vacancy&, const View&) const { return false; }
  [[nodiscard]] std::vector<reproduction::Recruit> recruits(const View&, Rng&) const { return births; }
};

std::string error_of(std::vector<reproduction::Recruit> births, std::size_t spare = 1) {
  Told::births = std::move(births);
  Told::spare = spare;
  return message_of<RuleError>([] {
    Ecology<with_recruitment<rules::Paper, Told>> ecology{{.seed = 1}, backend::Kinematic::Params{}};
    ecology.run_until(2.0);
  });
}

/// Remembers the deaths of others and its own offspring.
struct Mourner {
  static constexpr std::string_view name = "mourner";
  struct State {
    std::int64_t deaths = 0;
    std::int64_t offspring = 0;
    static constexpr auto fields() { return std::tuple{field("deaths", &State::deaths), field("offspring", &State::offspring)}; }
  };
  [[nodiscard]] State born(const Individual&, const State*, const State&) const { return {}; }
  void on_other_death(State& own, BodyIndex self, const Vacancy& death, const View& view) const {
    CHECK(death.body != self);
    CHECK(view.robots[self].lives());
    CHECK(view.robots[death.body].lives());
    CHECK(death.killer.has_value() == (death.cause == Cause::caught));
    ++own.deaths;
  }
  void on_offspring(State& own, BodyIndex self, BodyIndex newborn, const View& view) const {
    CHECK(view.robots[newborn].parent() == view.robots[self].id);
    ++own.offspring;
  }
  [[nodiscard]] bool dies(const Individual&, const View&, Rng&, const State&) const { return false; }
};

/// Counts the same from events.
template <class Rules>
struct Mourned {
  void on_event(const observe::Event& event, const View& view) {
    if (event.kind == observe::EventKind::death) {
      for (const Individual& one : view.robots) ++deaths[one.id];
      deaths.erase(event.individual.id);
    } else if (event.kind == observe::EventKind::birth) {
      if (event.individual.parent()) ++offspring[*event.individual.parent()];
    }
  }
  void on_tick(const View& view) {
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      const IndividualId id = view.robots[body].id;
      if (id == no_individual) continue;
      CHECK(ecology.states().senescence[body].deaths == deaths[id]);
      CHECK(ecology.states().senescence[body].offspring == offspring[id]);
      most = std::max(most, deaths[id] * offspring[id]);
    }
  }
  const Ecology<Rules>& ecology;
  std::map<IndividualId, std::int64_t> deaths = {};
  std::map<IndividualId, std::int64_t> offspring = {};
  std::int64_t most = 0;
};

/// Gives founders the number of their body and later newborns 1000 + their species.
struct NumberedGenome {
  static constexpr std::string_view name = "numbered_genome";
  void draw(std::span<double> weights, const Individual& newborn, Rng&) const {
    CHECK(newborn.genome == nullptr);
    const double number = newborn.born_s == 0.0 && newborn.id < 30 ? static_cast<double>(newborn.id)
                                                                   : 1000.0 + static_cast<double>(newborn.species);
    std::ranges::fill(weights, number);
  }
};

}  // namespace

TEST_CASE("recruitment: spare bodies -> founders in the other ones, births without a death, each body at most one individual") {
  Ecology<Recruiting> ecology{{.seed = 3}, backend::Kinematic::Params{}};
  const View start = ecology.view();
  CHECK(std::ranges::count_if(start.robots, &Individual::lives) == 24);
  CHECK(start.count(predator) == 14);
  for (BodyIndex body = 0; body < 30; ++body) {
    CHECK(start.robots[body].lives() == (body < 24));
    CHECK(start.robots[body].id == (body < 24 ? body : no_individual));
  }
  Occupants bodies;
  ecology.run_until(3000.0, bodies);
  CHECK(bodies.recruits > 5);
  CHECK(bodies.most > 24);
  CHECK(bodies.fewest >= 24);
}

TEST_CASE("recruitment: invalid birth -> error that names it") {
  CHECK(error_of({{.species = prey}}) == "");
  CHECK(error_of({{.species = 2}}).find("species") != std::string::npos);
  CHECK(error_of({{.species = prey, .place = GroundPose{.x_m = 10.5}}})
            .ends_with("a birth at (10.5, 0): must be finite and within +-10 m"));
  CHECK(error_of({{.species = prey, .endowment_J = -1.0}}).ends_with("endowment_J = -1: must be >= 0 and finite"));
  CHECK(error_of({{.species = prey, .endowment_J = std::nan("")}}).ends_with("endowment_J = nan: must be >= 0 and finite"));
  CHECK(error_of({{.species = prey, .endowment_J = 1.0}, {.species = prey, .endowment_J = 1.0}}) == "");
  CHECK(error_of({{.species = prey, .parents = {ancestor(1, predator)}}})
            .ends_with("individual 1 as a parent: must be of the newborn's species"));
  CHECK(error_of({{.species = prey, .parents = {ancestor(1, prey)}}})
            .ends_with("individual 1 as a parent: must have a genome of 15 weights"));
  CHECK(error_of({}, 30).ends_with("spare_bodies = 30: must be < 30, the number of robots"));
}

TEST_CASE("recruitment: at the tick of the first decisions -> no births, then births") {
  Told::births = {{.species = prey}};
  Told::spare = 25;
  struct FirstBirth {
    void on_event(const observe::Event& event, const View& view) {
      if (event.kind == observe::EventKind::birth && event.individual.id >= 5) at_s = std::min(at_s, view.time_s);
    }
    double at_s = 1e9;
  };
  for (const auto& [first_tick_s, expected_s] : {std::pair{0.0, 2.0}, {6.0, 8.0}, {5.0, 8.0}}) {
    Ecology<with_recruitment<rules::Paper, Told>>::Params params{.seed = 1};
    params.ecology.first_tick_s = first_tick_s;
    params.rules.community.predators = params.rules.minimum_predators.below = 0;
    Ecology<with_recruitment<rules::Paper, Told>> ecology{params, backend::Kinematic::Params{}};
    FirstBirth first;
    ecology.run_until(20.0, first);
    CHECK(first.at_s == expected_s);
  }
}

TEST_CASE("recruitment: table without it -> not named, no spare bodies") {
  static_assert(is_neutral<rules::Paper, RuleSlot::recruitment>);
  Ecology<rules::Paper> ecology{{.seed = 1}, backend::Kinematic::Params{}};
  for (const auto& [slot, policy] : ecology.describe(0.0).slots) CHECK(slot != "recruitment");
  for (const NamedParam& number : ecology.describe(0.0).named_params) CHECK_FALSE(number.path.starts_with("rules.recruitment"));
  CHECK(std::ranges::all_of(ecology.view().robots, &Individual::lives));
}

TEST_CASE("rule states: deaths of others and offspring -> hooks called, also with spare bodies") {
  using Rules = with_senescence<rules::Paper, Mourner>;
  Ecology<Rules> ecology{{.seed = 5}, backend::Kinematic::Params{}};
  Mourned<Rules> mourned{ecology};
  ecology.run_until(800.0, mourned);
  CHECK(mourned.most > 0);
  using Spare = with_recruitment<Rules, AfterEscapes>;
  Ecology<Spare> recruiting{{.seed = 5}, backend::Kinematic::Params{}};
  Mourned<Spare> also{recruiting};
  recruiting.run_until(800.0, also);
  CHECK(also.most > 0);
}

TEST_CASE("initial genome: newborn given -> id of a founder is its body, species known") {
  using Rules = with_initial_genome<rules::Paper, NumberedGenome>;
  Ecology<Rules> ecology{{.seed = 2}, backend::Kinematic::Params{}};
  for (BodyIndex body = 0; body < 30; ++body) {
    CHECK(ecology.view().robots[body].genome->weights[0] == static_cast<double>(body));
  }
  struct Newcomers {
    void on_event(const observe::Event& event, const View&) {
      if (event.kind != observe::EventKind::birth || event.individual.parent() || event.individual.id < 30) return;
      CHECK(event.individual.genome->weights[0] == 1000.0 + static_cast<double>(event.individual.species));
      ++seen;
    }
    std::size_t seen = 0;
  } newcomers;
  ecology.run_until(1000.0, newcomers);
  CHECK(newcomers.seen > 3);
}

TEST_CASE("by species: initial genomes -> numbers of the newborn's species") {
  using Rules = with_initial_genome<rules::Paper, rules::by_species<reproduction::initial_genome::UniformWeights>>;
  Ecology<Rules>::Params params{.seed = 8};
  params.rules.initial_genome.get<prey>().limit = 0.0;
  const Ecology<Rules> ecology{params, backend::Kinematic::Params{}};
  for (const Individual& one : ecology.view().robots) CHECK((one.genome->weights[0] == 0.0) == (one.species == prey));
}

TEST_CASE("ageing victims: prey at max_age -> die, most of their successors inherit from prey") {
  using Rules = with_ageing_victims<rules::Paper>;
  struct Ages {
    void on_event(const observe::Event& event, const View& view) {
      if (event.kind == observe::EventKind::death && event.cause == Cause::senescence) {
        CHECK(event.individual.species == prey);
        CHECK(view.age_s(event.individual) == doctest::Approx(600.0));
        aged = event.body;
        ++deaths;
      } else if (event.kind == observe::EventKind::birth && aged == event.body) {
        CHECK(event.individual.species == prey);
        inherited += event.individual.parent() ? 1U : 0U;
        aged.reset();
      }
    }
    std::optional<BodyIndex> aged;
    std::size_t deaths = 0;
    std::size_t inherited = 0;
  } ages;
  Ecology<Rules> ecology{{.seed = 4}, backend::Kinematic::Params{}};
  ecology.run_until(6000.0, ages);
  CHECK(ages.deaths > 20);
  CHECK(2 * ages.inherited > ages.deaths);
  static_assert(is_rule_table<with_ageing_victims<rules::Paper, reproduction::parent::MostEscapes>>);
}
