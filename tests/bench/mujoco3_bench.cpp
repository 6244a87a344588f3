// SPDX-License-Identifier: MIT
// MuJoCo 3's own islands and threads against the backend's: the same world, which the backend walks and saves, stepped by MuJoCo
// alone and by `fast`. Prints microseconds of a step, the least of some rounds that are interleaved.
#include <mujoco/mujoco.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>
#include <mujoco/worlds.hpp>
#include <support/temporary_folder.hpp>
#include <trophic/backend/mujoco/engine.hpp>
#include <vector>

namespace {

using trophic::backend::Mujoco;
namespace engine = trophic::backend::mujoco;

/// Spiders on a lattice in an arena with as much room for each as 300 have in the paper's.
struct Scene {
  trophic::RobotModel spider = trophic::load_robot("spider");
  trophic::Arena arena = trophic::load_arena("walled_square");
  std::vector<trophic::Pose> starts;

  explicit Scene(std::size_t robots) {
    const double side = std::ceil(std::sqrt(static_cast<double>(robots)));
    arena.half_side_m = std::max(arena.half_side_m, 0.5 * (19.0 / 18.0 * side + 1.0));
    arena.extent_m = 2.0 * arena.half_side_m;
    starts = trophic::test::lattice(spider, robots, (2.0 * arena.half_side_m - 1.0) / side);
    for (trophic::Pose& start : starts) start.position_m.z() += 0.1;
  }
};

/// Hinges swing with phases of their own, which needs no gait.
void aim(Mujoco& backend, double time_s) {
  for (std::size_t robot = 0; robot < backend.robots(); ++robot) {
    std::array<double, 4> targets_rad{};
    for (std::size_t i = 0; i < targets_rad.size(); ++i) {
      targets_rad[i] = 0.6 * std::sin(5.0 * time_s + 1.7 * static_cast<double>(i) + 0.37 * static_cast<double>(robot));
    }
    backend.set_joint_targets(robot, targets_rad);
  }
}

/// The saved world in MuJoCo alone.
class Alone {
 public:
  Alone(const std::filesystem::path& world, bool islands, std::size_t threads) {
    std::array<char, 1000> error{};
    model_.reset(mj_loadXML(world.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
    if (!model_) throw std::runtime_error{error.data()};
    if (!islands) model_->opt.disableflags |= mjDSBL_ISLAND;
    data_.reset(mj_makeData(model_.get()));
    if (threads > 1) {
      pool_.reset(mju_threadPoolCreate(threads));
      mju_bindThreadPool(data_.get(), pool_.get());
    }
    mj_resetDataKeyframe(model_.get(), data_.get(), 0);
  }

  /// The same steps in each round, from the saved state on.
  void steps(int count) {
    mj_resetDataKeyframe(model_.get(), data_.get(), 0);
    for (int i = 0; i < count; ++i) mj_step(model_.get(), data_.get());
  }

 private:
  struct DeletePool {
    void operator()(mjThreadPool* pool) const { mju_threadPoolDestroy(pool); }
  };
  engine::ModelPtr model_;
  std::unique_ptr<mjThreadPool, DeletePool> pool_;
  engine::DataPtr data_;
};

struct Measure {
  double wall_us = std::numeric_limits<double>::infinity();
  double processor_us = std::numeric_limits<double>::infinity();
};

double processor_s() {
  rusage use{};
  ::getrusage(RUSAGE_SELF, &use);
  return static_cast<double>(use.ru_utime.tv_sec + use.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(use.ru_utime.tv_usec + use.ru_stime.tv_usec);
}

void measure(Measure& best, int count, const std::function<void(int)>& steps) {
  const double before_s = processor_s();
  const auto start = std::chrono::steady_clock::now();
  steps(count);
  const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  best.wall_us = std::min(best.wall_us, 1e6 * wall_s / count);
  best.processor_us = std::min(best.processor_us, 1e6 * (processor_s() - before_s) / count);
}

void compare(std::size_t robots) {
  const trophic::test::TemporaryFolder folder;
  const Scene scene{robots};
  const trophic::Physics physics{};
  std::array<std::unique_ptr<Mujoco>, 2> fast;
  for (std::size_t i = 0; i < fast.size(); ++i) {
    fast[i] = std::make_unique<Mujoco>(scene.spider, scene.arena, scene.starts, physics, Mujoco::Params{.threads = i + 1});
  }
  for (int tick = 0; tick < 60; ++tick) {
    aim(*fast[0], tick / 60.0);
    fast[0]->advance_to((tick + 1) / 60.0);
  }
  const Mujoco::State walked = fast[0]->save();
  fast[0]->save_mjcf(folder.path() / "world.xml");
  std::array<std::unique_ptr<Alone>, 3> alone;
  const std::array<std::pair<bool, std::size_t>, 3> ways{std::pair{false, 1U}, {true, 1U}, {true, 2U}};
  std::array<Measure, 5> best;
  const int count = robots > 300 ? 14 : 42;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    alone[i] = std::make_unique<Alone>(folder.path() / "world.xml", ways[i].first, ways[i].second);
  }
  for (int round = 0; round < 5; ++round) {
    for (std::size_t i = 0; i < alone.size(); ++i) measure(best[i], count, [&](int n) { alone[i]->steps(n); });
    for (std::size_t i = 0; i < fast.size(); ++i) {
      fast[i]->restore(walked);
      measure(best[3 + i], count, [&](int n) { fast[i]->advance_to(fast[i]->time_s() + n * physics.timestep_s); });
    }
  }
  std::printf("%6zu", robots);
  for (const Measure& one : best) std::printf("  %9.1f %9.1f", one.wall_us, one.processor_us);
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main() {
  std::printf("MuJoCo %s; microseconds of a step: wall, processor\n", mj_versionString());
  std::printf("robots  %-19s  %-19s  %-19s  %-19s  %-19s\n", "without islands", "its islands", "its islands, 2 threads",
              "fast, 1 thread", "fast, 2 threads");
  for (const std::size_t robots : {30U, 100U, 300U, 1000U}) compare(robots);
}
