// SPDX-License-Identifier: MIT
// Definitions of sight.hpp.
#include <tools/live/src/sight.hpp>

#include <stdexcept>
#include <trophic/io/agent_log.hpp>
#include <utility>

namespace trophic::live {

void Sight::begin(const command::LiveRun& run) {
  facts_ = std::make_shared<RunFacts>();
  facts_->run = run;
  sight_ = std::make_shared<TickSight>();
  is_full_ = true;
}

void Sight::on_start(const observe::RunDescription& run, const View& view) {
  if (run.bodies_differ) {
    throw std::invalid_argument{
        "--live: robots with bodies of their own: must be shown by --watch, trophic film or trophic export"};
  }
  facts_->description = run;
  facts_->robots = view.robots.size();
  for (Species species = 0; species < view.web.size(); ++species) facts_->species.push_back(view.web.name(species));
  for (const Feeding& link : view.web.links()) facts_->hunters.push_back(view.web.name(link.hunter));
  steering_.begin(view.tick_s);
}

void Sight::on_frame(const observe::Frame& frame) {
  if (!facts_->robot) {
    facts_->robot = frame.robot;
    facts_->arena = frame.arena;
    facts_->times = frame.times;
    facts_->joints = frame.joint_angles_rad.size() / frame.roots.size();
    server_.begin(facts_message(*facts_));
    steering_.set_visible();
  }
  sight_->frames.push_back({.time_s = frame.time_s,
                            .roots = {frame.roots.begin(), frame.roots.end()},
                            .angles_rad = {frame.joint_angles_rad.begin(), frame.joint_angles_rad.end()}});
}

void Sight::on_event(const observe::Event& event, const View& view) {
  const Individual& self = event.individual;
  const bool is_catch = event.kind == observe::EventKind::capture;
  sight_->events.push_back({.time_s = view.time_s,
                            .tick = view.tick,
                            .kind = event.kind,
                            .id = self.id,
                            .species = self.species,
                            .body = event.body,
                            .tag = self.tag,
                            .active = self.active,
                            .origin = self.origin,
                            .parent = self.parent,
                            .genome = self.genome->id,
                            .cause = event.cause,
                            .killer = is_catch ? std::nullopt : event.other,
                            .victim = is_catch ? event.other : std::nullopt,
                            .x_m = view.poses[event.body].x_m,
                            .y_m = view.poses[event.body].y_m});
}

void Sight::on_tick(const View& view) {
  sight_->time_s = view.time_s;
  sight_->tick = view.tick;
  if (is_full_) {
    sight_->rows.reserve(view.robots.size());
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      sight_->rows.push_back(io::agent_row(view, body));
      sight_->are_spare.push_back(!view.robots[body].lives());
    }
  }
  server_.show(std::exchange(sight_, std::make_shared<TickSight>()), facts_);
  const double now_s = watch_.elapsed_s();
  if (is_full_) last_full_s_ = now_s;
  sight_->is_last = view.time_s + 1.5 * view.tick_s > facts_->run.until_s;
  is_full_ = sight_->is_last || steering_.is_paced() || now_s - last_full_s_ >= least_gap_s;
}

}  // namespace trophic::live
