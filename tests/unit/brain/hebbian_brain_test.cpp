// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <map>
#include <trophic/backend/kinematic.hpp>
#include <trophic/control/brain/hebbian_brain.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>
#include <unit/brain/check_out.hpp>

using namespace trophic;
using control::brain::CognitiveBrain;
using control::brain::HebbianBrain;

namespace {

const std::vector<double> weights{0.5, -0.3, 0.8, 0.1, 0.9, -0.7, -0.2, 0.4, 0.6, 0.3, -0.5, 0.7, -0.9, 0.2, 0.4};
constexpr std::array inputs{1.0, 0.25, -0.5};

using Learning = with_brain<rules::Paper, HebbianBrain>;
using Kinematics = Ecology<Learning>;

/// Follows genomes and what is learnt through a run without mutations.
struct Lives {
  explicit Lives(const Kinematics& run) : ecology{run} {}

  void on_event(const observe::Event& event, const View&) {
    const Individual& self = event.individual;
    const auto& learnt = ecology.states().brain[event.body].learnt;
    if (event.kind == observe::EventKind::birth) {
      CHECK(learnt.empty());
      genomes[self.id] = self.genome->weights;
      if (!self.parent()) return;
      CHECK(genomes[self.id] == genomes[*self.parent()]);
      CHECK(self.mutation_distance == 0.0);
      ++inherited;
    }
    if (event.kind == observe::EventKind::death) {
      CHECK(self.genome->weights == genomes[self.id]);
      double most = 0.0;
      for (const double one : learnt) most = std::max(most, std::abs(one));
      if (most > 0.01) ++learnt_something;
    }
  }

  const Kinematics& ecology;
  std::map<IndividualId, std::vector<double>> genomes;
  std::size_t inherited = 0;
  std::size_t learnt_something = 0;
};

}  // namespace

TEST_CASE("hebbian brain: first decision, or rate 0 -> the cognitive brain's") {
  const CognitiveBrain fixed;
  HebbianBrain::State own;
  CHECK((test::decide(HebbianBrain{}, inputs, weights, own) == test::decide(fixed, inputs, weights)));
  HebbianBrain::State still;
  for (int i = 0; i < 100; ++i)
    CHECK((test::decide(HebbianBrain{{.rate = 0.0}}, inputs, weights, still) == test::decide(fixed, inputs, weights)));
  CHECK(still.learnt == std::vector<double>(15, 0.0));
}

TEST_CASE("hebbian brain: one decision -> one step of Oja's rule, computed by hand") {
  HebbianBrain::State own;
  static_cast<void>(test::decide(HebbianBrain{{.rate = 0.1}}, inputs, weights, own));
  const double h0 = std::tanh(0.5 * 1.0 - 0.3 * 0.25 - 0.8 * 0.5);
  const double h1 = std::tanh(0.1 * 1.0 + 0.9 * 0.25 + 0.7 * 0.5);
  const double h2 = std::tanh(-0.2 * 1.0 + 0.4 * 0.25 - 0.6 * 0.5);
  const double out1 = std::tanh(-0.9 * h0 + 0.2 * h1 + 0.4 * h2);
  REQUIRE(own.learnt.size() == 15);
  CHECK(own.learnt[0] == doctest::Approx(0.1 * h0 * (1.0 - h0 * 0.5)));
  CHECK(own.learnt[5] == doctest::Approx(0.1 * h1 * (-0.5 - h1 * -0.7)));
  CHECK(own.learnt[13] == doctest::Approx(0.1 * out1 * (h1 - out1 * 0.2)));
}

TEST_CASE("hebbian brain: decision -> sum of the genome's and the learnt weights") {
  const HebbianBrain brain{{.rate = 0.1}};
  HebbianBrain::State own;
  static_cast<void>(test::decide(brain, inputs, weights, own));
  std::vector<double> sum = weights;
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += own.learnt[i];
  CHECK(test::outputs(brain, inputs, weights, own) == test::outputs(CognitiveBrain{}, inputs, sum));
  CHECK(test::outputs(brain, inputs, weights, own) != test::outputs(CognitiveBrain{}, inputs, weights));
}

TEST_CASE("hebbian brain: output of exactly 0 -> left turn, tag -1") {
  HebbianBrain::State own;
  const control::Decision decision = test::decide(HebbianBrain{}, inputs, std::vector<double>(15, 0.0), own);
  CHECK((decision == control::Decision{.target_angle_rad = -0.7, .tag = -1}));
}

TEST_CASE("hebbian brain: many decisions -> bounded weights") {
  const HebbianBrain brain{{.rate = 0.1}};
  HebbianBrain::State own;
  for (int i = 0; i < 20'000; ++i) {
    const double side = i % 3 == 0 ? 1.0 : -1.0;
    static_cast<void>(test::decide(brain, std::array{side, 0.3, 0.1 * side}, weights, own));
  }
  for (std::size_t i = 0; i < weights.size(); ++i) CHECK(std::abs(weights[i] + own.learnt[i]) < 3.0);
}

TEST_CASE("hebbian brain: birth -> nothing learnt, genome inherited unchanged") {
  Kinematics::Params params{.seed = 4};
  params.rules.mutation.sd = 0.0;
  Kinematics ecology{params, backend::Kinematic::Params{}};
  Lives lives{ecology};
  ecology.run_until(2000.0, lives);
  CHECK(lives.inherited > 20);
  CHECK(lives.learnt_something > 20);
}
