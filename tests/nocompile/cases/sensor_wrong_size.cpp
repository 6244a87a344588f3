// SPDX-License-Identifier: MIT
// A sensor that gives another number of values than its size.
// expect: each sensor needs a name, static constexpr std::size_t size, and std::array<double, size> sense(
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

struct Age {
  static constexpr std::string_view name = "age";
#ifdef VALID
  static constexpr std::size_t size = 1;
#else
  static constexpr std::size_t size = 2;
#endif
  std::array<double, 1> sense(trophic::BodyIndex self, const std::optional<trophic::Sighting>&, const trophic::View& view,
                              trophic::Rng&) const {
    return {view.age_s(view.robots[self]) / 6000.0};
  }
};

int main() {
  using Sensors = trophic::perception::sensors::List<Age>;
  trophic::Ecology<trophic::with_sensors<trophic::rules::Paper, Sensors>> ecology{{}, trophic::backend::Kinematic::Params{}};
  ecology.run_until(10.0);
}
