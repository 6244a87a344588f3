// SPDX-License-Identifier: MIT
// Any single rule of either table flipped into the other: where the policy differs with with_<slot>, where only numbers differ by
// them. Each compiles and runs.
#include <doctest/doctest.h>

#include <algorithm>
#include <concepts>
#include <string>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/load/habitat.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>
#include <utility>

using namespace trophic;

namespace {

struct Balance {
  void on_event(const observe::Event& event, const View&) {
    if (event.kind == observe::EventKind::birth) ++births;
    if (event.kind == observe::EventKind::death) ++deaths;
  }
  int births = 0;
  int deaths = 0;
};

/// Runs 300 s and tells with which policy in the slot and which fingerprint.
template <class Rules>
std::pair<std::string, std::string> run(typename Ecology<Rules, backend::Kinematic>::Params params, const std::string& slot) {
  Ecology<Rules, backend::Kinematic> ecology{std::move(params)};
  Balance balance;
  ecology.run_until(300.0, balance);
  CHECK(ecology.tick() == 150);
  CHECK(balance.deaths > 0);
  CHECK(balance.births == balance.deaths + 30);
  const observe::RunDescription described = ecology.describe(300.0);
  const auto found = std::ranges::find(described.slots, slot, &std::pair<std::string, std::string>::first);
  REQUIRE(found != described.slots.end());
  return {found->second, described.fingerprint};
}

}  // namespace

#define TROPHIC_FLIP(Slot, member, kind, Contract)                                                                    \
  template <class Base, class Other>                                                                                  \
  void flip_##member() {                                                                                              \
    constexpr bool same = std::same_as<typename Base::Slot, typename Other::Slot>;                                    \
    using Flipped = typename std::conditional_t<same, std::type_identity<Base>,                                       \
                                                std::type_identity<with_##member<Base, typename Other::Slot>>>::type; \
    typename Ecology<Flipped, backend::Kinematic>::Params params;                                                     \
    params.rules.member = RuleParams<Other>{}.member;                                                                 \
    CHECK(run<Flipped>(params, #member).first == Other::Slot::name);                                                  \
  }                                                                                                                   \
  TEST_CASE("slots: " #member " of either table in the other") {                                                      \
    flip_##member<rules::Paper, rules::Released>();                                                                   \
    flip_##member<rules::Released, rules::Paper>();                                                                   \
  }
TROPHIC_RULE_SLOTS(TROPHIC_FLIP)
#undef TROPHIC_FLIP

TEST_CASE("slots: the fingerprint tells rules and numbers apart, not seeds, durations and names") {
  using Paper = Ecology<rules::Paper, backend::Kinematic>;
  const auto fingerprint = [](auto params) { return Paper{std::move(params)}.describe(1.0).fingerprint; };
  const std::string paper = fingerprint(Paper::Params{});
  CHECK(fingerprint(Paper::Params{.seed = 77}) == paper);
  Paper::Params longer;
  longer.ecology.duration_s = 1.0;
  CHECK(fingerprint(longer) == paper);
  Paper::Params wider;
  wider.rules.capture.reach_m = 1.25;
  CHECK(fingerprint(wider) != paper);
  using Same = with_floor<rules::Paper, death::floor::VictimFloor>;
  CHECK(Ecology<Same, backend::Kinematic>{}.describe(1.0).fingerprint == paper);
  using Other = with_mutation<rules::Paper, reproduction::mutation::UniformMutation>;
  CHECK(Ecology<Other, backend::Kinematic>{}.describe(1.0).fingerprint != paper);
  Habitat quicker = load_habitat(Paper::Params{}.ecology);
  Paper::Params own_gait;
  own_gait.ecology.gait = quicker.gait.name;
  CHECK(Paper(own_gait, quicker).describe(1.0).fingerprint == paper);
  quicker.robot.walk.turn_rate_per_rad *= 1.1;
  CHECK(Paper(own_gait, quicker).describe(1.0).fingerprint != paper);
}
