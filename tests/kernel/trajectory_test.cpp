// SPDX-License-Identifier: MIT
// The kernel against mj_step over whole walks, and settings that must not change them.
#include <doctest/doctest.h>

#include <trophic/habitat/load/robot.hpp>

#include "kernel/reference.hpp"

using namespace trophic;
using namespace trophic::test;

namespace {

/// Targets of a hinge: a sine of its own.
struct Gait {
  std::vector<double> amplitude_rad, rate_rad_s, phase_rad;

  Gait(std::size_t hinges, Rng& rng) {
    for (std::size_t j = 0; j < hinges; ++j) {
      amplitude_rad.push_back(rng.uniform(0.2, 1.1));
      rate_rad_s.push_back(rng.uniform(2.0, 9.0));
      phase_rad.push_back(rng.uniform(0.0, 6.0));
    }
  }
  void set_targets(double time_s, RobotState& state) const {
    for (std::size_t j = 0; j < state.target.size(); ++j) {
      state.target[j] = amplitude_rad[j] * std::sin(rate_rad_s[j] * time_s + phase_rad[j]);
    }
  }
};

/// Walks robots by the kernel, with MuJoCo where it declines.
class Walk {
 public:
  Walk(const RobotModel& robot, std::span<const Gait> gaits)
      : reference_{robot, Arena{}, Physics{}}, lanes_{reference_.constants}, gaits_{gaits} {
    states.assign(gaits.size(), resting(robot));
  }

  /// One control tick of 14 steps, robots in groups of four in the given order.
  void tick(double time_s, kernel::StepFunction step, std::span<const std::size_t> order) {
    for (std::size_t i = 0; i < states.size(); ++i) gaits_[i].set_targets(time_s, states[i]);
    for (std::size_t first = 0; first < order.size(); first += kernel::lane_count) {
      const std::size_t used = std::min(kernel::lane_count, order.size() - first);
      for (std::size_t lane = 0; lane < used; ++lane) states[order[first + lane]].put(lanes_.pack, lane);
      const unsigned all = (1u << used) - 1;
      for (int s = 0; s < 14; ++s) {
        if (forgetful) lanes_.pack.work.forget_rows();
        const unsigned stepped = lanes_.step(all, step);
        for (std::size_t lane = 0; lane < used; ++lane) {
          if ((stepped & (1u << lane)) == 0) step_by_mujoco(lane, states[order[first + lane]]);
        }
      }
      for (std::size_t lane = 0; lane < used; ++lane) {
        states[order[first + lane]].get(lanes_.pack, lane);
      }
    }
  }

  std::vector<RobotState> states;
  std::size_t declined = 0;
  bool forgetful = false;  ///< of the active rows in the step before

 private:
  void step_by_mujoco(std::size_t lane, RobotState& state) {
    ++declined;
    mjData& data = reference_.data;
    state.get(lanes_.pack, lane);
    state.put(data);
    reference_.step();
    state.get(data);
    state.put(lanes_.pack, lane);
  }

  Reference reference_;
  OnePack lanes_;
  std::span<const Gait> gaits_;
};

std::vector<std::size_t> in_order(std::size_t n) {
  std::vector<std::size_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = i;
  return order;
}

std::vector<Gait> random_gaits(const RobotModel& robot, std::size_t n, std::uint64_t seed) {
  Rng rng{seed, Stream::user};
  std::vector<Gait> gaits;
  for (std::size_t i = 0; i < n; ++i) gaits.emplace_back(robot.hinges.size(), rng);
  return gaits;
}

void compare_walks(const std::string& name, std::size_t robots, double duration_s) {
  const RobotModel robot = load_robot(name);
  const std::vector<Gait> gaits = random_gaits(robot, robots, 11);
  const auto ticks = static_cast<int>(duration_s * 60.0);
  Walk walk{robot, gaits};
  for (int t = 0; t < ticks; ++t) walk.tick(t / 60.0, kernel::fastest_step(), in_order(robots));
  Reference reference{robot, Arena{}, Physics{}};
  mjData& data = reference.data;
  double worst = 0.0, farthest_m = 0.0;
  for (std::size_t i = 0; i < robots; ++i) {
    RobotState state = resting(robot);
    state.put(data);
    for (int t = 0; t < ticks; ++t) {
      gaits[i].set_targets(t / 60.0, state);
      std::ranges::copy(state.target, data.ctrl);
      for (int s = 0; s < 14; ++s) reference.step();
    }
    for (std::size_t k = 0; k < state.qpos.size(); ++k) worst = std::max(worst, std::abs(walk.states[i].qpos[k] - data.qpos[k]));
    farthest_m = std::max(farthest_m, std::hypot(data.qpos[0], data.qpos[1]));
  }
  MESSAGE(name << ": " << robots << " gaits, " << duration_s << " s, " << walk.declined << " of "
               << 14 * static_cast<std::size_t>(ticks) * robots << " steps by MuJoCo, farthest " << farthest_m
               << " m; largest difference of any coordinate " << worst);
  CHECK(worst < 1e-9);
  CHECK(farthest_m > 0.1);
}

}  // namespace

TEST_CASE("kernel walk: 48 random gaits, some for long -> MuJoCo's") {
  compare_walks("spider", 48, 5.0);
  compare_walks("gecko", 12, 5.0);
  compare_walks("spider", 6, 20.0);
}

TEST_CASE("kernel: other robots in the set, another lane -> the same bytes") {
  const RobotModel robot = load_robot("spider");
  const std::vector<Gait> gaits = random_gaits(robot, 13, 12);
  Walk together{robot, gaits};
  Walk shuffled{robot, gaits};
  Rng rng{5, Stream::user};
  for (int t = 0; t < 120; ++t) {
    std::vector<std::size_t> order = in_order(gaits.size());
    together.tick(t / 60.0, kernel::fastest_step(), order);
    rng.shuffle(std::span{order});
    shuffled.tick(t / 60.0, kernel::fastest_step(), order);
  }
  for (std::size_t i = 0; i < gaits.size(); ++i) {
    CHECK(together.states[i].qpos == shuffled.states[i].qpos);
    CHECK(together.states[i].qvel == shuffled.states[i].qvel);
    CHECK(together.states[i].warm == shuffled.states[i].warm);
  }
}

TEST_CASE("kernel walk: another first guess of the active rows -> the same bits") {
  const RobotModel robot = load_robot("spider");
  const std::vector<Gait> gaits = random_gaits(robot, 12, 13);
  Walk usual{robot, gaits};
  Walk forgetful{robot, gaits};
  forgetful.forgetful = true;
  for (int t = 0; t < 120; ++t) {
    usual.tick(t / 60.0, kernel::fastest_step(), in_order(gaits.size()));
    forgetful.tick(t / 60.0, kernel::fastest_step(), in_order(gaits.size()));
  }
  for (std::size_t i = 0; i < gaits.size(); ++i) {
    CHECK(usual.states[i].qpos == forgetful.states[i].qpos);
    CHECK(usual.states[i].warm == forgetful.states[i].warm);
  }
}

TEST_CASE("kernel walk: sine and cosine -> the C library's to one unit in the last place") {
  Rng rng{6, Stream::user};
  double worst = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const double range = i % 2 == 0 ? 2.0 : kernel::largest_angle_rad;
    const double angle_rad = rng.uniform(-range, range);
    kernel::Real sine, cosine;
    kernel::sine_cosine(kernel::broadcast(angle_rad), sine, cosine);
    worst = std::max({worst, std::abs(sine[0] - std::sin(angle_rad)), std::abs(cosine[3] - std::cos(angle_rad))});
  }
  CHECK(worst < 2.3e-16);
}
