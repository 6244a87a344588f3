// SPDX-License-Identifier: MIT
// A policy that manifests cannot name.
// expect: the policy in Rules::Senescence needs static constexpr std::string_view name
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

struct Immortal {
#ifdef VALID
  static constexpr std::string_view name = "immortal";
#endif
  bool dies(const trophic::Individual&, const trophic::View&, trophic::Rng&) const {
    return false;
  }
};

int main() {
  trophic::Ecology<trophic::with_senescence<trophic::rules::Paper, Immortal>, trophic::backend::Kinematic> ecology;
  ecology.run_until(10.0);
}
