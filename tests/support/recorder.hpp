// SPDX-License-Identifier: MIT
// An observer that writes down all calls, so that two runs can be compared to the last bit.
#pragma once

#include <trophic/observe/event.hpp>
#include <trophic/params/params.hpp>
#include <trophic/population/view.hpp>

namespace trophic::test {

/// One line for each event, and for each tick one line with all poses, tags and adversaries.
class Recorder {
 public:
  void on_event(const observe::Event& event, const View& view) {
    const Individual& who = event.individual;
    std::string line = number_text(view.tick) + " " + std::string{enum_name(event.kind)} + " body " + number_text(event.body) +
                       " id " + number_text(who.id) + " species " + number_text(who.species);
    if (event.cause) line += " " + std::string{enum_name(*event.cause)};
    if (event.other) line += " other " + number_text(*event.other);
    events.push_back(line);
    line += " tag " + number_text(who.tag) + " " + std::string{enum_name(who.origin)} + " genome " + number_text(who.genome->id);
    if (who.parent()) line += " parent " + number_text(*who.parent());
    for (const double weight : who.genome->weights) line += " " + number_text(weight);
    all.push_back(line);
  }

  void on_tick(const View& view) {
    std::string line = number_text(view.tick) + " tick";
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      const GroundPose& pose = view.poses[body];
      const Individual& who = view.robots[body];
      line += " | " + number_text(pose.x_m) + " " + number_text(pose.y_m) + " " + number_text(pose.heading_rad) + " " +
              number_text(who.tag) + " " + number_text(who.target_angle_rad);
      if (who.adversary) line += " " + number_text(*who.adversary) + " " + number_text(who.adversary_distance_m);
    }
    all.push_back(line);
  }

  std::vector<std::string> events;  ///< "TICK KIND body B id I species S [CAUSE] [other O]"
  std::vector<std::string> all;     ///< events with tags, origins and genomes, and ticks
};

}  // namespace trophic::test
