// SPDX-License-Identifier: MIT
// The model of each robot, and the indices of its numbers in a backend's state.
#pragma once

#include <algorithm>
#include <memory>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/params/numbers_text.hpp>

namespace trophic::backend::ode {

/// A body that one or more robots have.
struct Kind {
  RobotModel model;
  std::string numbers;   ///< equal texts mean equal bodies
  double reach_m = 0.0;  ///< largest distance from the root link's centre of mass to a point of the body
};
using KindPtr = std::shared_ptr<const Kind>;

/// The kind of each robot. A kind that is no longer used is freed.
class Bodies {
 public:
  Bodies(const RobotModel& model, std::size_t robots) : kinds_(robots, make(model)) { place(); }

  /// Gives a robot a different body.
  void replace(std::size_t robot, const RobotModel& model) {
    KindPtr kind = make(model);
    const auto same = [&](const KindPtr& one) { return one->model.name == kind->model.name && one->numbers == kind->numbers; };
    if (const auto found = std::ranges::find_if(kinds_, same); found != kinds_.end()) kind = *found;
    kinds_[robot] = std::move(kind);
    place();
  }

  [[nodiscard]] std::size_t size() const { return kinds_.size(); }
  [[nodiscard]] const KindPtr& kind(std::size_t robot) const { return kinds_[robot]; }
  [[nodiscard]] const RobotModel& model(std::size_t robot) const { return kinds_[robot]->model; }

  /// The index of a robot's first entry in lists of all links or all hinges; for the robot after the last one, their length.
  [[nodiscard]] std::size_t first_link(std::size_t robot) const { return first_link_[robot]; }
  [[nodiscard]] std::size_t first_hinge(std::size_t robot) const { return first_hinge_[robot]; }
  [[nodiscard]] std::size_t links(std::size_t robot) const { return model(robot).links.size(); }
  [[nodiscard]] std::size_t hinges(std::size_t robot) const { return model(robot).hinges.size(); }

 private:
  [[nodiscard]] static KindPtr make(const RobotModel& model) {
    return std::make_shared<Kind>(Kind{.model = model,
                                       .numbers = numbers_text(model),
                                       .reach_m = model.bounding_radius_m + model.links[0].centre_of_mass_m.norm()});
  }

  void place() {
    first_link_.assign(1, 0);
    first_hinge_.assign(1, 0);
    for (std::size_t robot = 0; robot < size(); ++robot) {
      first_link_.push_back(first_link_.back() + links(robot));
      first_hinge_.push_back(first_hinge_.back() + hinges(robot));
    }
  }

  std::vector<KindPtr> kinds_;
  std::vector<std::size_t> first_link_;
  std::vector<std::size_t> first_hinge_;
};

}  // namespace trophic::backend::ode
