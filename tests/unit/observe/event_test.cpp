// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <set>
#include <trophic/observe/event.hpp>
#include <trophic/params/params.hpp>

using namespace trophic;

TEST_CASE("events: kind -> name in files") {
  using observe::EventKind;
  std::set<std::string_view> names;
  for (const EventKind kind :
       {EventKind::birth, EventKind::activation, EventKind::tag_switch, EventKind::capture, EventKind::death}) {
    CHECK(names.insert(enum_name(kind)).second);
  }
  CHECK(names == std::set<std::string_view>{"birth", "activation", "tag_switch", "catch", "death"});
}
