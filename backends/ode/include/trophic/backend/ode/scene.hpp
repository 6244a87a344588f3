// SPDX-License-Identifier: MIT
// An ODE world for a group of robots: a step is a function of their states alone.
#pragma once

#include <ode/ode.h>

#include <algorithm>
#include <mutex>
#include <new>
#include <trophic/backend/contract.hpp>
#include <trophic/backend/ode/bodies.hpp>
#include <trophic/backend/ode/contacts.hpp>
#include <trophic/backend/ode/engine.hpp>
#include <trophic/backend/ode/ground.hpp>
#include <trophic/backend/ode/params.hpp>
#include <trophic/backend/ode/robot.hpp>
#include <trophic/backend/ode/state.hpp>

namespace trophic::backend::ode {

/// The world holds no state between steps: each step loads the states of its robots, finds contacts, solves and stores.
/// Contacts are made in a fixed order, and ODE's random sequence, if used, restarts at each step. So a step is a function of
/// its input states.
class Scene {
 public:
  /// `kinds`: the kind of each robot in the scene.
  Scene(std::vector<KindPtr> kinds, const Arena& arena, const Physics& physics, const Params& params)
      : kinds_{std::move(kinds)},
        params_{params},
        timestep_s_{physics.timestep_s},
        arena_friction_{arena.friction},
        law_{params, physics.timestep_s},
        threading_{dThreadingAllocateSelfThreadedImplementation()},
        world_{dWorldCreate()},
        contacts_{dJointGroupCreate(0)},
        ground_{arena} {
    dWorldSetStepThreadingImplementation(world_.get(), dThreadingImplementationGetFunctions(threading_.get()), threading_.get());
    dWorldSetGravity(world_.get(), 0.0, 0.0, -physics.gravity_m_s2);
    dWorldSetAutoDisableFlag(world_.get(), 0);
    dWorldSetQuickStepNumIterations(world_.get(), params.sweeps);
    robots_.reserve(kinds_.size());
    for (const KindPtr& kind : kinds_) robots_.emplace_back(world_.get(), kind->model, params, physics.timestep_s);
  }

  /// One step of the robots `members` of a whole backend's state; `bodies`: the bodies of all robots. After an EngineError the
  /// scene must not be used again.
  void step(std::span<const std::size_t> members, const Bodies& bodies, State& state) {
    const auto links_of = [&](std::size_t robot) {
      return std::span{state.links}.subspan(bodies.first_link(robot), bodies.links(robot));
    };
    const auto hinges_of = [&](std::vector<double>& numbers, std::size_t robot) {
      return std::span{numbers}.subspan(bodies.first_hinge(robot), bodies.hinges(robot));
    };
    for (std::size_t i = 0; i < members.size(); ++i) {
      robots_[i].load(links_of(members[i]));
      robots_[i].set_servos(hinges_of(state.angles_rad, members[i]), hinges_of(state.targets_rad, members[i]));
    }
    find_contacts();
    solve();
    dJointGroupEmpty(contacts_.get());
    for (std::size_t i = 0; i < members.size(); ++i) {
      robots_[i].store(links_of(members[i]), hinges_of(state.angles_rad, members[i]));
    }
  }

 private:
  void find_contacts() {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const Robot& robot = robots_[i];
      const double friction = kinds_[i]->model.friction;
      const double ground_friction = std::max(friction, arena_friction_);
      for (const Robot::Geom& box : robot.geoms()) {
        ground_.for_each_near(dGeomGetPosition(box.geom.get()), box.radius_m, [&](dGeomID ground) {
          law_.touch(world_.get(), contacts_.get(), ground, box.geom.get(), ground_friction);
        });
      }
      for (const auto& [a, b] : robot.self_pairs()) touch(robot.geoms()[a], robot.geoms()[b], friction);
    }
    for (std::size_t a = 0; a < robots_.size(); ++a) {
      for (std::size_t b = a + 1; b < robots_.size(); ++b) {
        const double reach_m = kinds_[a]->reach_m + kinds_[b]->reach_m;
        const double friction = std::max(kinds_[a]->model.friction, kinds_[b]->model.friction);
        if (!near(dBodyGetPosition(robots_[a].bodies()[0]), dBodyGetPosition(robots_[b].bodies()[0]), reach_m)) continue;
        for (const Robot::Geom& own : robots_[a].geoms()) {
          for (const Robot::Geom& other : robots_[b].geoms()) touch(own, other, friction);
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

  void touch(const Robot::Geom& a, const Robot::Geom& b, double friction) {
    if (!near(dGeomGetPosition(a.geom.get()), dGeomGetPosition(b.geom.get()), a.radius_m + b.radius_m)) return;
    law_.touch(world_.get(), contacts_.get(), a.geom.get(), b.geom.get(), friction);
  }

  /// Throws std::bad_alloc if ODE has no memory for a step. ODE itself would skip the step.
  void solve() {
    if (!has_solved()) throw std::bad_alloc{};
  }

  [[nodiscard]] bool has_solved() {
    if (params_.solver == Solver::world_step) return dWorldStep(world_.get(), timestep_s_) != 0;
    if (params_.sweeps <= sweeps_without_draws) return dWorldQuickStep(world_.get(), timestep_s_) != 0;
    const std::lock_guard lock{random_sequence_mutex()};
    dRandSetSeed(0);
    return dWorldQuickStep(world_.get(), timestep_s_) != 0;
  }

  std::vector<KindPtr> kinds_;
  const Params& params_;
  double timestep_s_;
  double arena_friction_;
  ContactLaw law_;
  ThreadingPtr threading_;
  WorldPtr world_;
  GroupPtr contacts_;
  Ground ground_;
  std::vector<Robot> robots_;
};

}  // namespace trophic::backend::ode
