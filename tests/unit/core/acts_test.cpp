// SPDX-License-Identifier: MIT
// Acts: brains' outputs by name, their values in the view, and what they do.
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/control/acts/signal.hpp>
#include <trophic/control/brain/growing_brain.hpp>
#include <trophic/control/pace/constant_pace.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/reproduction/recruitment/by_mating.hpp>
#include <trophic/rules/by_species.hpp>
#include <trophic/worlds/pond.hpp>
#include <unit/checkpoint/resumed.hpp>

using namespace trophic;
namespace acts = control::acts;

namespace {

/// An act of two outputs.
struct Gaze {
  static constexpr std::string_view name = "gaze";
  static constexpr std::string_view unit = "rad";
  static constexpr std::size_t outputs = 2;
  static constexpr double least = -4.0;
  static constexpr double most = 4.0;
  static constexpr double by_default = 3.5;
  [[nodiscard]] static double value(std::span<const double, 2> out) { return std::atan2(out[0], out[1]); }
};

struct Wild : Gaze {
  static constexpr double most = 3.6;
  [[nodiscard]] static double value(std::span<const double, 2>) { return 4.5; }
};

/// Its outputs are its weights.
struct AsBorn {
  static constexpr std::string_view name = "as_born";
  [[nodiscard]] std::size_t genome_size(std::size_t, std::size_t outputs) const { return outputs; }
  [[nodiscard]] std::vector<int> tags() const { return {-1, 1}; }
  void evaluate(std::span<const double>, std::span<const double> weights, std::span<double> outputs) const {
    std::ranges::copy(weights, outputs.begin());
  }
};

using All = acts::List<acts::Turn, acts::Tag, acts::Effort, acts::Eat, Gaze, acts::Signal<2>>;
using Acting = with_acts<with_brain<rules::Paper, AsBorn>, All>;

/// Compares the values in the view with the weights of the individuals that decided.
struct Watch {
  void on_start(const observe::RunDescription& run, const View& view) {
    CHECK(run.outputs == std::vector<std::string>{"turn", "tag", "effort", "eat", "gaze0", "gaze1", "signal_2"});
    CHECK(view.act<Gaze>(0) == 3.5);
    CHECK(view.act<acts::Effort>(0) == 1.0);
  }
  void on_tick(const View& view) {
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      const std::vector<double>& out = view.robots[body].genome->weights;
      REQUIRE(out.size() == 7);
      CHECK(view.act<acts::Turn>(body) == out[0]);
      CHECK(view.act<acts::Tag>(body) == view.robots[body].tag);
      CHECK(view.act<acts::Effort>(body) == 0.5 * (1.0 + out[2]));
      CHECK(view.act<acts::Eat>(body) == (out[3] > 0.0));
      CHECK(view.act<Gaze>(body) == std::atan2(out[4], out[5]));
      CHECK(view.act<acts::Signal<2>>(body) == std::max(0.0, out[6]));
      CHECK(view.act<acts::Signal<3>>(body) == 0.0);
    }
    ++ticks;
  }
  std::size_t ticks = 0;
};

/// The distances that robots far from walls walked in a tick, over that of a whole tick at the speed of the robot's walk.
struct Steps {
  void on_tick(const View& view) {
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      const GroundPose& now = view.poses[body];
      if (view.tick > 0 && std::max(std::abs(now.x_m), std::abs(now.y_m)) < view.arena.half_side_m - 1.0)
        shares.push_back({species[body], paces[body], view.distance_m(before[body], now)});
      before.resize(view.robots.size());
      paces.resize(view.robots.size());
      species.resize(view.robots.size());
      before[body] = now;
      species[body] = view.robots[body].species;
      paces[body] = view.act<acts::Effort>(body);
    }
  }
  struct Share {
    Species species;
    double effort;
    double walked_m;
  };
  std::vector<GroundPose> before = {};
  std::vector<double> paces = {};
  std::vector<Species> species = {};
  std::vector<Share> shares = {};
};

/// Walks straight ahead, as hard as it was born to.
struct Straight : AsBorn {
  static constexpr std::string_view name = "straight";
  void evaluate(std::span<const double>, std::span<const double> weights, std::span<double> outputs) const {
    std::ranges::copy(weights, outputs.begin());
    outputs[0] = 0.0;
  }
};

template <class Rules>
Steps walked(Experiment<Rules> experiment = {}) {
  Ecology<Rules> ecology{experiment, backend::Kinematic::Params{}};
  Steps steps;
  ecology.run_until(60.0, steps);
  REQUIRE(steps.shares.size() > 100);
  return steps;
}

}  // namespace

TEST_CASE("acts: any acts -> their values in the view, by default before the first decision") {
  Ecology<Acting> ecology{{.seed = 2}, backend::Kinematic::Params{}};
  Watch watch;
  ecology.run_until(200.0, watch);
  CHECK(watch.ticks == 101);
}

TEST_CASE("acts: value out of its bounds -> RuleError with act, value and bounds") {
  Ecology<with_acts<with_brain<rules::Paper, AsBorn>, acts::List<acts::Turn, acts::Tag, Wild>>> ecology{
      {}, backend::Kinematic::Params{}};
  CHECK_THROWS_WITH_AS(ecology.run_until(2.0), "the policy in rules.acts returned gaze = 4.5: must be >= -4 and <= 3.6",
                       RuleError);
}

TEST_CASE("acts: effort -> that share of the speed, none stands still") {
  using Rules = with_acts<with_brain<rules::Paper, Straight>, acts::List<acts::Turn, acts::Tag, acts::Effort>>;
  const double full_m = load_robot("spider").walk.speed_m_s * 2.0;
  double least = 1.0;
  for (const auto& one : walked<Rules>().shares) {
    CHECK(one.walked_m == doctest::Approx(one.effort * full_m));
    least = std::min(least, one.effort);
  }
  CHECK(least < 0.2);
}

TEST_CASE("pace: by species -> predators 1.3 times as fast, prey stand") {
  using Straightened = with_brain<rules::Paper, Straight>;
  using Paced = with_pace<Straightened, rules::by_species<control::pace::ConstantPace>>;
  const double full_m = load_robot("spider").walk.speed_m_s * 2.0;
  Experiment<Paced> experiment;
  experiment.rules.pace.get<0>().factor = 0.0;
  experiment.rules.pace.get<1>().factor = 1.3;
  for (const auto& one : walked<Paced>(experiment).shares)
    CHECK(one.walked_m == doctest::Approx(one.species == 0 ? 0.0 : 1.3 * full_m));
  // a factor of 1 gives the same bits as no pace
  Ecology<Paced> ones{{.seed = 3}, backend::Kinematic::Params{}};
  Ecology<Straightened> none{{.seed = 3}, backend::Kinematic::Params{}};
  ones.run_until(300.0);
  none.run_until(300.0);
  for (BodyIndex body = 0; body < ones.view().poses.size(); ++body) CHECK(ones.view().poses[body] == none.view().poses[body]);
}

TEST_CASE("acts: pond of brains that grow and choose to walk, eat and mate -> resumed to the byte") {
  using Growing = with_brain<worlds::Pond, control::brain::GrowingBrain>;
  using Acts = acts::List<acts::Turn, acts::Tag, acts::Effort, acts::Eat, acts::Mate>;
  using Mating = with_recruitment<Growing, reproduction::recruitment::ByMating>;
  Experiment<with_acts<Mating, Acts>> experiment;
  experiment.ecology.duration_s = 200.0;
  experiment.rules.recruitment.spare_bodies = experiment.ecology.robots / 2;
  experiment.rules.recruitment.birth_J = 10.0;
  const test::TemporaryFolder folder;
  test::check_resumed(experiment, backend::Kinematic::Params{}, folder.path(), {20, 50, 51}, 20.0, [](std::size_t, auto&) {});
  const std::string events = test::content(folder.path() / "whole" / "events.csv");
  CHECK(std::ranges::count(events, '\n') > 160);
}
