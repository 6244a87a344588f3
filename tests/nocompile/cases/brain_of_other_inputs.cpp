// SPDX-License-Identifier: MIT
// A brain for two inputs and a list of three sensors.
// expect: the brain in Rules::Brain takes another number of inputs than the sensors in Rules::Sensors give
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

struct Reflex {
  static constexpr std::string_view name = "reflex";
#ifdef VALID
  static constexpr std::size_t inputs = 3;
#else
  static constexpr std::size_t inputs = 2;
#endif
  std::size_t genome_size(std::size_t, std::size_t) const {
    return 1;
  }
  std::vector<int> tags() const {
    return {0};
  }
  trophic::control::Decision decide(std::span<const double> in, std::span<const double> weights) const {
    return {.target_angle_rad = in[0] * weights[0], .tag = 0};
  }
};
struct NoTag {
  static constexpr std::string_view name = "no_tag";
  int tag(std::optional<int>, std::span<const int> tags, trophic::Rng&) const { return tags[0]; }
};

int main() {
  using Rules = trophic::with_newborn_tag<trophic::with_brain<trophic::rules::Paper, Reflex>, NoTag>;
  trophic::Ecology<Rules> ecology{{}, trophic::backend::Kinematic::Params{}};
  ecology.run_until(10.0);
}
