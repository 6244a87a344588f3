// SPDX-License-Identifier: MIT
// A member that fields() leaves out would be lost when a run is saved.
// expect: the State of the policy in Rules::Senescence must be an aggregate that lists every member once in fields()
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

struct Keeper {
  static constexpr std::string_view name = "keeper";
  struct State {
    double walked_m = 0.0;
#ifndef VALID
    double slept_s = 0.0;
#endif
    static constexpr auto fields() {
      return std::tuple{trophic::field("walked_m", &State::walked_m)};
    }
  };
  State born(const trophic::Individual&, const State*, const State& body) const {
    return body;
  }
  bool dies(const trophic::Individual&, const trophic::View&, trophic::Rng&, const State& own) const {
    return own.walked_m > 100.0;
  }
};

int main() {
  trophic::Ecology<trophic::with_senescence<trophic::rules::Paper, Keeper>> ecology{{}, trophic::backend::Kinematic::Params{}};
  ecology.run_until(10.0);
}
