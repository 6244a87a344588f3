// SPDX-License-Identifier: MIT
// The released code's rules, height field and timestep in ODE.
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <trophic/backend/ode.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/rules/released.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/whole_file.hpp>

using namespace trophic;
using ReleasedInOde = Ecology<rules::Released>;

namespace {

constexpr const char* remark = "physics.integrator = rk4 has no effect: ode has its own semi-implicit Euler method";

std::vector<Pose> poses_of(const backend::Ode& backend) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < backend.robots(); ++i) poses.push_back(backend.pose(i));
  return poses;
}

}  // namespace

TEST_CASE("released rules in ODE: height field and timestep -> complete run") {
  ReleasedInOde ecology{{}, backend::Ode::Params{}};
  REQUIRE(ecology.params().physics.integrator == Integrator::rk4);
  REQUIRE(ecology.params().physics.timestep_s == 0.012);
  const std::vector<Pose> starts = poses_of(*ecology.backend().as<backend::Ode>());
  ecology.run_until(30.0);
  CHECK(ecology.backend().time_s() == doctest::Approx(36.0));  // 1.2 simulated seconds per second of its clock

  const std::vector<Pose> ends = poses_of(*ecology.backend().as<backend::Ode>());
  double walked_m = 0.0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    CAPTURE(i);
    walked_m += (ends[i].position_m - starts[i].position_m).norm() / static_cast<double>(ends.size());
    CHECK(ends[i].position_m.head(2).cwiseAbs().maxCoeff() < 9.5);  // the slope begins at 9.33 m
    CHECK(ends[i].position_m.z() > 0.02);
    CHECK(ends[i].position_m.z() < 0.2);
  }
  // At 4 cm/s straight ahead it would be 1.4 m; they also turn and meet.
  CHECK(walked_m > 0.6);
  CHECK(walked_m < 1.6);
}

TEST_CASE("released rules in ODE: manifest -> contains the integrator's remark") {
  const test::TemporaryFolder folder;
  ReleasedInOde ecology{{}, backend::Ode::Params{}};
  io::RunFolder files{folder.path() / "run", {}};
  ecology.run_until(2.0, files);
  const auto manifest = parse_json(read_whole_file(folder.path() / "run" / "manifest.json"));
  CHECK(manifest["params"]["physics"]["integrator"] == Json("rk4"));
  CHECK(manifest["remarks"] == Json::array({remark}));

  ReleasedInOde::Params own;
  own.physics.integrator = Integrator::semi_implicit_euler;
  CHECK(ReleasedInOde{own, backend::Ode::Params{}}.describe(2.0).remarks.empty());
}
