// SPDX-License-Identifier: MIT
// Worlds in which energy is owned once and numbers change.
#include <doctest/doctest.h>

#include <map>
#include <support/energy_auditor.hpp>
#include <support/hand_population.hpp>
#include <support/temporary_folder.hpp>
#include <tools/reading/read_history.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/backend/torus.hpp>
#include <trophic/rules/with_ageing_victims.hpp>
#include <trophic/worlds/mating_zones.hpp>
#include <trophic/worlds/pond.hpp>
#include <trophic/worlds/two_foods.hpp>
#include <unit/checkpoint/resumed.hpp>

using namespace trophic;
using namespace trophic::test;
using worlds::Pond;

namespace {

/// Counts lives.
struct Lives {
  void on_event(const observe::Event& event, const View& view) {
    if (event.kind == observe::EventKind::birth && event.individual.born_s > 0.0) {
      births += 1;
      with_parent += event.individual.parents.empty() ? 0U : 1U;
      most_parents = std::max(most_parents, event.individual.parents.size());
    }
    if (event.kind == observe::EventKind::death) ++deaths[std::string{enum_name(*event.cause)}];
    most = std::max(most, view.count(prey) + view.count(predator));
  }
  void on_tick(const View& view) {
    refused = view.refused_births;
    fewest = std::min(fewest, view.count(prey) + view.count(predator));
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      for (const BodyIndex near : view.within(view.poses[body], 3.0)) CHECK(view.robots[near].lives());
      if (view.robots[body].adversary) CHECK(view.robots[*view.robots[body].adversary].lives());
    }
  }
  std::size_t births = 0;
  std::size_t with_parent = 0;
  std::size_t most_parents = 0;
  std::size_t most = 0;
  std::size_t fewest = 1000;
  std::uint64_t refused = 0;
  std::map<std::string, std::size_t> deaths;
};

/// Distances of newborns, over the edges of a torus, in radii of a robot.
struct Neighbours {
  void on_event(const observe::Event& event, const View& view) {
    if (event.kind != observe::EventKind::birth || event.individual.parents.empty()) return;
    for (BodyIndex other = 0; other < view.robots.size(); ++other) {
      if (other == event.body || !view.robots[other].lives()) continue;
      const double radii = view.distance_m(event.body, other) / view.robot_radius_m;
      nearest_radii = std::min(nearest_radii, radii);
      if (view.robots[other].id != event.individual.parents.front()) continue;
      farthest_radii = std::max(farthest_radii, radii);
      across += distance_m(view.poses[event.body], view.poses[other]) > view.arena.half_side_m ? 1U : 0U;
    }
  }
  std::size_t across = 0;
  double nearest_radii = 100.0;
  double farthest_radii = 0.0;  ///< of a parent
};

/// The cold kills one in a thousand, by a name of its own.
struct Cold {
  static constexpr std::string_view name = "cold";
  static constexpr std::string_view cause = "frost";
  [[nodiscard]] bool dies(const Individual&, const View&, Rng& rng) const { return rng.chance(0.001); }
};

/// Parents give a shell to their young, whatever these inherit.
struct Shells {
  static constexpr std::string_view name = "shells";
  struct State {
    std::int64_t shells = 0;
    std::int64_t inherited = 0;
    static constexpr auto fields() { return std::tuple{field("shells", &State::shells), field("inherited", &State::inherited)}; }
  };
  [[nodiscard]] State born(const Individual& newborn, const State* parent, const State&) const {
    return {.shells = newborn.born_s == 0.0 ? 5 : 0, .inherited = parent ? 1 : 0};
  }
  void hand_over(State& own, State& newborn, const View&) const {
    own.shells -= 1;
    newborn.shells += 1;
  }
  [[nodiscard]] bool dies(const Individual&, const View&, Rng&, const State&) const { return false; }
};

/// Bites more than there is.
struct Greedy : energy::metabolism::GrazingAndHunting {
  static constexpr std::string_view name = "greedy";
  [[nodiscard]] double bite_J(BodyIndex, std::size_t, double there_J, const View&) const { return there_J + 1.0; }
};

/// Robots that cannot come and go.
class Fixed : public backend::Kinematic {
 public:
  static constexpr std::string_view name = "fixed";
  struct Params {
    using Backend = Fixed;
    static constexpr auto fields() { return std::tuple{}; }
  };
  Fixed(const RobotModel& robot, const Arena& arena, std::span<const Pose> starts, const Physics& physics, const Params&)
      : Kinematic{robot, arena, starts, physics, {}} {}

 private:
  using Kinematic::take_away;
};

/// Each death leaves 1 J where it happens.
struct Carrion {
  static constexpr std::string_view name = "carrion";
  [[nodiscard]] ResourceField start(const Arena& arena, Rng&) const { return {arena, 4}; }
  void grow(ResourceField&, const View&, Rng&) const {}
  void on_death(ResourceField& field, const Vacancy& death, double, const View& view) const {
    field.food_J(field.cell_at(view.poses[death.body])) += 1.0;
  }
};

/// Successors follow the dead at once, as in the paper, and still all energy is accounted for.
using PaperWithEnergy = with_metabolism<rules::Paper, energy::metabolism::GrazingAndHunting>;
using ColdPond = with_senescence<Pond, Cold>;

template <class Rules>
[[nodiscard]] Experiment<Rules> short_pond(std::uint64_t seed = 1) {
  Experiment<Rules> experiment{.seed = seed};
  experiment.ecology.duration_s = 800.0;
  return experiment;
}

}  // namespace

TEST_CASE_TEMPLATE("living: ledger of energy -> closes for each species and food at every tick", Rules, Pond, ColdPond,
                   PaperWithEnergy, worlds::TwoFoods) {
  Ecology<Rules> ecology{short_pond<Rules>(), backend::Kinematic::Params{}};
  EnergyAuditor auditor;
  ecology.run_until(1000.0, auditor);
  CHECK(auditor.worst < 1e-9);
  CHECK(auditor.turned_over_J > 100.0);
}

TEST_CASE("living: numbers change -> births without deaths, deaths without births, no search finds the dead") {
  Ecology<Pond> ecology{short_pond<Pond>(), backend::Kinematic::Params{}};
  Lives lives;
  ecology.run_until(1500.0, lives);
  CHECK(lives.births > 20);
  CHECK(lives.with_parent == lives.births);
  CHECK(lives.deaths["starved"] > 5);
  CHECK(lives.deaths["caught"] > 5);
  CHECK(lives.most > lives.fewest + 10);
  CHECK(lives.most <= 150);
}

TEST_CASE("living: births without a free body -> counted, not made") {
  auto experiment = short_pond<Pond>();
  experiment.rules.recruitment.spare_bodies = 1;
  experiment.rules.recruitment.birth_J = 31.0;
  Ecology<Pond> ecology{experiment, backend::Kinematic::Params{}};
  Lives lives;
  ecology.run_until(300.0, lives);
  CHECK(lives.refused > 0);
  CHECK(lives.most <= 150);
}

TEST_CASE("living: births on a torus -> next to the parent over the edges too, free of others over the edges") {
  Ecology<Pond> ecology{short_pond<Pond>(), backend::Torus::Params{.speed_m_s = 0.2}};
  Neighbours neighbours;
  ecology.run_until(1500.0, neighbours);
  CHECK(neighbours.across > 0);
  CHECK(neighbours.farthest_radii < 4.0);
  CHECK(neighbours.nearest_radii >= 2.0);
}

TEST_CASE(
    "living: mating zones -> energy from parents and from outside in the ledger, used zones move, a full world ends the run") {
  using worlds::MatingZones;
  struct Zones {
    void on_event(const observe::Event& event, const View& view) {
      if (event.kind != observe::EventKind::birth || event.individual.parents.empty()) return;
      births += 1;
      CHECK(event.individual.parents.size() == 2);
      CHECK(event.individual.energy_J == doctest::Approx(100.0));
      CHECK(zones_in(view).size() == 40);
    }
    void on_tick(const View& view) {
      std::vector<std::size_t> now;
      for (const MatingZone& zone : zones_in(view)) now.push_back(zone.cell);
      if (view.tick > 0 && births == before) CHECK(now == cells);
      if (births > before) CHECK(now != cells);
      before = births;
      cells = now;
      living = view.count(0);
    }
    std::size_t births = 0;
    std::size_t before = 0;
    std::size_t living = 0;
    std::vector<std::size_t> cells;
  };
  Experiment<MatingZones> experiment{.seed = 1};
  experiment.rules.resource.zones = 40;
  experiment.rules.resource.food_W = 1.0;
  Ecology<MatingZones> ecology{experiment, backend::Torus::Params{.speed_m_s = 0.04}};
  EnergyAuditor auditor;
  Zones zones;
  ecology.run_until(6000.0, auditor, zones);
  CHECK(auditor.worst < 1e-9);
  CHECK(zones.births >= 70);
  CHECK(zones.living == 100);
  CHECK(ecology.view().is_over);
  CHECK(ecology.time_s() < 6000.0);
  CHECK(observe::end_text(ecology.view()) == "no spare body");
}

TEST_CASE("living: cause that a rule names -> in events, counts and parents' rules") {
  Ecology<ColdPond> ecology{short_pond<ColdPond>(), backend::Kinematic::Params{}};
  Lives lives;
  observe::Tally tally;
  ecology.run_until(800.0, lives, tally);
  CHECK(lives.deaths["frost"] > 5);
  CHECK(lives.deaths.count("senescence") == 0);
  CHECK(tally.deaths(cause_named("frost")) == lives.deaths["frost"]);
  CHECK(tally.deaths_by_cause().back() == std::pair<std::string, std::size_t>{"frost", lives.deaths["frost"]});
  CHECK(cause_named("starved") == Cause::starved);
  CHECK_THROWS_AS(static_cast<void>(cause_named("Not a name")), std::invalid_argument);
}

TEST_CASE("living: what parents hand over -> in the shadow too, where nothing is inherited") {
  using Rules = with_senescence<Pond, Shells>;
  struct Count {
    void on_event(const observe::Event& event, const View&) {
      if (event.kind != observe::EventKind::birth || event.individual.parents.empty()) return;
      const auto& own = ecology.states().senescence[event.body];
      CHECK(own.shells == 1);
      inherited += own.inherited;
      received_J += event.individual.energy_J;
      ++births;
    }
    const Ecology<Rules>& ecology;
    std::int64_t inherited = 0;
    double received_J = 0.0;
    std::int64_t births = 0;
  };
  for (const Null null : {Null::none, Null::shadow}) {
    Ecology<Rules> ecology{under(null, short_pond<Rules>()), backend::Kinematic::Params{}};
    Count count{ecology};
    ecology.run_until(800.0, count);
    REQUIRE(count.births > 10);
    CHECK(count.inherited == (null == Null::none ? count.births : 0));
    CHECK(count.received_J / static_cast<double>(count.births) >= 30.0);  // half of what a parent needs for a birth
  }
}

TEST_CASE("living: deaths in a table without a rule Metabolism -> the resource hears of each") {
  Ecology<with_resource<rules::Paper, Carrion>> ecology{{.seed = 1}, backend::Kinematic::Params{}};
  observe::Tally tally;
  ecology.run_until(1000.0, tally);
  REQUIRE(tally.deaths() > 10);
  CHECK(ecology.view().foods.front().total_J() == doctest::Approx(static_cast<double>(tally.deaths())));
}

TEST_CASE("living: energy that a rule takes from nowhere -> error that names value and bound") {
  using Rules = with_metabolism<Pond, Greedy>;
  CHECK(message_of<RuleError>([] {
          Ecology<Rules> ecology{short_pond<Rules>(), backend::Kinematic::Params{}};
          ecology.run_until(10.0);
        }).starts_with("the policy in rules.metabolism returned bite_J = "));
}

TEST_CASE("living: backend whose robots cannot come and go -> refused before the run") {
  CHECK(message_of<std::invalid_argument>([] {
          Ecology<Pond>{short_pond<Pond>(), Fixed::Params{}};
        }) ==
        "rules.recruitment = at_energy on backend fixed: must be a backend that adds and removes robots (Placing in "
        "backend/contract.hpp)");
}

TEST_CASE("living: species that is gone -> ends the run where ecology.ends_when says so, which is then complete") {
  using enum EndsWhen;
  const auto manifest_of = [](EndsWhen ends_when, Null null) {
    const TemporaryFolder folder;
    auto experiment = under(null, short_pond<Pond>());
    experiment.ecology.ends_when = ends_when;
    experiment.ecology.duration_s = 300.0;
    experiment.rules.metabolism.get<predator>().resting_W = 1.0;  // who eats nothing lives for half a minute
    experiment.rules.metabolism.get<predator>().efficiency = 0.0;
    if (null == Null::neutral) {
      run_part(under(Null::none, experiment), backend::Kinematic::Params{}, folder.path() / "repeated", never, 5.0);
      experiment.history = replicates::read_history(folder.path() / "repeated");
    }
    run_part(experiment, backend::Kinematic::Params{}, folder.path() / "run", 10, 5.0);
    run_part(experiment, backend::Kinematic::Params{}, folder.path() / "run", never, 5.0);
    const Ecology<Pond> again{experiment, backend::Kinematic::Params{}};
    CHECK(checkpoint::run_state_in(folder.path() / "run", again.describe(300.0)).complete);
    return parse_json(content(folder.path() / "run" / "manifest.json"));
  };
  for (const Null null : {Null::none, Null::shadow, Null::neutral, Null::clones}) {
    for (const EndsWhen early : {a_species_is_gone, one_species_is_left}) {
      const auto manifest = manifest_of(early, null);
      CHECK(manifest["status"] == Json("complete"));
      CHECK(manifest["result"]["ended"] == Json("gone: predator"));
      CHECK(manifest["result"]["reached_s"].get<double>() < 100.0);
    }
  }
  const auto whole = manifest_of(time_is_up, Null::none);
  CHECK(whole["result"]["reached_s"] == Json(300.0));
  CHECK_FALSE(whole["result"].contains("ended"));
}
