// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <map>
#include <set>
#include <support/hand_population.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/death/senescence/energy_store.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/reproduction/parent/nearest_conspecific.hpp>
#include <trophic/rules/paper.hpp>

using namespace trophic;
using death::senescence::EnergyStore;
using test::predator;
using test::prey;

namespace {

using Hungry =
    with_parent_after<with_senescence<rules::Paper, EnergyStore>, Cause::senescence, reproduction::parent::NearestConspecific>;
using Kinematics = Ecology<Hungry>;

/// Keeps everybody's account from what it sees of the run, and holds it against the rule's own.
struct Ledger {
  explicit Ledger(const Kinematics& run) : ecology{run} {}

  [[nodiscard]] double energy_J(BodyIndex body) const { return ecology.states().senescence[body].energy_J; }

  void on_event(const observe::Event& event, const View& view) {
    if (event.kind == observe::EventKind::birth) {
      CHECK(energy_J(event.body) == numbers.start_J);
      account_J[event.individual.id] = numbers.start_J;
    }
    if (event.kind == observe::EventKind::capture) {
      ++catches;
      walk(event.body, view);
      double& account = account_J[event.individual.id];
      account = std::min(account + numbers.meal_J, numbers.capacity_J);
    }
    if (event.kind == observe::EventKind::death) {
      walk(event.body, view);
      CHECK(energy_J(event.body) == account_J[event.individual.id]);
      CHECK((event.cause == Cause::senescence) == (energy_J(event.body) <= 0.0 && event.cause != Cause::caught));
      ++deaths[*event.cause];
    }
  }

  void on_tick(const View& view) {
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      walk(body, view);
      CHECK(energy_J(body) == account_J[view.robots[body].id]);
      CHECK(energy_J(body) > 0.0);
      CHECK(energy_J(body) <= numbers.capacity_J);
    }
    before.assign(view.poses.begin(), view.poses.end());
    walked.clear();
  }

  /// The cost of this tick, once for whoever was there when the bodies moved.
  void walk(BodyIndex body, const View& view) {
    if (before.empty() || !walked.insert(body).second) return;
    const Individual& self = view.robots[body];
    if (self.born_s == view.time_s) return;
    const double grazing_W = view.web.hunts(self.species) ? 0.0 : numbers.grazing_W;
    const double gain_J =
        (grazing_W - numbers.resting_W) * view.tick_s - numbers.walking_J_per_m * distance_m(before[body], view.poses[body]);
    double& account = account_J[self.id];
    account = std::min(account + gain_J, numbers.capacity_J);
  }

  const Kinematics& ecology;
  EnergyStore::Params numbers = ecology.params().rules.senescence;
  std::map<IndividualId, double> account_J;
  std::set<BodyIndex> walked;  ///< at this tick
  std::vector<GroundPose> before;
  std::map<Cause, std::size_t> deaths;
  std::size_t catches = 0;
};

}  // namespace

TEST_CASE("energy store: walking and resting -> less, catches and grazing -> more, up to the capacity") {
  const EnergyStore rule{
      {.start_J = 10.0, .capacity_J = 12.0, .walking_J_per_m = 2.0, .resting_W = 0.5, .grazing_W = 1.0, .meal_J = 5.0}};
  const test::HandPopulation robots{{{.species = predator}, {.species = prey}}};
  auto own = rule.born(robots.individuals[0], nullptr, {.energy_J = 1.0});
  CHECK(own.energy_J == 10.0);
  rule.on_walk(own, 0, 1.5, robots.view());
  CHECK(own.energy_J == 6.0);  // 10 - 2 * 1.5 - 0.5 * 2
  rule.on_catch(own, 0, 1, robots.view());
  CHECK(own.energy_J == 11.0);
  rule.on_catch(own, 0, 1, robots.view());
  CHECK(own.energy_J == 12.0);
  auto grazing = rule.born(robots.individuals[1], nullptr, {});
  rule.on_walk(grazing, 1, 0.0, robots.view());
  CHECK(grazing.energy_J == 11.0);  // 10 + (1 - 0.5) * 2
}

TEST_CASE("energy store: energy reaches zero -> dies, not before") {
  const EnergyStore rule;
  const test::HandPopulation robots{{{.species = predator}}};
  Rng rng{1, Stream::senescence};
  CHECK(rule.dies(robots.individuals[0], robots.view(), rng, {.energy_J = 0.0}));
  CHECK_FALSE(rule.dies(robots.individuals[0], robots.view(), rng, {.energy_J = 1e-9}));
}

TEST_CASE("energy store: whole run -> energy balance holds, empty stores die") {
  Kinematics::Params params{.seed = 3};
  params.rules.capture.reach_m = 2.0;
  Kinematics ecology{params, backend::Kinematic::Params{}};
  Ledger ledger{ecology};
  ecology.run_until(4000.0, ledger);
  CHECK(ledger.catches > 20);
  CHECK(ledger.deaths[Cause::senescence] > 20);
  CHECK(ledger.deaths[Cause::caught] == ledger.catches);
  CHECK(ledger.deaths[Cause::starved] > 20);
}
