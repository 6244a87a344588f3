// SPDX-License-Identifier: MIT
// The MuJoCo backend: modular robots as rigid bodies with contacts, friction and servos.
#pragma once

#include <cstddef>
#include <filesystem>
#include <trophic/backend/mujoco/box_depth.hpp>
#include <trophic/backend/with_engine.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/colour.hpp>
#include <vector>

namespace trophic::backend {

namespace mujoco {

/// The state that determines the further run, including warm starts of the solver and servo targets.
struct State {
  std::uint64_t steps = 0;
  std::vector<double> robots;         ///< RobotStates::values
  std::vector<double> targets_rad;    ///< robot by robot
  std::vector<std::uint64_t> bodies;  ///< body_hash of each robot
  std::vector<std::uint64_t> absent;  ///< robots that are not in the world, ascending

  friend bool operator==(const State&, const State&) = default;
  static constexpr auto saved() {
    return std::tuple{&State::steps, &State::robots, &State::targets_rad, &State::bodies, &State::absent};
  }
};

}  // namespace mujoco

/// Robots in MuJoCo (Newton solver, pyramidal friction cone, one position servo per hinge). Satisfies Embodying and Placing.
///
/// Units: positions m, angles rad, velocities m/s and rad/s, torques N m. No random draws. Results are bitwise independent of
/// `Params::threads`; `fast`, `islands` and `one_model` agree to rounding, which contacts amplify slowly. Errors:
/// std::invalid_argument on construction; Diverged if MuJoCo warns or a robot leaves the arena; the backend then still holds the
/// last valid state. Must not be called from several threads at once; several backends may run in several threads.
class Mujoco : public WithEngine<mujoco::State> {
 public:
  static constexpr std::string_view name = "mujoco";
  [[nodiscard]] static std::string version();
  [[nodiscard]] static std::vector<std::string> remarks(const Physics&) { return {}; }

  /// The division of robots into MuJoCo models.
  enum class Stepping {
    fast,       ///< like islands, but a kernel with the results of mj_step steps the robots
    islands,    ///< robots that cannot touch are stepped separately, in several threads
    one_model,  ///< all in one model, stepped by mj_step in one thread: the reference
    screening   ///< like fast, but in single precision and with longer steps: for previews, not for results
  };
  friend constexpr std::array<std::string_view, 4> enum_names(Stepping) { return {"fast", "islands", "one_model", "screening"}; }

  /// The timestep of screening: the distances of 24 random gaits are within 5 % of those with steps of 0.0003 s (median).
  static constexpr double screening_timestep_s = 0.002;

  struct Params {
    using Backend = Mujoco;
    Stepping stepping = Stepping::fast;
    std::size_t threads = 1;
    mujoco::BoxDepth box_depth = mujoco::BoxDepth::engine;

    static constexpr auto fields() {
      return std::tuple{
          field("stepping", &Params::stepping,
                "fast, islands (MuJoCo only), one_model (the reference) or screening (single precision, 0.002 s steps)"),
          field("threads", &Params::threads, between(1, 1024), "threads for fast and islands; results do not depend on it"),
          field("box_depth", &Params::box_depth,
                "reported depth of box-face contacts: engine (half, up to MuJoCo 3.3.7) or whole")};
    }

    /// Screening sets the time step; other modes set nothing. See BackendChoice::prescribe.
    [[nodiscard]] std::string prescribe(Physics& physics, const Physics& table) const;
  };

  Mujoco(const RobotModel& robot, const Arena& arena, std::span<const Pose> starts, const Physics& physics, const Params& params);

  /// The share of robots' steps so far that `mj_step` computed, between 0 and 1: small for `fast` if the kernel supports the
  /// bodies. Not part of the state.
  [[nodiscard]] double engine_share() const;
  /// A sentence if `fast` was not fast because `mj_step` computed most steps so far; otherwise, if `asked`, a profile of the
  /// kernel's steps, or empty.
  [[nodiscard]] std::string speed_remark(bool asked = false) const;

  /// Writes the current world as a MuJoCo model, all robots in one model with a key frame of angles, velocities and targets,
  /// which MuJoCo's `simulate` opens. The heights of a height field go into a binary file next to it. `colours`: one per robot;
  /// missing ones are orange. Throws std::runtime_error, also if the file exists.
  void save_mjcf(const std::filesystem::path& path, std::span<const Colour> colours = {}) const;

 private:
  class Simulation;
};

static_assert(Embodying<Mujoco> && Placing<Mujoco>);

}  // namespace trophic::backend

#if TROPHIC_HEADER_ONLY
#include <trophic/backend/mujoco.ipp>
#endif
