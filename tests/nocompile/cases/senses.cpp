// SPDX-License-Identifier: MIT
// A sensor that keeps something, one that does not, and a brain for them.
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/perception/sensors/joint_angles.hpp>
#include <trophic/rules/paper.hpp>

struct Odometer {
  static constexpr std::string_view name = "odometer";
  static constexpr std::size_t size = 1;
  struct State {
    double walked_m = 0.0;
    static constexpr auto fields() { return std::tuple{trophic::field("walked_m", &State::walked_m)}; }
  };
  State born(const trophic::Individual&, const State*, const State& body) const { return body; }
  std::array<double, 1> sense(trophic::BodyIndex, const std::optional<trophic::Sighting>&, const trophic::View&, trophic::Rng&,
                              const State& own) const {
    return {own.walked_m};
  }
};

struct Age {
  static constexpr std::string_view name = "age";
  static constexpr std::size_t size = 1;
  std::array<double, 1> sense(trophic::BodyIndex self, const std::optional<trophic::Sighting>&, const trophic::View& view,
                              trophic::Rng&) const {
    return {view.age_s(view.robots[self]) / 6000.0};
  }
};

struct Reflex {
  static constexpr std::string_view name = "reflex";
  static constexpr std::size_t inputs = 2;
  std::size_t genome_size(std::size_t, std::size_t) const { return 1; }
  std::vector<int> tags() const { return {0}; }
  trophic::control::Decision decide(std::span<const double> in, std::span<const double> weights) const {
    return {.target_angle_rad = in[0] * weights[0], .tag = 0};
  }
};

struct NoTag {
  static constexpr std::string_view name = "no_tag";
  int tag(std::optional<int>, std::span<const int> tags, trophic::Rng&) const { return tags[0]; }
};

using Joints = trophic::perception::sensors::List<trophic::perception::sensors::JointAngles<2>>;
static_assert(Joints::size == 2);

int main() {
  using Sensing = trophic::with_sensors<trophic::rules::Paper, trophic::perception::sensors::List<Odometer, Age>>;
  using Rules = trophic::with_newborn_tag<trophic::with_brain<Sensing, Reflex>, NoTag>;
  trophic::Ecology<Rules> ecology{{}, trophic::backend::Kinematic::Params{}};
  ecology.run_until(10.0);
}
