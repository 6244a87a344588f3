// SPDX-License-Identifier: MIT
// MuJoCo's own ways of stepping many robots against the backend's, from one state of the same world: one model of all, with its
// islands and threads; its batch of one small model a robot; and the backend's. Prints microseconds of a step, of the wall and of
// the processor, the least of some rounds that are interleaved, and how far each way is from one model after ten times as many
// steps.
#include <mujoco/mujoco.h>
#include <sys/resource.h>
#if mjVERSION_HEADER >= 3017000
#include <mujoco/mjbatch.h>
#endif

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <limits>
#include <memory>
#include <mujoco/worlds.hpp>
#include <span>
#include <string>
#include <support/temporary_folder.hpp>
#include <trophic/backend/mujoco/compiled_model.hpp>
#include <trophic/backend/mujoco/engine.hpp>
#include <vector>

namespace {

using trophic::backend::Mujoco;
namespace engine = trophic::backend::mujoco;

/// Spiders on a lattice, in an arena with as much room for each as 300 have in the paper's, or in a crowd between walls.
struct Scene {
  trophic::RobotModel spider = trophic::load_robot("spider");
  trophic::Arena arena = trophic::load_arena("walled_square");
  std::vector<trophic::Pose> starts;

  Scene(std::size_t robots, bool is_crowd) {
    constexpr double crowded_m = 0.45;  // between neighbours: 1.1 diameters of a spider's sphere
    const double side = std::ceil(std::sqrt(static_cast<double>(robots)));
    arena.half_side_m = std::max(arena.half_side_m, 0.5 * (19.0 / 18.0 * side + 1.0));
    if (is_crowd) arena.half_side_m = 0.5 * crowded_m * side + 0.1;
    arena.extent_m = 2.0 * arena.half_side_m;
    starts = trophic::test::lattice(spider, robots, is_crowd ? crowded_m : (2.0 * arena.half_side_m - 1.0) / side);
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

/// A way of stepping the world, from the same state in each round.
struct Way {
  virtual ~Way() = default;
  virtual void start() = 0;
  virtual void step(int count) = 0;
  /// x, y and z of all robots.
  [[nodiscard]] virtual std::vector<double> places_m() const = 0;
};

/// The backend with a way of stepping.
class Backend final : public Way {
 public:
  Backend(const Scene& scene, const Mujoco::State& state, Mujoco::Stepping stepping, std::size_t threads)
      : backend_{scene.spider, scene.arena, scene.starts, {}, {.stepping = stepping, .threads = threads}}, state_{state} {}

  void start() override { backend_.restore(state_); }
  void step(int count) override { backend_.advance_to(backend_.time_s() + count * trophic::Physics{}.timestep_s); }
  [[nodiscard]] std::vector<double> places_m() const override {
    std::vector<double> places;
    for (std::size_t robot = 0; robot < backend_.robots(); ++robot) {
      const Eigen::Vector3d at_m = backend_.pose(robot).position_m;
      places.insert(places.end(), {at_m.x(), at_m.y(), at_m.z()});
    }
    return places;
  }

 private:
  Mujoco backend_;
  Mujoco::State state_;
};

/// The saved world as one model in MuJoCo alone.
class OneWorld final : public Way {
 public:
  OneWorld(const std::filesystem::path& world, std::size_t robots, bool islands, int threads) : robots_{robots} {
    std::array<char, 1000> error{};
    model_.reset(mj_loadXML(world.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
    if (!model_) throw std::runtime_error{error.data()};
    if (!islands) model_->opt.disableflags |= mjDSBL_ISLAND;
    data_.reset(mj_makeData(model_.get()));
    if (threads > 1) use_threads(threads);
  }

  void start() override { mj_resetDataKeyframe(model_.get(), data_.get(), 0); }
  void step(int count) override {
    for (int i = 0; i < count; ++i) mj_step(model_.get(), data_.get());
    for (const mjWarningStat& warning : data_->warning) {
      if (warning.number != 0) throw std::runtime_error{"MuJoCo warned"};
    }
  }
  [[nodiscard]] std::vector<double> places_m() const override {
    std::vector<double> places;
    const auto stride = static_cast<std::size_t>(model_->nq) / robots_;
    for (std::size_t robot = 0; robot < robots_; ++robot) {
      places.insert(places.end(), data_->qpos + robot * stride, data_->qpos + robot * stride + 3);
    }
    return places;
  }

 private:
#if mjVERSION_HEADER >= 3010000
  void use_threads(int threads) {
    mju_threadpool(data_.get(), threads);
  }
#else
  struct DeletePool {
    void operator()(mjThreadPool* pool) const { mju_threadPoolDestroy(pool); }
  };
  void use_threads(int threads) {
    pool_.reset(mju_threadPoolCreate(static_cast<std::size_t>(threads)));
    mju_bindThreadPool(data_.get(), pool_.get());
  }
  std::unique_ptr<mjThreadPool, DeletePool> pool_;
#endif
  std::size_t robots_;
  engine::ModelPtr model_;
  engine::DataPtr data_;
};

#if mjVERSION_HEADER >= 3017000
/// MuJoCo's batch with the backend's model of one robot, which knows neither the others nor the walls.
class Batch final : public Way {
 public:
  Batch(const Scene& scene, const Mujoco::State& state, int threads)
      : robots_{scene.starts.size()},
        one_{scene.spider,
             scene.arena,
             {},
             {.walls = false, .collisions = engine::Collisions::pairs, .servos = engine::Servos::combined},
             1,
             1},
        state_{state} {
    mjBatchConfig config;
    mjb_defaultConfig(&config);
    config.nthread = threads;
    std::array<char, 1000> error{};
    batch_.reset(mjb_makeBatch(&one_.model(), static_cast<int>(robots_), &config, error.data(), static_cast<int>(error.size())));
    if (!batch_) throw std::runtime_error{error.data()};
  }

  void start() override {
    mjb_reset(batch_.get(), nullptr, 0, nullptr, mjSTAGE_NONE);
    const auto nq = static_cast<std::size_t>(one_.model().nq);
    const auto nv = static_cast<std::size_t>(one_.model().nv);
    const auto nu = static_cast<std::size_t>(one_.model().nu);
    for (std::size_t robot = 0; robot < robots_; ++robot) {
      const auto numbers = std::span{state_.robots}.subspan(robot * (nq + 2 * nv), nq + 2 * nv);
      std::ranges::copy(numbers.first(nq), row(mjSTATE_QPOS, robot));
      std::ranges::copy(numbers.subspan(nq, nv), row(mjSTATE_QVEL, robot));
      std::ranges::copy(numbers.last(nv), row(mjSTATE_WARMSTART, robot));
      std::ranges::copy(std::span{state_.targets_rad}.subspan(robot * nu, nu), row(mjSTATE_CTRL, robot));
    }
  }
  void step(int count) override {
    // A control tick has 14 steps, after which targets change.
    for (int done = 0; done < count; done += 14) {
      if (mjb_step(batch_.get(), nullptr, 0, std::min(14, count - done), mjSTAGE_NONE) != 0) throw std::runtime_error{"mjb_step"};
    }
  }
  [[nodiscard]] std::vector<double> places_m() const override {
    std::vector<double> places;
    for (std::size_t robot = 0; robot < robots_; ++robot) {
      const mjtNum* const at_m = row(mjSTATE_QPOS, robot);
      places.insert(places.end(), at_m, at_m + 3);
    }
    return places;
  }

 private:
  struct DeleteBatch {
    void operator()(mjBatch* batch) const { mjb_deleteBatch(batch); }
  };
  [[nodiscard]] mjtNum* row(int component, std::size_t robot) const {
    return mjb_stateComponent(batch_.get(), component, nullptr) + robot * static_cast<std::size_t>(mjb_nstate(batch_.get()));
  }

  std::size_t robots_;
  engine::CompiledModel one_;
  Mujoco::State state_;
  std::unique_ptr<mjBatch, DeleteBatch> batch_;
};
#endif

struct Measure {
  double wall_us = std::numeric_limits<double>::infinity();
  double processor_us = std::numeric_limits<double>::infinity();
  double off_m = 0.0;
};

double processor_s() {
  rusage use{};
  ::getrusage(RUSAGE_SELF, &use);
  return static_cast<double>(use.ru_utime.tv_sec + use.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(use.ru_utime.tv_usec + use.ru_stime.tv_usec);
}

void measure(Measure& best, int count, Way& way) {
  way.start();
  const double before_s = processor_s();
  const auto start = std::chrono::steady_clock::now();
  way.step(count);
  const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  best.wall_us = std::min(best.wall_us, 1e6 * wall_s / count);
  best.processor_us = std::min(best.processor_us, 1e6 * (processor_s() - before_s) / count);
}

struct NamedWay {
  const char* name;
  std::unique_ptr<Way> way;
  Measure best = {};
};

void compare(std::size_t robots, bool is_crowd) {
  using Stepping = Mujoco::Stepping;
  const trophic::test::TemporaryFolder folder;
  const Scene scene{robots, is_crowd};
  Mujoco walking{scene.spider, scene.arena, scene.starts, {}, {.stepping = Stepping::fast}};
  for (int tick = 0; tick < 300; ++tick) {
    aim(walking, tick / 60.0);
    walking.advance_to((tick + 1) / 60.0);
  }
  const Mujoco::State state = walking.save();
  const std::filesystem::path world = folder.path() / "world.xml";
  walking.save_mjcf(world);
  std::vector<NamedWay> ways;
  const auto add = [&](const char* name, std::unique_ptr<Way> way) { ways.push_back({name, std::move(way)}); };
  add("one model, its islands", std::make_unique<OneWorld>(world, robots, true, 1));
  add("one model, no islands", std::make_unique<OneWorld>(world, robots, false, 1));
  add("one model, its islands, 2 threads", std::make_unique<OneWorld>(world, robots, true, 2));
#if mjVERSION_HEADER >= 3017000
  if (!is_crowd) {
    add("its batch of single robots", std::make_unique<Batch>(scene, state, 1));
    add("its batch of single robots, 2 threads", std::make_unique<Batch>(scene, state, 2));
  }
#endif
  add("islands", std::make_unique<Backend>(scene, state, Stepping::islands, 1));
  add("islands, 2 threads", std::make_unique<Backend>(scene, state, Stepping::islands, 2));
  add("fast", std::make_unique<Backend>(scene, state, Stepping::fast, 1));
  add("fast, 2 threads", std::make_unique<Backend>(scene, state, Stepping::fast, 2));
  const int count = robots > 300 ? 14 : 42;
  for (int round = 0; round < 5; ++round) {
    for (NamedWay& one : ways) measure(one.best, count, *one.way);
  }
  std::vector<double> expected_m;
  for (NamedWay& one : ways) {
    one.way->start();
    one.way->step(10 * count);
    const std::vector<double> places_m = one.way->places_m();
    if (expected_m.empty()) expected_m = places_m;
    for (std::size_t i = 0; i < places_m.size(); ++i)
      one.best.off_m = std::max(one.best.off_m, std::abs(places_m[i] - expected_m[i]));
    std::printf("%6zu  %-6s  %-38s  %9.1f  %9.1f  %8.1e\n", robots, is_crowd ? "crowd" : "apart", one.name, one.best.wall_us,
                one.best.processor_us, one.best.off_m);
  }
  std::fflush(stdout);
}

}  // namespace

int main() {
  std::printf("MuJoCo %s; microseconds of a step\n%6s  %-6s  %-38s  %9s  %9s  %8s\n", mj_versionString(), "robots", "scene",
              "stepped by", "wall", "processor", "off, m");
  for (const std::size_t robots : {30U, 100U, 300U, 1000U}) {
    for (const bool is_crowd : {false, true}) compare(robots, is_crowd);
  }
}
