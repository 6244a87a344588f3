// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/energy_auditor.hpp>
#include <support/temporary_folder.hpp>
#include <trophic/backend/torus.hpp>
#include <trophic/worlds/wolf_sheep.hpp>
#include <unit/checkpoint/resumed.hpp>

using namespace trophic;
using energy::order::Acts;

namespace {

constexpr Species sheep = 0, wolf = 1;

[[nodiscard]] Experiment<worlds::WolfSheep> meadow(Acts acts) {
  Experiment<worlds::WolfSheep> experiment{.seed = 3};
  experiment.ecology.duration_s = 120.0;
  experiment.rules.order.acts = acts;
  return experiment;
}

/// Counts events in a tick that come after one of a wolf's, and catches of sheep that were born in the same tick.
struct Turns {
  void on_event(const observe::Event& event, const View& view) {
    if (view.tick == 0) return;
    if (event.kind == observe::EventKind::activation) return;
    const bool is_caught = event.cause == Cause::caught;
    const bool is_sheeps = event.individual.species == sheep && !is_caught;
    if (view.tick != tick) wolves_acted = false;
    tick = view.tick;
    too_late += is_sheeps && wolves_acted ? 1 : 0;
    wolves_acted = wolves_acted || !is_sheeps;
    newborns_caught += is_caught && event.individual.born_s == view.time_s ? 1 : 0;
    starved_caught += is_caught && event.individual.energy_J < 0.0 ? 1 : 0;
  }
  std::int64_t tick = 0;
  bool wolves_acted = false;
  int too_late = 0, newborns_caught = 0, starved_caught = 0;
};

}  // namespace

TEST_CASE("order: by turns -> sheep eat, starve and reproduce before wolves catch, together -> they do not, both ledgers close") {
  for (const Acts acts : {Acts::in_turn, Acts::together}) {
    CAPTURE(enum_names(acts)[static_cast<std::size_t>(acts)]);
    Ecology<worlds::WolfSheep> ecology{meadow(acts), backend::Torus::Params{}};
    Turns turns;
    EnergyAuditor auditor;
    ecology.run_until(120.0, turns, auditor);
    CHECK((turns.too_late == 0) == (acts == Acts::in_turn));
    CHECK((turns.newborns_caught > 0) == (acts == Acts::in_turn));
    CHECK((turns.starved_caught == 0) == (acts == Acts::in_turn));
    CHECK(auditor.worst < 1e-9);
    CHECK(auditor.turned_over_J > 100.0);
  }
}

TEST_CASE("order: by turns, together by its parameter -> resumed to the byte, together -> as a table without the rule") {
  const test::TemporaryFolder folder;
  for (const Acts acts : {Acts::in_turn, Acts::together})
    test::check_resumed(meadow(acts), backend::Torus::Params{}, folder.path() / enum_name(acts), {20, 50, 51}, 20.0,
                        [](std::size_t, auto&) {});
  using Without = with_order<worlds::WolfSheep, energy::order::Together>;
  static_assert(is_neutral<Without, RuleSlot::order>);
  Ecology<Without> without{{.seed = 3}, backend::Torus::Params{}};
  Ecology<worlds::WolfSheep> with{meadow(Acts::together), backend::Torus::Params{}};
  Ecology<worlds::WolfSheep> turns{meadow(Acts::in_turn), backend::Torus::Params{}};
  without.run_until(60.0);
  with.run_until(60.0);
  turns.run_until(60.0);
  CHECK(std::ranges::equal(without.view().members, with.view().members));
  CHECK(without.view().robots.back().id == with.view().robots.back().id);
  CHECK_FALSE(std::ranges::equal(turns.view().members, with.view().members));
  CHECK(std::ranges::equal(without.view().poses, with.view().poses));
}
