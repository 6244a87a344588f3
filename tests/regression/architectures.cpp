// SPDX-License-Identifier: MIT
// architectures FOLDER: runs of both tables without bodies, and a minute of MuJoCo if it is linked. Compiled for each
// architecture, they must write the same tables.
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>
#ifdef TROPHIC_WITH_MUJOCO
#include <trophic/backend/mujoco.hpp>
#endif

namespace {

template <class Rules>
void run(const std::filesystem::path& path, double until_s, const auto& backend) {
  trophic::Ecology<Rules> ecology{typename trophic::Ecology<Rules>::Params{.seed = 1}, backend};
  trophic::io::RunFolder folder{path, {}, {.replay_hz = 0.0}};
  ecology.run_until(until_s, folder);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  const trophic::backend::Kinematic::Params points{};
  run<trophic::rules::Paper>(folder / "kinematic_paper", 600.0, points);
  run<trophic::rules::Released>(folder / "kinematic_released", 600.0, points);
#ifdef TROPHIC_WITH_MUJOCO
  run<trophic::rules::Paper>(folder / "mujoco_paper", 60.0, trophic::backend::Mujoco::Params{});
#endif
}
