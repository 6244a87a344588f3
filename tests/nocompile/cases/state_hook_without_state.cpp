// SPDX-License-Identifier: MIT
// A hook would never be called where there is nothing to keep.
// expect: a policy has on_walk but no State, so it would never be called
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

struct Keeper {
  static constexpr std::string_view name = "keeper";
#ifndef VALID
  void on_walk(double&, trophic::BodyIndex, double, const trophic::View&) const {}
#endif
  bool dies(const trophic::Individual&, const trophic::View&, trophic::Rng&) const {
    return false;
  }
};

int main() {
  trophic::Ecology<trophic::with_senescence<trophic::rules::Paper, Keeper>> ecology{{}, trophic::backend::Kinematic::Params{}};
  ecology.run_until(10.0);
}
