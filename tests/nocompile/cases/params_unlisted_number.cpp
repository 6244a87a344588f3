// SPDX-License-Identifier: MIT
// Numbers that are written to a manifest, of whatever kind, are all of them.
// expect: Params must list every number in fields()
#include <string>
#include <trophic/params/named_params.hpp>
#include <tuple>

struct Numbers {
  double length_m = 1.0;
  std::string label = "none";
  static constexpr auto fields() {
    return std::tuple{trophic::field("length_m", &Numbers::length_m, trophic::above(0.0))
#ifdef VALID
                          ,
                      trophic::field("label", &Numbers::label)
#endif
    };
  }
};

int main() {
  return static_cast<int>(trophic::named_params_of(Numbers{}).size());
}
