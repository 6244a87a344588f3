// SPDX-License-Identifier: MIT
// Definitions of recording.hpp.
#pragma once

#include <trophic/io/recording.hpp>
#include <trophic/io/recording_head.hpp>
#include <trophic/io/recording_planes.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/json.hpp>

namespace trophic::io {

namespace recording {

TROPHIC_INLINE Json json_of(const RobotModel& robot) {
  const auto vector = [](const Eigen::Vector3d& v) { return Json{v.x(), v.y(), v.z()}; };
  const auto rotation = [](const Eigen::Quaterniond& q) { return Json{q.w(), q.x(), q.y(), q.z()}; };
  Json json{{"name", robot.name},
            {"forward_rad", robot.forward_rad},
            {"bounding_radius_m", robot.bounding_radius_m},
            {"links", Json::array()}};
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const Link& link = robot.links[i];
    Json one{{"name", link.name},
             {"parent", link.parent},
             {"offset_m", vector(link.offset_m)},
             {"rotation", rotation(link.rotation)},
             {"boxes", Json::array()}};
    if (i > 0) one["hinge"] = {{"name", robot.hinges[i - 1].name}, {"axis", vector(robot.hinges[i - 1].axis)}};
    for (const Box& box : link.boxes) {
      one["boxes"].push_back({{"part", box.part},
                              {"half_extents_m", vector(box.half_extents_m)},
                              {"centre_m", vector(box.centre_m)},
                              {"orientation", rotation(box.orientation)}});
    }
    json["links"].push_back(std::move(one));
  }
  return json;
}

TROPHIC_INLINE Json json_of(const Arena& arena) {
  Json json{{"name", arena.name}, {"half_side_m", arena.half_side_m}, {"extent_m", arena.extent_m}};
  if (arena.height_field)
    json["height_field"] = {{"nodes", arena.height_field->nodes},
                            {"half_extent_m", arena.height_field->half_extent_m},
                            {"height_m", arena.height_field->height_m}};
  if (!arena.obstacles.empty()) json["obstacles"] = Json::array();  // a null that becomes one crashes without memory
  for (const Obstacle& one : arena.obstacles)
    json["obstacles"].push_back({one.x_m, one.y_m, one.to_x_m, one.to_y_m, one.radius_m, one.height_m});
  if (!arena.zones.empty()) json["zones"] = Json::array();
  for (const Zone& zone : arena.zones)
    json["zones"].push_back({{"name", zone.name}, {"x_m", zone.x_m}, {"y_m", zone.y_m}, {"radius_m", zone.radius_m}});
  return json;
}

TROPHIC_INLINE Json json_of(const Units& units) {
  return {
      {"position_m", units.position_m}, {"yaw_rad", units.yaw_rad}, {"tilt_rad", units.tilt_rad}, {"joint_rad", units.joint_rad}};
}

}  // namespace recording

struct Recording::File {
  GrowingFile file;
  Json head = {};

  void write(std::string_view kind, std::string_view data) { file.append(recording::block(kind, data)); }
};

TROPHIC_INLINE Recording::Recording(const std::filesystem::path& path, double hz, Opening opening) : hz_{hz} {
  if (!(hz >= 0.0 && hz <= 1000.0)) {
    throw std::invalid_argument{"replay_hz = " + number_text(hz) + ": must be >= 0 and <= 1000"};
  }
  const bool has_file = opening == Opening::created ? hz > 0.0 : std::filesystem::exists(path);
  if (has_file) file_ = std::make_shared<File>(File{.file = GrowingFile{path, opening}});
}

TROPHIC_INLINE std::uint32_t Recording::checksum() const {
  return file_ ? file_->file.checksum() : 0;
}

TROPHIC_INLINE void Recording::on_start(const observe::RunDescription& run, const View& view) {
  if (!file_) return;
  const bool is_same_run = fingerprint_ == run.fingerprint && seed_ == run.seed;
  fingerprint_ = run.fingerprint;
  seed_ = run.seed;
  bodies_differ_ = run.bodies_differ;
  auto& head = file_->head;
  const int version = bodies_differ_ ? recording::version_of_bodies : recording::version;
  head = {{"format", "trophic recording"}, {"version", version},     {"fingerprint", run.fingerprint}, {"seed", run.seed},
          {"rule_table", run.rules},       {"backend", run.backend}, {"species", Json::array()}};
  for (Species species = 0; species < view.web.size(); ++species) head["species"].push_back(view.web.name(species));
  if (channels_ > 0 && !is_same_run) file_->write(recording::head_kind, json_text(head));
}

TROPHIC_INLINE void Recording::write_head(const observe::Frame& frame) {
  units_ = recording::Units::for_extent(frame.arena.extent_m);
  robots_ = frame.roots.size();
  std::size_t joints = 0;
  for (std::size_t robot = 0; robot < robots_; ++robot) joints = std::max(joints, frame.joint_angles(robot).size());
  channels_ = recording::pose_channels + joints;
  const std::int64_t per_tick = frame.times.per_tick(hz_);
  const double simulated_s = frame.times.tick_s * frame.times.clock_scale;
  const auto wanted = static_cast<std::size_t>(std::round(20.0 / simulated_s * static_cast<double>(per_tick)));
  block_frames_ = std::clamp<std::size_t>(most_block_values / (channels_ * robots_), 1, std::max<std::size_t>(wanted, 1));
  auto& head = file_->head;
  head["first_time_s"] = frame.time_s;
  head["tick_s"] = frame.times.tick_s;
  head["clock_scale"] = frame.times.clock_scale;
  head["frames_per_tick"] = per_tick;
  head["steps_per_tick"] = frame.times.steps;
  head["robots"] = robots_;
  head["joints"] = joints;
  head["units"] = recording::json_of(units_);
  head["robot"] = recording::json_of(frame.robot);
  head["arena"] = recording::json_of(frame.arena);
  file_->file.append(recording::magic);
  file_->write(recording::head_kind, json_text(head));
}

TROPHIC_INLINE void Recording::on_frame(const observe::Frame& frame) {
  if (!file_) return;
  if (channels_ == 0) write_head(frame);
  if (bodies_differ_) write_bodies(frame);
  const std::size_t joints = channels_ - recording::pose_channels;
  if (frame.roots.size() != robots_ || (!bodies_differ_ && frame.joint_angles_rad.size() / robots_ != joints)) {
    throw std::runtime_error{"recording: a frame whose robots or joints differ from its header"};
  }
  for (std::size_t robot = 0; robot < robots_; ++robot) {
    const auto pose = recording::whole(frame.roots[robot], units_);
    values_.insert(values_.end(), pose.begin(), pose.end());
    const std::span<const double> angles_rad = frame.joint_angles(robot);
    for (const double angle_rad : angles_rad) values_.push_back(recording::whole(angle_rad, units_.joint_rad));
    values_.resize(values_.size() + joints - angles_rad.size());
  }
  ++frames_;
  if (values_.size() / (channels_ * robots_) >= block_frames_) write_frames();
}

/// The bodies that were put in place since the last frame. A body with more joints than all previous ones begins a block.
TROPHIC_INLINE void Recording::write_bodies(const observe::Frame& frame) {
  std::string who;
  recording::append_u32(who, frames_);
  std::size_t most = channels_;
  constexpr std::uint64_t nobody = std::numeric_limits<std::uint64_t>::max();
  individual_.resize(robots_, nobody);
  std::string blocks;
  for (std::size_t robot = 0; robot < robots_; ++robot) {
    if (individual_[robot] == frame.phenotypes[robot].individual) continue;
    individual_[robot] = frame.phenotypes[robot].individual;
    const std::string text = json_text(recording::json_of(frame.model(robot)));
    const std::string hash = hash_text(text);
    const auto found = std::ranges::find(bodies_, hash);
    const auto number = static_cast<std::uint32_t>(found - bodies_.begin());
    if (found == bodies_.end()) {
      bodies_.push_back(hash);
      blocks += recording::block(recording::body_kind, text);
    }
    recording::append_u32(who, static_cast<std::uint32_t>(robot));
    recording::append_u32(who, number);
    most = std::max(most, recording::pose_channels + frame.joint_angles(robot).size());
  }
  if (who.size() == 4) return;
  if (most > channels_) {
    write_frames();
    channels_ = most;
  }
  file_->file.append(blocks + recording::block(recording::who_kind, who));
}

TROPHIC_INLINE void Recording::on_end(const View&) {
  if (!file_) return;
  write_frames();
  std::string frames;
  recording::append_u32(frames, frames_);
  file_->write(recording::end_kind, frames);
  file_->file.sync();
}

TROPHIC_INLINE void Recording::on_failure(std::string_view) {
  try {
    if (file_) write_frames();
  } catch (const std::runtime_error&) {
    // The disk is full, or a worse failure is reported elsewhere.
  }
}

/// The waiting frames in the format of a block.
TROPHIC_INLINE std::string Recording::waiting() const {
  const std::size_t columns = channels_ * robots_;
  const std::size_t frames = values_.size() / columns;
  // Channel by channel, as `packed` expects the columns.
  std::vector<std::int16_t> ordered(values_.size());
  for (std::size_t frame = 0; frame < frames; ++frame) {
    for (std::size_t robot = 0; robot < robots_; ++robot) {
      for (std::size_t channel = 0; channel < channels_; ++channel) {
        ordered[frame * columns + channel * robots_ + robot] = values_[frame * columns + robot * channels_ + channel];
      }
    }
  }
  const bool has_joints = channels_ > recording::pose_channels;
  return recording::packed(ordered, columns, has_joints ? recording::Effort::small : recording::Effort::fast);
}

TROPHIC_INLINE void Recording::write_frames() {
  if (values_.empty()) return;
  const auto frames = static_cast<std::uint32_t>(values_.size() / (channels_ * robots_));
  std::string data;
  recording::append_u32(data, frames_ - frames);
  recording::append_u32(data, frames);
  if (bodies_differ_) recording::append_u32(data, static_cast<std::uint32_t>(channels_));
  data.append(waiting());
  values_.clear();
  file_->write(recording::frames_kind, data);
}

TROPHIC_INLINE void Recording::persist(Archive& archive) {
  archive(hz_);
  Archive::require((hz_ > 0.0) == (file_ != nullptr),
                   "a recording with a different rate, or no recording although there was one");
  if (!file_) return;
  archive(file_->file, units_, channels_, robots_, block_frames_, fingerprint_, seed_, frames_);
  archive(bodies_differ_, bodies_, individual_);
  std::string bytes = values_.empty() ? std::string{} : waiting();
  std::uint64_t waiting_frames = channels_ * robots_ == 0 ? 0 : values_.size() / (channels_ * robots_);
  if (bodies_differ_) archive(waiting_frames);
  archive(bytes);
  if (!archive.reads()) return;
  values_.clear();
  if (channels_ == 0 && frames_ == 0 && bytes.empty()) return;  // it has not begun
  Archive::require(channels_ >= recording::pose_channels && robots_ > 0 && block_frames_ > 0, "a recording without channels");
  Archive::require(block_frames_ == 1 || block_frames_ <= most_block_values / channels_ / robots_, "a recording of large blocks");
  if (bytes.empty()) return;
  const std::size_t most = recording::most_values(bytes.size());
  const std::size_t frames = bodies_differ_ ? waiting_frames : frames_ % block_frames_;
  Archive::require(frames > 0 && frames < block_frames_ && frames <= most / channels_ / robots_,
                   "more frames of a recording than its bytes can hold");
  const std::size_t columns = channels_ * robots_;
  const std::vector<std::int16_t> ordered = recording::unpacked(bytes, columns, frames);
  values_.resize(ordered.size());
  for (std::size_t robot = 0; robot < robots_; ++robot) {
    for (std::size_t channel = 0; channel < channels_; ++channel) {
      for (std::size_t frame = 0; frame < frames; ++frame) {
        values_[frame * columns + robot * channels_ + channel] = ordered[(channel * robots_ + robot) * frames + frame];
      }
    }
  }
}

}  // namespace trophic::io
