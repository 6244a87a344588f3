// SPDX-License-Identifier: MIT
// A sensor that keeps something and does not say what a newborn starts with.
// expect: a sensor has a State, so it needs State born(const Individual& newborn
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

struct Odometer {
  static constexpr std::string_view name = "odometer";
  static constexpr std::size_t size = 1;
  struct State {
    double walked_m = 0.0;
    static constexpr auto fields() { return std::tuple{trophic::field("walked_m", &State::walked_m)}; }
  };
#ifdef VALID
  State born(const trophic::Individual&, const State*, const State& body) const {
    return body;
  }
#endif
  std::array<double, 1> sense(trophic::BodyIndex, const std::optional<trophic::Sighting>&, const trophic::View&, trophic::Rng&,
                              const State& own) const {
    return {own.walked_m};
  }
};

int main() {
  using Sensors = trophic::perception::sensors::List<Odometer>;
  trophic::Ecology<trophic::with_sensors<trophic::rules::Paper, Sensors>> ecology{{}, trophic::backend::Kinematic::Params{}};
  ecology.run_until(10.0);
}
