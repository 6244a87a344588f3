// SPDX-License-Identifier: MIT
// senses.csv: contacts of every robot, and inputs and outputs of its brain, at every tick or every n-th tick.
#pragma once

#include <trophic/habitat/pose.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/habitat/touch.hpp>
#include <trophic/io/csv_file.hpp>
#include <trophic/io/tables.hpp>
#include <trophic/observe/decision_record.hpp>
#include <trophic/observe/frame.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/population/spatial_grid.hpp>
#include <trophic/population/view.hpp>

namespace trophic::io {

/// Writes a SenseRow per robot at the ticks whose number is a multiple of `every_ticks`. Height, tilt and contacts are those at
/// the moment at which rules act, from the shapes and poses of the bodies, and are empty if bodies have no joints. The inputs of
/// a brain are empty at ticks without an evaluation, and beyond the inputs of its species.
class SenseLog {
 public:
  static constexpr std::string_view file_name = "senses.csv";

  /// `every_ticks` >= 1. The file is made when the run starts, which determines the numbers of a brain's inputs and outputs.
  explicit SenseLog(std::filesystem::path path, Opening opening = Opening::created, std::int64_t every_ticks = 1)
      : path_{std::move(path)}, every_ticks_{every_ticks} {
    if (opening == Opening::resumed) file_.emplace(path_, opening);
  }

  void on_start(const observe::RunDescription& run, const View& view) {
    inputs_ = run.inputs.size();
    outputs_ = run.outputs;
    if (!file_) file_.emplace(path_, unasked());
    rows_.assign(view.robots.size(), unasked());
    exempt_.assign(view.robots.size(), std::nullopt);
  }

  [[nodiscard]] bool wants_decisions() const { return true; }
  void on_decision(const observe::DecisionRecord& record, const View&) {
    SenseRow& row = rows_[record.body];
    row.chosen_tag = record.tag;
    const TagOutcome changed = record.might_switch ? TagOutcome::switched : TagOutcome::denied;
    row.tag_outcome = record.tag == record.tag_before ? TagOutcome::kept : changed;
    std::size_t other = 0;
    for (std::size_t i = 0; i < record.outputs.size(); ++i) {
      const std::string_view name = outputs_.empty() ? std::array{"turn", "tag"}.at(i) : std::string_view{outputs_.at(i)};
      (name == "turn"  ? row.angle_output.emplace()
       : name == "tag" ? row.tag_output.emplace()
                       : row.outputs.values[other++]) = record.outputs[i];
    }
    std::ranges::copy(record.inputs, row.inputs.begin());
  }

  void on_exemption(BodyIndex hunter, const View& view) { exempt_[hunter] = view.robots[hunter].id; }

  /// One frame per tick is enough: the one at which rules act is always the last.
  [[nodiscard]] double frame_hz() const { return once_a_tick_hz; }
  void on_frame(const observe::Frame& frame) {
    if (frame.joint_angles_rad.empty()) return;
    robots_.clear();
    for (std::size_t body = 0; body < frame.phenotypes.size(); ++body) robots_.push_back(frame.phenotypes[body].robot);
    if (!robot_) robot_ = frame.robot;
    roots_.assign(frame.roots.begin(), frame.roots.end());
    joint_angles_rad_.clear();
    for (std::size_t body = 0; body < roots_.size(); ++body) {
      const auto own = frame.joint_angles(body);
      joint_angles_rad_.emplace_back(own.begin(), own.end());
    }
  }

  void on_tick(const View& view) {
    if (view.tick % every_ticks_ == 0) write(view);
    std::ranges::fill(rows_, unasked());
    std::ranges::fill(exempt_, std::nullopt);
  }

  void persist(Archive& archive) {
    if (!file_) throw std::runtime_error{path_.string() + ": the run had not begun, so there is no file to resume"};
    archive(*file_);
  }
  [[nodiscard]] TableSum sum() const { return file_ ? file_->sum() : TableSum{}; }

 private:
  static constexpr double once_a_tick_hz = 1e-9;

  /// The row of a brain that was not evaluated.
  [[nodiscard]] SenseRow unasked() const {
    SenseRow row;
    row.inputs.assign(inputs_, std::numeric_limits<double>::quiet_NaN());
    for (const std::string& name : outputs_) {
      if (name != "turn" && name != "tag") row.outputs.names.push_back(name);
    }
    row.outputs.values.assign(row.outputs.names.size(), std::numeric_limits<double>::quiet_NaN());
    return row;
  }

  void write(const View& view) {
    look_at_bodies(view);
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      const Individual& self = view.robots[body];
      if (!self.lives()) continue;
      SenseRow& row = rows_[body];
      row.time_s = view.time_s;
      row.tick = view.tick;
      row.body = body;
      row.id = self.id;
      row.species = self.species;
      if (view.web.hunts(self.species)) row.exempt = exempt_[body] == self.id;
      file_->write(row, view.web);
    }
    file_->flush();
  }

  [[nodiscard]] const RobotModel& robot_in(BodyIndex body) const {
    return robots_.empty() || !robots_[body] ? *robot_ : *robots_[body];
  }

  void look_at_bodies(const View& view) {
    if (!robot_ || roots_.size() != view.robots.size()) return;
    double largest_m = 0.0;
    std::vector<std::vector<PlacedBox>> bodies;
    std::vector<GroundPose> centres;
    for (BodyIndex body = 0; body < roots_.size(); ++body) {
      const Pose& root = roots_[body];
      bodies.push_back(placed_boxes(robot_in(body), root, joint_angles_rad_[body]));
      largest_m = std::max(largest_m, robot_in(body).bounding_radius_m);
      centres.push_back({.x_m = root.position_m.x(), .y_m = root.position_m.y()});
      const double upright = (root.orientation.normalized() * Eigen::Vector3d::UnitZ()).z();
      rows_[body].height_m = root.position_m.z();
      rows_[body].tilt_rad = std::acos(std::clamp(upright, -1.0, 1.0));
      rows_[body].touches_wall = touch_wall(bodies.back(), view.arena.half_side_m) || touch(bodies.back(), view.arena.obstacles);
      rows_[body].robots_touched = 0;
    }
    const SpatialGrid grid{centres};
    for (BodyIndex body = 0; body < bodies.size(); ++body) {
      grid.for_each_near(centres[body].x_m, centres[body].y_m, robot_in(body).bounding_radius_m + largest_m,
                         [&](BodyIndex other) {
                           if (other <= body || !touch(bodies[body], bodies[other])) return;
                           ++*rows_[body].robots_touched;
                           ++*rows_[other].robots_touched;
                         });
    }
  }

  std::filesystem::path path_;
  std::int64_t every_ticks_;
  std::optional<CsvFile<SenseRow>> file_;
  std::size_t inputs_ = 0;
  std::vector<std::string> outputs_ = {};            ///< names; empty if turn and tag are the only outputs
  std::vector<SenseRow> rows_;                       ///< rows of the current tick, by body
  std::vector<std::optional<IndividualId>> exempt_;  ///< the exempt individual of each body
  std::optional<RobotModel> robot_;                  ///< empty on a backend without joints
  std::vector<Pose> roots_;
  std::vector<std::vector<double>> joint_angles_rad_;
  std::vector<std::shared_ptr<const RobotModel>> robots_;  ///< one per body, if they differ
};

}  // namespace trophic::io
