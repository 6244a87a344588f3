// SPDX-License-Identifier: MIT
// Rules without numbers.
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

struct Immortal {
  static constexpr std::string_view name = "immortal";
  bool dies(const trophic::Individual&, const trophic::View&, trophic::Rng&) const { return false; }
};

struct AlwaysInherits {
  static constexpr std::string_view name = "always_inherits";
  trophic::reproduction::Descent descent(trophic::Rng&) const { return trophic::reproduction::Descent::of_parent; }
};

int main() {
  using Rules = trophic::with_genome_source<trophic::with_senescence<trophic::rules::Paper, Immortal>, AlwaysInherits>;
  trophic::Ecology<Rules> ecology{{}, trophic::backend::Kinematic::Params{}};
  ecology.run_until(10.0);
}
