// SPDX-License-Identifier: MIT
// A hook of a State that takes other arguments than it is called with.
// expect: a policy's on_walk must be callable as void on_walk(State&, BodyIndex, double distance_m, const View&) const
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

struct Keeper {
  static constexpr std::string_view name = "keeper";
  struct State {
    double walked_m = 0.0;
    static constexpr auto fields() { return std::tuple{trophic::field("walked_m", &State::walked_m)}; }
  };
  State born(const trophic::Individual&, const State*, const State& body) const { return body; }
#ifdef VALID
  void on_walk(State& own, trophic::BodyIndex, double distance_m, const trophic::View&) const {
    own.walked_m += distance_m;
  }
#else
  void on_walk(State& own, double distance_m) const {
    own.walked_m += distance_m;
  }
#endif
  bool dies(const trophic::Individual&, const trophic::View&, trophic::Rng&, const State& own) const {
    return own.walked_m > 100.0;
  }
};

int main() {
  trophic::Ecology<trophic::with_senescence<trophic::rules::Paper, Keeper>> ecology{{}, trophic::backend::Kinematic::Params{}};
  ecology.run_until(10.0);
}
