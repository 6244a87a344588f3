// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <tools/reading/tables.hpp>
#include <trophic/params/params.hpp>
#include <unit/reading/rows.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("rows are cut into ticks, and found in one by individual or by body") {
  const std::vector<analysis::AgentRow> agents{robot(1, 7, prey, 0, 0), robot(1, 3, prey, 0, 0), robot(4, 3, prey, 5, 0)};
  const auto moments = analysis::by_tick(agents);
  REQUIRE(moments.size() == 2);
  CHECK(moments[0].size() == 2);
  CHECK(moments[1].front().tick == 4);
  const analysis::Moment first{moments[0]};
  CHECK(first.find(3) == &agents[1]);
  CHECK(first.find(7) == &agents[0]);
  CHECK(first.find(5) == nullptr);
  CHECK(first.find_body(3) == &agents[1]);
  CHECK(first.find_body(0) == nullptr);
  CHECK(analysis::by_tick({}).empty());
}

TEST_CASE("groups: origin and activity -> who belongs") {
  using analysis::Group;
  struct Case {
    Origin origin;
    bool active;
    std::vector<Group> groups;
  };
  const std::vector<Case> cases{
      {Origin::random, false, {Group::all, Group::random}},
      {Origin::random, true, {Group::all, Group::random, Group::active}},
      {Origin::inherited, false, {Group::all, Group::inherited}},
      {Origin::inherited, true, {Group::all, Group::inherited, Group::active, Group::inherited_active}},
  };
  for (const auto& [origin, active, groups] : cases) {
    for (std::size_t i = 0; i < enum_names(Group{}).size(); ++i) {
      const auto group = static_cast<Group>(i);
      CAPTURE(enum_name(group));
      CHECK(analysis::belongs(origin, active, group) == (std::ranges::find(groups, group) != groups.end()));
    }
  }
}

TEST_CASE("stretches end a number of ticks later, where the run has that tick") {
  const std::vector<analysis::AgentRow> agents{robot(1, 7, prey, 0, 0), robot(2, 7, prey, 0, 0), robot(4, 7, prey, 5, 0)};
  const auto all = analysis::stretches(agents, 2);
  REQUIRE(all.size() == 3);
  CHECK(all[0].end.empty());
  CHECK(all[1].end.front().tick == 4);
  CHECK(all[2].end.empty());
}
