// SPDX-License-Identifier: MIT
// A number that fields() does not list would be neither checked nor written to the manifest.
// expect: Params must be empty or list every number in fields(); see trophic/params/params.hpp
#include <trophic/params/params.hpp>
#include <tuple>

struct Params {
  double max_age_s = 600.0;
#ifdef VALID
  static constexpr auto fields() {
    return std::tuple{trophic::field("max_age_s", &Params::max_age_s, trophic::above(0.0))};
  }
#endif
};

int main() {
  trophic::validate(Params{}, "death");
}
