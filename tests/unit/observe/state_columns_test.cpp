// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/io/state_columns.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

using namespace trophic;

namespace {

struct Keeper {
  static constexpr std::string_view name = "keeper";
  struct Inner {
    double b = 0.5;
    static constexpr auto fields() { return std::tuple{field("b", &Inner::b)}; }
  };
  struct State {
    std::int64_t a = 7;
    Inner inner = {};
    std::vector<double> list = {};
    std::optional<Ancestor> who = {};
    static constexpr auto fields() {
      return std::tuple{field("a", &State::a), field("inner", &State::inner), field("list", &State::list),
                        field("who", &State::who)};
    }
  };
  [[nodiscard]] State born(const Individual&, const State*, const State&) const { return {}; }
  [[nodiscard]] bool dies(const Individual&, const View&, Rng&) const { return false; }
};

}  // namespace

TEST_CASE("state columns: State -> SLOT.MEMBER, nested members by path") {
  RuleStates<with_senescence<rules::Paper, Keeper>> states;
  states.senescence.push_back({});
  states.senescence.push_back(
      {.a = -1, .inner = {.b = 0.25}, .list = {1.0, 2.5}, .who = Ancestor{.id = 12, .species = 0, .genome = {}}});
  const io::StateColumns columns = io::state_columns(states);
  CHECK(columns.columns == std::vector<io::TypedColumn>{{"senescence.a", "int64"},
                                                        {"senescence.inner.b", "double"},
                                                        {"senescence.list", "string"},
                                                        {"senescence.who", "int64"}});
  std::string row;
  columns.append(0, row);
  CHECK(row == ",7,0.5,,");
  row.clear();
  columns.append(1, row);
  CHECK(row == ",-1,0.25,1 2.5,12");
}

TEST_CASE("state columns: rule table -> slots in order, without states -> none") {
  const RuleStates<rules::Released> released;
  CHECK(io::state_columns(released).columns ==
        std::vector<io::TypedColumn>{{"parent.starved.body", "int64"},
                                     {"parent.starved.victim", "int64"},
                                     {"parent.sacrificed.killer", "int64"},
                                     {"starvation.exemption.adversary_distance_m", "double"}});
  const RuleStates<rules::Paper> paper;
  CHECK(io::state_columns(paper).columns.empty());
}
