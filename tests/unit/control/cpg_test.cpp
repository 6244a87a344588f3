// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <support/temporary_folder.hpp>
#include <trophic/control/locomotion/cpg.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::locomotion;

namespace {

Gait one_hinge(double weight) {
  return {.name = "one",
          .robot = "r",
          .provenance = {},
          .hinges = {"a"},
          .internal = Eigen::VectorXd::Constant(1, weight),
          .coupling = Eigen::MatrixXd::Zero(1, 1)};
}

Gait random_gait(std::uint64_t seed, Eigen::Index hinges) {
  Rng rng{seed, Stream::user};
  Gait gait{.name = "random",
            .robot = "r",
            .provenance = {},
            .hinges = {},
            .internal = Eigen::VectorXd(hinges),
            .coupling = Eigen::MatrixXd::Zero(hinges, hinges)};
  for (Eigen::Index i = 0; i < hinges; ++i) {
    gait.hinges.push_back(std::to_string(i));
    gait.internal[i] = rng.uniform(-3.0, 3.0);
    for (Eigen::Index j = 0; j < i; ++j) {
      gait.coupling(j, i) = rng.uniform(-3.0, 3.0);
      gait.coupling(i, j) = -gait.coupling(j, i);
    }
  }
  return gait;
}

}  // namespace

TEST_CASE("cpg: weight matrix -> documented layout") {
  Gait gait = random_gait(1, 2);
  gait.internal << 2.0, 3.0;
  gait.coupling(0, 1) = 0.5;
  gait.coupling(1, 0) = -0.5;
  Eigen::Matrix4d expected;
  expected << 0, 0.5, 2, 0,  //
      -0.5, 0, 0, 3,         //
      -2, 0, 0, 0,           //
      0, -3, 0, 0;
  CHECK(Cpg{gait}.weights() == expected);
}

TEST_CASE("cpg: one oscillator -> x(t) = sin(w t + pi/4)") {
  const double weight = 2.0;
  const Cpg cpg{one_hinge(weight)};
  Eigen::MatrixXd states = cpg.initial_states();
  CHECK(states(0, 0) == std::numbers::sqrt2 / 2.0);
  CHECK(states(1, 0) == std::numbers::sqrt2 / 2.0);
  for (int tick = 1; tick <= 600; ++tick) {
    cpg.step(states);
    CHECK(std::abs(states(0, 0) - std::sin(weight * tick / 60.0 + std::numbers::pi / 4.0)) < 1e-12);
  }
}

TEST_CASE("cpg: exact steps, 6000 s -> no amplitude drift") {
  const Cpg cpg{load_gait("spider_published")};
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(8, 8);
  CHECK((cpg.propagator() * cpg.propagator().transpose() - identity).norm() < 1e-14);
  Eigen::MatrixXd states = cpg.initial_states();
  for (int tick = 0; tick < 6000 * 60; ++tick) cpg.step(states);
  CHECK(states.norm() == doctest::Approx(2.0).epsilon(1e-9));
}

TEST_CASE("cpg: rk4 -> slow drift, agrees with exact and fine integration over short times") {
  const Gait gait = load_gait("spider_published");
  const Cpg exact{gait};
  const Cpg rk4{gait, {.integration = CpgIntegration::rk4}};
  CHECK((exact.propagator() - rk4.propagator()).norm() < 1e-7);
  CHECK((exact.propagator() - rk4.propagator()).norm() > 1e-12);
  Eigen::MatrixXd a = exact.initial_states();
  Eigen::MatrixXd b = a;
  Eigen::VectorXd fine = a.col(0);
  const double h = 1.0 / 60.0 / 200.0;
  for (int tick = 0; tick < 60; ++tick) {
    exact.step(a);
    rk4.step(b);
    for (int i = 0; i < 200; ++i) {
      const Eigen::VectorXd half = fine + h / 2.0 * exact.weights() * fine;
      fine += h * exact.weights() * half;
    }
  }
  CHECK((a.col(0) - fine).norm() < 1e-7);
  CHECK((a - b).norm() < 1e-6);
}

TEST_CASE("cpg: rk4 -> classical Runge-Kutta step") {
  const Cpg cpg{random_gait(7, 3), {.integration = CpgIntegration::rk4, .step_s = 0.1}};
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(6, -1.0, 2.0);
  const auto f = [&](const Eigen::VectorXd& state) -> Eigen::VectorXd { return cpg.weights() * state; };
  const Eigen::VectorXd k1 = f(x);
  const Eigen::VectorXd k2 = f(x + 0.05 * k1);
  const Eigen::VectorXd k3 = f(x + 0.05 * k2);
  const Eigen::VectorXd k4 = f(x + 0.1 * k3);
  Eigen::MatrixXd states = x;
  cpg.step(states);
  CHECK((states.col(0) - (x + 0.1 / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4))).norm() < 1e-14);
}

TEST_CASE("cpg: outputs -> x states, unclipped") {
  const Cpg cpg{load_gait("spider_published")};
  Eigen::MatrixXd states = Eigen::MatrixXd::Zero(8, 2);
  states.col(1) << 0.5, -1.5, 1.25, -0.25, 9, 9, 9, 9;
  std::vector<double> targets_rad(4);
  cpg.outputs(states, 1, targets_rad);
  CHECK(targets_rad == std::vector<double>{0.5, -1.5, 1.25, -0.25});
}

TEST_CASE("cpg: bad number -> error with its name") {
  CHECK(test::message_of<std::invalid_argument>([] {
          Cpg{one_hinge(1.0), {.step_s = 0.0}};
        }) == "cpg.step_s = 0: must be > 0 and <= 1");
  CHECK(test::message_of<std::invalid_argument>([] { Cpg{one_hinge(std::nan(""))}; }) == "gait one: weights must be finite");
}

TEST_CASE("cpg: any gait -> orthogonal exact steps, columns independent") {
  CHECK(rc::check([] {
    const auto hinges = *rc::gen::inRange<Eigen::Index>(1, 9);
    const Cpg cpg{random_gait(*rc::gen::arbitrary<std::uint64_t>(), hinges)};
    RC_ASSERT((cpg.propagator() * cpg.propagator().transpose() - Eigen::MatrixXd::Identity(2 * hinges, 2 * hinges)).norm() <
              1e-12);
    const auto robots = *rc::gen::inRange<std::size_t>(1, 9);
    Eigen::MatrixXd together = Eigen::MatrixXd::Random(2 * hinges, static_cast<Eigen::Index>(robots));
    const Eigen::MatrixXd start = together;
    cpg.step(together);
    for (Eigen::Index robot = 0; robot < start.cols(); ++robot) {
      Eigen::MatrixXd alone = start.col(robot);
      cpg.step(alone);
      RC_ASSERT(alone == together.col(robot));
    }
  }));
}
