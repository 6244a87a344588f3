// SPDX-License-Identifier: MIT
// A State may hold only what can be written to a file.
// expect: the State of the policy in Rules::Senescence may hold numbers, enumerations, Ancestors
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

struct Keeper {
  static constexpr std::string_view name = "keeper";
  struct State {
#ifdef VALID
    double walked_m = 0.0;
#else
    double* walked_m = nullptr;
#endif
    static constexpr auto fields() {
      return std::tuple{trophic::field("walked_m", &State::walked_m)};
    }
  };
  State born(const trophic::Individual&, const State*, const State& body) const {
    return body;
  }
  bool dies(const trophic::Individual&, const trophic::View&, trophic::Rng&, const State& own) const {
    return own.walked_m == decltype(own.walked_m){};
  }
};

int main() {
  trophic::Ecology<trophic::with_senescence<trophic::rules::Paper, Keeper>> ecology{{}, trophic::backend::Kinematic::Params{}};
  ecology.run_until(10.0);
}
