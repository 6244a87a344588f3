// SPDX-License-Identifier: MIT
// A rule that keeps something for each individual.
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

struct Keeper {
  static constexpr std::string_view name = "keeper";
  struct State {
    double walked_m = 0.0;
    int walks = 0;
    static constexpr auto fields() {
      return std::tuple{trophic::field("walked_m", &State::walked_m), trophic::field("walks", &State::walks)};
    }
  };
  State born(const trophic::Individual&, const State*, const State& body) const { return body; }
  void on_walk(State& own, trophic::BodyIndex, double distance_m, const trophic::View&) const { own.walked_m += distance_m; }
  void hand_over(State& own, State& newborn, const trophic::View&) const { std::swap(own.walks, newborn.walks); }
  bool dies(const trophic::Individual&, const trophic::View&, trophic::Rng&, const State& own) const {
    return own.walked_m > 100.0;
  }
};

int main() {
  trophic::Ecology<trophic::with_senescence<trophic::rules::Paper, Keeper>> ecology{{}, trophic::backend::Kinematic::Params{}};
  ecology.run_until(10.0);
}
