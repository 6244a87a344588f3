// SPDX-License-Identifier: MIT
// The mode screening: how far robots walk in it, and that its runs have a physics and a fingerprint of their own.
#include <doctest/doctest.h>

#include <algorithm>
#include <mujoco/worlds.hpp>
#include <numeric>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/released.hpp>

using namespace trophic;
using backend::Mujoco;

namespace {

/// How far robots of 24 gaits walk in 20 s, m.
std::vector<double> displacements_m(double timestep_s, Mujoco::Stepping stepping) {
  Arena wide = test::square;
  wide.half_side_m = wide.extent_m = 50.0;
  const std::vector<Pose> starts = test::lattice(test::spider, 24, 10.0);
  Mujoco backend{test::spider, wide, starts, {.timestep_s = timestep_s}, {.stepping = stepping}};
  test::walk(backend, 20.0);
  std::vector<double> far_m;
  for (const Pose& start : starts) far_m.push_back((backend.pose(far_m.size()).position_m - start.position_m).norm());
  return far_m;
}

template <class Rules = rules::Paper>
observe::RunDescription description(Mujoco::Stepping stepping, double timestep_s) {
  Experiment<Rules> experiment;
  experiment.physics.timestep_s = timestep_s;
  return Ecology<Rules>{experiment, Mujoco::Params{.stepping = stepping}}.describe(1.0);
}

}  // namespace

TEST_CASE("screening: 24 gaits -> median error of the displacement below 5 %, and of all of it") {
  const std::vector<double> exact_m = displacements_m(0.0003, Mujoco::Stepping::fast);
  const std::vector<double> far_m = displacements_m(Mujoco::screening_timestep_s, Mujoco::Stepping::screening);
  std::vector<double> errors;
  for (std::size_t i = 0; i < far_m.size(); ++i) errors.push_back(std::abs(far_m[i] / exact_m[i] - 1.0));
  std::ranges::sort(errors);
  const auto sum = [](const std::vector<double>& all) { return std::accumulate(all.begin(), all.end(), 0.0); };
  const double of_all = sum(far_m) / sum(exact_m) - 1.0;
  MESSAGE("median error ", errors[12], ", largest ", errors[23], ", of all ", of_all);
  CHECK(errors[12] < 0.05);
  CHECK(std::abs(of_all) < 0.05);
}

TEST_CASE("screening: run -> its timestep and a remark are in the description, and no mode has its fingerprint") {
  const observe::RunDescription run = description(Mujoco::Stepping::screening, 0.0012);
  CHECK(run.fingerprint == description(Mujoco::Stepping::screening, 0.002).fingerprint);
  CHECK(run.fingerprint != description(Mujoco::Stepping::fast, 0.0012).fingerprint);
  CHECK(run.fingerprint != description(Mujoco::Stepping::fast, 0.002).fingerprint);
  CHECK(observe::short_name(run) == "paper (backend.stepping screening)");
  CHECK(run.remarks.at(0).starts_with(
      "backend.stepping = screening: uses single precision and steps of 0.002 s, but the table has 0.0012 s; "));
  CHECK(value_text(*std::ranges::find(run.named_params, "physics.timestep_s", &NamedParam::path)) == "0.002");
}

TEST_CASE("screening: another timestep or integrator -> refused") {
  CHECK_THROWS_WITH(displacements_m(0.0012, Mujoco::Stepping::screening),
                    "physics.timestep_s = 0.0012 with backend.stepping = screening: must be 0.002");
  CHECK_THROWS_WITH(description(Mujoco::Stepping::screening, 0.001),
                    "physics.timestep_s = 0.001 with backend.stepping = screening: must be 0.002");
  CHECK_THROWS_WITH(description<rules::Released>(Mujoco::Stepping::screening, 0.012),
                    "physics.integrator = rk4 with backend.stepping = screening: must be semi_implicit_euler");
}
