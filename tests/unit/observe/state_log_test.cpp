// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/backend/kinematic.hpp>
#include <trophic/death/senescence/energy_store.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/io/state_log.hpp>
#include <trophic/rules/paper.hpp>
#include <unit/observe/scene.hpp>

using namespace trophic;

TEST_CASE("state log: run -> a column per member of each State, a row per robot and tick") {
  using Rules = with_senescence<rules::Paper, death::senescence::EnergyStore>;
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "states.csv";
  Ecology<Rules> ecology{{}, backend::Kinematic::Params{}};
  io::StateLog log{path, ecology.state_columns()};
  ecology.run_until(4.0, log);
  const std::string text = test::content(path);
  CHECK(text.starts_with("time_s,tick,body,id,senescence.energy_J\n0,0,0,0,100\n"));
  CHECK(std::ranges::count(text, '\n') == 1 + 3 * 30);
  // prey graze 0.3 W and rest at 0.2 W: at most 0.2 J in a tick of 2 s, less what they walked
  const std::string row = text.substr(text.find("\n2,1,0,0,") + 9);
  const double energy_J = std::stod(row);
  CHECK(energy_J < 100.2);
  CHECK(energy_J > 99.0);
}
