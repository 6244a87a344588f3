// SPDX-License-Identifier: MIT
// A question reads its state, only hooks and brains change it.
// expect: needs bool dies(const Individual&, const View&, Rng&) const (with a State also const State& own)
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
  using Own = const State&;
#else
  using Own = State&;
#endif
  bool dies(const trophic::Individual&, const trophic::View&, trophic::Rng&, Own own) const {
    return own.walked_m > 100.0;
  }
};

int main() {
  trophic::Ecology<trophic::with_senescence<trophic::rules::Paper, Keeper>> ecology{{}, trophic::backend::Kinematic::Params{}};
  ecology.run_until(10.0);
}
