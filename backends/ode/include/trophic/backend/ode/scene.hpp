// SPDX-License-Identifier: MIT
// An ODE world for a group of robots: a step is a function of their states alone.
#pragma once

#include <ode/ode.h>

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <span>
#include <trophic/backend/contract.hpp>
#include <trophic/backend/ode/contacts.hpp>
#include <trophic/backend/ode/engine.hpp>
#include <trophic/backend/ode/ground.hpp>
#include <trophic/backend/ode/params.hpp>
#include <trophic/backend/ode/robot.hpp>
#include <trophic/backend/ode/state.hpp>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <vector>

namespace trophic::backend::ode {

/// The world holds no state between steps: each step loads the states of its robots, finds contacts, solves and stores.
/// Contacts are made in a fixed order, and ODE's random sequence, if used, restarts at each step. So a step is a function of
/// its input states.
class Scene {
 public:
  Scene(const RobotModel& model, const Arena& arena, const Physics& physics, const Params& params, std::size_t robots)
      : model_{model},
        params_{params},
        timestep_s_{physics.timestep_s},
        ground_friction_{std::max(model.friction, arena.friction)},
        law_{params, physics.timestep_s},
        threading_{dThreadingAllocateSelfThreadedImplementation()},
        world_{dWorldCreate()},
        contacts_{dJointGroupCreate(0)},
        ground_{arena} {
    dWorldSetStepThreadingImplementation(world_.get(), dThreadingImplementationGetFunctions(threading_.get()), threading_.get());
    dWorldSetGravity(world_.get(), 0.0, 0.0, -physics.gravity_m_s2);
    dWorldSetAutoDisableFlag(world_.get(), 0);
    dWorldSetQuickStepNumIterations(world_.get(), params.sweeps);
    robots_.reserve(robots);
    for (std::size_t i = 0; i < robots; ++i) robots_.emplace_back(world_.get(), model, params, physics.timestep_s);
  }

  /// One step of the robots `members` of a whole backend's state. After an EngineError the scene must not be used again.
  void step(std::span<const std::size_t> members, State& state) {
    const std::size_t links = model_.links.size();
    const std::size_t hinges = model_.hinges.size();
    for (std::size_t i = 0; i < members.size(); ++i) {
      robots_[i].load(std::span{state.links}.subspan(members[i] * links, links));
      robots_[i].set_servos(std::span{state.angles_rad}.subspan(members[i] * hinges, hinges),
                            std::span{state.targets_rad}.subspan(members[i] * hinges, hinges));
    }
    find_contacts();
    solve();
    dJointGroupEmpty(contacts_.get());
    for (std::size_t i = 0; i < members.size(); ++i) {
      robots_[i].store(std::span{state.links}.subspan(members[i] * links, links),
                       std::span{state.angles_rad}.subspan(members[i] * hinges, hinges));
    }
  }

 private:
  void find_contacts() {
    for (const Robot& robot : robots_) {
      for (const Robot::Geom& box : robot.geoms()) {
        ground_.for_each_near(dGeomGetPosition(box.geom.get()), box.radius_m, [&](dGeomID ground) {
          law_.touch(world_.get(), contacts_.get(), ground, box.geom.get(), ground_friction_);
        });
      }
      for (const auto& [a, b] : robot.self_pairs()) touch(robot.geoms()[a], robot.geoms()[b]);
    }
    for (std::size_t a = 0; a < robots_.size(); ++a) {
      for (std::size_t b = a + 1; b < robots_.size(); ++b) {
        const double reach_m = 2.0 * (model_.bounding_radius_m + model_.links[0].centre_of_mass_m.norm());
        if (!near(dBodyGetPosition(robots_[a].bodies()[0]), dBodyGetPosition(robots_[b].bodies()[0]), reach_m)) continue;
        for (const Robot::Geom& own : robots_[a].geoms()) {
          for (const Robot::Geom& other : robots_[b].geoms()) touch(own, other);
        }
      }
    }
  }

  [[nodiscard]] static bool near(const double* a, const double* b, double reach_m) {
    const double dx = a[0] - b[0];
    const double dy = a[1] - b[1];
    const double dz = a[2] - b[2];
    return dx * dx + dy * dy + dz * dz < reach_m * reach_m;
  }

  void touch(const Robot::Geom& a, const Robot::Geom& b) {
    if (!near(dGeomGetPosition(a.geom.get()), dGeomGetPosition(b.geom.get()), a.radius_m + b.radius_m)) return;
    law_.touch(world_.get(), contacts_.get(), a.geom.get(), b.geom.get(), model_.friction);
  }

  void solve() {
    if (params_.solver == Solver::world_step) {
      dWorldStep(world_.get(), timestep_s_);
    } else if (params_.sweeps <= sweeps_without_draws) {
      dWorldQuickStep(world_.get(), timestep_s_);
    } else {
      const std::lock_guard lock{random_sequence_mutex()};
      dRandSetSeed(0);
      dWorldQuickStep(world_.get(), timestep_s_);
    }
  }

  const RobotModel& model_;
  const Params& params_;
  double timestep_s_;
  double ground_friction_;
  ContactLaw law_;
  ThreadingPtr threading_;
  WorldPtr world_;
  GroupPtr contacts_;
  Ground ground_;
  std::vector<Robot> robots_;
};

}  // namespace trophic::backend::ode
