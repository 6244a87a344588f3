// SPDX-License-Identifier: MIT
// Steps one group of robots in one MuJoCo model and reports how it ended.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <trophic/backend/mujoco/compiled_model.hpp>
#include <trophic/backend/mujoco/robot_states.hpp>
#include <trophic/params/params.hpp>

namespace trophic::backend::mujoco {

/// How a group's step ended. Only `done` leaves a valid state.
struct GroupResult {
  enum class End {
    done,
    left_disc,     ///< a robot moved farther than its slack and may have touched robots outside the group
    buffers_full,  ///< more contacts than the capacity of the model
    diverged
  };
  End end = End::done;
  std::size_t steps = 0;  ///< whole steps before the end
  std::size_t robot = 0;  ///< the affected robot, except for `done`
  std::string what;
  double speed_m_s = 0.0;          ///< speed of that robot's root, for `left_disc`
  CompiledModel* model = nullptr;  ///< the model, for `buffers_full`
};

/// Whether a MuJoCo warning means that its buffers are full.
[[nodiscard]] inline bool is_full(int kind) {
  return kind == mjWARN_CONTACTFULL || kind == mjWARN_CNSTRFULL;
}

/// The text of a MuJoCo warning. MuJoCo writes its own text into a buffer that all threads share.
[[nodiscard]] inline std::string warning_text(int kind) {
  if (kind == mjWARN_INERTIA) return "its inertia matrix is nearly singular";
  if (is_full(kind)) return "it touches too much at once: its contacts do not fit into MuJoCo's largest model, 2^31 bytes";
  const std::string what = kind == mjWARN_BADQPOS   ? "a position"
                           : kind == mjWARN_BADQVEL ? "a velocity"
                           : kind == mjWARN_BADQACC ? "an acceleration"
                           : kind == mjWARN_BADCTRL ? "a servo's target"
                                                    : "";
  return what.empty() ? "warning " + std::to_string(kind) + " of MuJoCo" : what + " is NaN or too large";
}

/// An error of MuJoCo in the model of these robots; it names no robot, so the first is reported.
[[nodiscard]] inline GroupResult read_error(const EngineError& error, std::span<const std::size_t> robots) {
  const std::string others =
      robots.size() == 1 ? "" : ", in the model of this robot and " + std::to_string(robots.size() - 1) + " others";
  return {.end = GroupResult::End::diverged, .robot = robots.front(), .what = error.what() + others};
}

/// The first warning in MuJoCo's counters, if any, as a result; `robots` are the group's.
[[nodiscard]] inline GroupResult read_warnings(const CompiledModel& compiled, const mjData& data,
                                               std::span<const std::size_t> robots) {
  for (int kind = 0; kind < mjNWARNING; ++kind) {
    if (data.warning[kind].number == 0) continue;
    const int info = data.warning[kind].lastinfo;
    GroupResult result{.end = GroupResult::End::diverged, .robot = robots.front(), .what = warning_text(kind)};
    const auto begin = kind == mjWARN_BADQPOS ? &Share::position : kind == mjWARN_BADCTRL ? &Share::control : &Share::velocity;
    if (is_full(kind)) {
      result.end = GroupResult::End::buffers_full;
    } else if (info >= 0) {
      result.robot = robots[compiled.owner(begin, static_cast<std::size_t>(info))];
    }
    return result;
  }
  return {};
}

/// Takes `steps` steps of the listed robots, from the states in `from` to those in `to`, under the servo targets `targets_rad`.
/// `slack_m`: the largest horizontal displacement of each robot; empty: no limit.
[[nodiscard]] inline GroupResult step_group(CompiledModel& compiled, std::span<const std::size_t> robots, const Rows& targets_rad,
                                            std::span<const double> slack_m, std::size_t steps, const RobotStates& from,
                                            RobotStates& to) {
  const std::span<const Share> shares = compiled.shares();
  const CompiledModel::Turn turn{compiled};
  mjData& data = turn.data();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    from.load(robots[i], shares[i], data);
    std::ranges::copy(targets_rad[robots[i]], data.ctrl + shares[i].control);
  }

  const auto check = [&]() -> GroupResult {
    if (GroupResult result = read_warnings(compiled, data, robots); result.end != GroupResult::End::done) return result;
    if (slack_m.empty()) return {};
    for (std::size_t i = 0; i < robots.size(); ++i) {
      const double* now = data.qpos + shares[i].position;
      const std::span<const double> start = from.positions(robots[i]);
      if (std::hypot(now[0] - start[0], now[1] - start[1]) > slack_m[robots[i]]) {
        const double* velocity = data.qvel + shares[i].velocity;
        return {.end = GroupResult::End::left_disc,
                .robot = robots[i],
                .what = {},
                .speed_m_s = std::hypot(velocity[0], velocity[1], velocity[2])};
      }
    }
    return {};
  };

  GroupResult result;
  const EngineGuard guard;
  try {
    for (std::size_t step = 0; step < steps && result.end == GroupResult::End::done; ++step) {
      mj_step(&compiled.model(), &data);
      result = check();
      result.steps = step;
    }
  } catch (const EngineError& error) {
    const std::size_t whole = result.steps;
    result = read_error(error, robots);
    result.steps = whole;
  }
  for (std::size_t i = 0; i < robots.size() && result.end == GroupResult::End::done; ++i) {
    to.store(robots[i], shares[i], data);
    if (std::string fault = to.fault(robots[i]); !fault.empty()) {
      result = {.end = GroupResult::End::diverged, .steps = steps, .robot = robots[i], .what = std::move(fault)};
    }
  }
  if (result.end == GroupResult::End::buffers_full) result.model = &compiled;
  if (result.end == GroupResult::End::diverged) mj_resetData(&compiled.model(), &data);
  std::ranges::fill(data.warning, mjWarningStat{});
  return result;
}

}  // namespace trophic::backend::mujoco
