// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/io/state_log.hpp>
#include <trophic/reproduction/parent/most_escapes.hpp>
#include <trophic/rules/paper.hpp>
#include <unit/observe/scene.hpp>

using namespace trophic;

TEST_CASE("state log: run -> a column for each member of each State, a row per robot and tick") {
  using Rules = with_parent_after<rules::Paper, Cause::starved, reproduction::parent::MostEscapes>;
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "states.csv";
  Ecology<Rules> ecology{{}, backend::Kinematic::Params{}};
  io::StateLog log{path, ecology.state_columns()};
  ecology.run_until(4.0, log);
  const std::string text = test::content(path);
  CHECK(text.starts_with("time_s,tick,body,id,parent.starved."));
  CHECK(text.find("\n0,0,0,0,") != std::string::npos);
  CHECK(std::ranges::count(text, '\n') == 1 + 3 * 30);
}
