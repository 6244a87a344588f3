// SPDX-License-Identifier: MIT
// Definitions of read_recording.hpp.
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <new>
#include <tools/recording/read_recording.hpp>
#include <trophic/io/recording_planes.hpp>
#include <trophic/support/checksum.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/plain_text.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::io {

namespace recording {

/// Bounds below which no product of a recording's numbers overflows. The number of robots is bounded by the bytes of the
/// first frames.
inline constexpr std::size_t most_robots = 0xFFFF'FFFF;
inline constexpr std::size_t most_nodes = 0xFFFF'FFFF;  ///< of a height field, along one side
inline constexpr std::size_t most_channels = 1'000'000;
inline constexpr std::int64_t most_steps_per_tick = 1'000'000'000;
inline constexpr std::size_t largest_head = std::size_t{64} << 20U;

Eigen::Vector3d vector_of(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}
Eigen::Quaterniond quaternion_of(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>(), json.at(3).get<double>()};
}

RobotModel robot_of(const Json& json) {
  RobotModel robot;
  robot.name = plain_text(json, "name");
  robot.forward_rad = json.at("forward_rad").get<double>();
  robot.bounding_radius_m = json.at("bounding_radius_m").get<double>();
  for (const auto& one : json.at("links")) {
    Link link;
    link.name = one.at("name").get<std::string>();
    link.parent = whole_number<int>(one, "parent");
    const auto index = static_cast<int>(robot.links.size());
    if ((index == 0) != (link.parent == -1) || link.parent >= index || link.parent < -1) {
      throw std::runtime_error{"link " + std::to_string(index) + ": its parent must be a link before it"};
    }
    link.offset_m = vector_of(one.at("offset_m"));
    link.rotation = quaternion_of(one.at("rotation"));
    for (const auto& box : one.at("boxes")) {
      link.boxes.push_back({.part = box.at("part").get<std::string>(),
                            .half_extents_m = vector_of(box.at("half_extents_m")),
                            .centre_m = vector_of(box.at("centre_m")),
                            .orientation = quaternion_of(box.at("orientation"))});
    }
    if (index > 0) {
      Hinge hinge;
      hinge.name = one.at("hinge").at("name").get<std::string>();
      hinge.axis = vector_of(one.at("hinge").at("axis"));
      robot.hinges.push_back(std::move(hinge));
    }
    robot.links.push_back(std::move(link));
  }
  if (robot.links.empty()) throw std::runtime_error{"a robot has no links"};
  return robot;
}

Arena arena_of(const Json& json) {
  Arena arena;
  arena.name = plain_text(json, "name");
  arena.half_side_m = json.at("half_side_m").get<double>();
  arena.extent_m = json.at("extent_m").get<double>();
  if (json.contains("height_field")) {
    const auto& field = json.at("height_field");
    arena.height_field = HeightField{.nodes = whole_number<std::size_t>(field, "nodes", 2, most_nodes),
                                     .half_extent_m = field.at("half_extent_m").get<double>(),
                                     .height_m = field.at("height_m").get<std::vector<double>>()};
    const HeightField& made = *arena.height_field;
    if (made.height_m.size() != made.nodes * made.nodes) {
      throw std::runtime_error{"a height field of " + std::to_string(made.height_m.size()) + " heights"};
    }
  }
  for (const auto& one : json.value("obstacles", Json::array())) {
    const auto numbers = one.get<std::array<double, 6>>();
    arena.obstacles.push_back({numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]});
  }
  for (const auto& one : json.value("zones", Json::array())) {
    arena.zones.push_back(
        {.name = plain_text(one, "name"), .x_m = one.at("x_m"), .y_m = one.at("y_m"), .radius_m = one.at("radius_m")});
  }
  return arena;
}

/// The run of a head.
void read_run(const Json& json, RecordingHead& head) {
  if (json.at("format") != Json("trophic recording"))
    throw std::runtime_error{"must have the format trophic recording, not " + json_text(json.at("format"))};
  const Json& its_version = json.at("version");
  if (its_version != Json(version) && its_version != Json(version_of_bodies)) {
    throw std::runtime_error{"format version " + json_text(its_version) + ": must be one that this program reads, " +
                             std::to_string(version) + " and " + std::to_string(version_of_bodies)};
  }
  head.bodies_differ = its_version == Json(version_of_bodies);
  head.fingerprint = plain_text(json, "fingerprint");
  head.seed = whole_number<std::uint64_t>(json, "seed");
  head.rule_table = plain_text(json, "rule_table");
  head.backend = plain_text(json, "backend");
  head.species = json.at("species").get<std::vector<std::string>>();
  if (!std::ranges::all_of(head.species, is_plain)) throw std::runtime_error{"species: must have no control characters"};
}

RecordingHead head_of(const Json& json) {
  RecordingHead head;
  read_run(json, head);
  head.first_time_s = json.at("first_time_s").get<double>();
  head.times = {.steps = whole_number<std::int64_t>(json, "steps_per_tick", 1, most_steps_per_tick),
                .tick_s = json.at("tick_s").get<double>(),
                .clock_scale = json.at("clock_scale").get<double>()};
  head.frames_per_tick = whole_number<std::int64_t>(json, "frames_per_tick", 1, head.times.steps);
  head.robots = whole_number<std::size_t>(json, "robots", 1, most_robots);
  head.joints = whole_number<std::size_t>(json, "joints");
  const auto& units = json.at("units");
  head.units = {.position_m = units.at("position_m").get<double>(),
                .yaw_rad = units.at("yaw_rad").get<double>(),
                .tilt_rad = units.at("tilt_rad").get<double>(),
                .joint_rad = units.at("joint_rad").get<double>()};
  head.robot = robot_of(json.at("robot"));
  head.arena = arena_of(json.at("arena"));
  if (!(head.times.tick_s > 0.0)) throw std::runtime_error{"tick_s = " + number_text(head.times.tick_s) + ": must be > 0"};
  if (!head.bodies_differ && head.joints != 0 && head.joints != head.robot.hinges.size()) {
    throw std::runtime_error{"joints = " + std::to_string(head.joints) + ": must be 0 or " +
                             std::to_string(head.robot.hinges.size()) + ", the number of its robot's hinges"};
  }
  return head;
}

}  // namespace recording

RecordingReader::RecordingReader(std::filesystem::path path) : path_{std::move(path)} {
  scan();
}

void RecordingReader::scan() {
  const std::string name = path_.string();
  try {
    static_cast<void>(read_part(path_, 0));  // says what is wrong; opening a pipe would wait
  } catch (const std::invalid_argument& reason) {
    throw std::runtime_error{reason.what()};
  }
  std::ifstream file{path_, std::ios::binary};
  if (!file) throw std::runtime_error{name + ": cannot be read: " + std::strerror(errno)};
  std::string start(recording::magic.size(), '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  if (!file || start != recording::magic) throw std::runtime_error{name + ": is not a trophic recording"};
  std::streamoff at = file.tellg();
  bool ended = false;
  while (!ended) {
    std::array<char, 8> front{};
    file.read(front.data(), front.size());
    const bool nothing = file.gcount() == 0;
    const std::size_t size = recording::u32_at({front.data(), front.size()}, 0);
    const std::string_view kind{front.data() + 4, 4};
    // Only the numbers of frames are kept here; a head is short.
    const bool is_kept = kind == recording::head_kind || kind == recording::body_kind || kind == recording::who_kind;
    const std::size_t most_kept = is_kept ? recording::largest_head : 16;
    std::uint32_t sum = checksum(kind);
    std::string data;
    for (std::size_t left = size; file && left > 0;) {
      std::array<char, 1U << 16U> piece;
      const std::size_t wanted = std::min(left, piece.size());
      file.read(piece.data(), static_cast<std::streamsize>(wanted));
      if (!file) break;
      sum = checksum({piece.data(), wanted}, sum);
      data.append(piece.data(), std::min(wanted, most_kept - std::min(most_kept, data.size())));
      left -= wanted;
    }
    std::array<char, 4> written_sum{};
    file.read(written_sum.data(), written_sum.size());
    if (file.bad()) throw std::runtime_error{name + ": cannot be read at byte " + std::to_string(at)};
    if (!file) {
      const std::string where = nothing ? "after " : "in the middle of the block after ";
      if (blocks_.empty()) throw std::runtime_error{name + ": ends before its first frames"};
      remark_ =
          name + ": ends early, " + where + std::to_string(frames_) + " frames (" + number_text(time_s(frames_ - 1)) + " s)";
      return;
    }
    const auto damaged = [&](const std::string& what) {
      return std::runtime_error{name + ": damaged, " + what + " at byte " + std::to_string(at)};
    };
    if (sum != recording::u32_at({written_sum.data(), written_sum.size()}, 0)) throw damaged("wrong checksum of the block");
    if (is_kept && size > recording::largest_head) throw damaged("too long a header");
    if (head_.robots == 0) {
      if (kind != recording::head_kind) throw damaged("missing header");
      read_head(data);
    } else if (kind == recording::head_kind) {
      read_head(data);
    } else if (kind == recording::body_kind && head_.bodies_differ) {
      read_body(data);
    } else if (kind == recording::who_kind && head_.bodies_differ) {
      if (!read_set_down(data)) throw damaged("wrong robots or bodies in the block");
    } else if (kind == recording::frames_kind && size > (head_.bodies_differ ? 12 : 8)) {
      const std::size_t front_bytes = head_.bodies_differ ? 12 : 8;
      const Block block{.first_frame = recording::u32_at(data, 0),
                        .frames = recording::u32_at(data, 4),
                        .at = at + 8 + static_cast<std::streamoff>(front_bytes),
                        .bytes = size - front_bytes,
                        .channels = head_.bodies_differ ? recording::u32_at(data, 8) : recording::pose_channels + head_.joints};
      if (block.channels < recording::pose_channels || block.channels > recording::most_channels)
        throw damaged("wrong number of channels in the block");
      if (block.first_frame != frames_ || block.frames == 0) throw damaged("wrong frame numbers in the block");
      if (block.frames > recording::most_values(block.bytes) / (block.channels * head_.robots))
        throw damaged("more frames than its bytes can hold in the block");
      blocks_.push_back(block);
      frames_ += block.frames;
    } else if (kind == recording::end_kind && size == 4) {
      if (recording::u32_at(data, 0) != frames_ || frames_ == 0) throw damaged("wrong number of frames in the end block");
      ended = true;
    } else {
      throw damaged("unknown kind of block");
    }
    at = file.tellg();
  }
  if (file.peek() != std::ifstream::traits_type::eof()) {
    throw std::runtime_error{name + ": damaged, data after its end at byte " + std::to_string(at)};
  }
}

void RecordingReader::read_head(const std::string& text) {
  try {
    const Json json = parse_json(text);
    if (head_.robots == 0) {
      head_ = recording::head_of(json);
    } else {
      recording::read_run(json, head_);
    }
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw std::runtime_error{path_.string() + ": cannot read its header: " + error.what()};
  }
}

void RecordingReader::read_body(const std::string& text) {
  try {
    bodies_.push_back(recording::robot_of(parse_json(text)));
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw std::runtime_error{path_.string() + ": cannot read a body: " + error.what()};
  }
}

bool RecordingReader::read_set_down(const std::string& data) {
  if (data.size() % 8 != 4 || recording::u32_at(data, 0) < frames_) return false;
  const std::size_t frame = recording::u32_at(data, 0);
  if (head_.robots > data.size() && set_down_.empty()) return false;  // the first one names every robot
  set_down_.resize(head_.robots);
  for (std::size_t at = 4; at < data.size(); at += 8) {
    const std::size_t robot = recording::u32_at(data, at);
    const std::size_t body = recording::u32_at(data, at + 4);
    if (robot >= head_.robots || body >= bodies_.size()) return false;
    if (!set_down_[robot].empty() && set_down_[robot].back().frame > frame) return false;
    set_down_[robot].push_back({.frame = frame, .body = body});
  }
  return true;
}

std::span<const RobotModel> RecordingReader::bodies() const {
  return head_.bodies_differ ? std::span<const RobotModel>{bodies_} : std::span{&head_.robot, 1};
}

std::size_t RecordingReader::body(std::size_t frame, std::size_t robot) const {
  if (frame >= frames_ || robot >= head_.robots) {
    throw std::out_of_range{"frame " + std::to_string(frame) + ", robot " + std::to_string(robot) + ": must be < " +
                            std::to_string(frames_) + ", " + std::to_string(head_.robots)};
  }
  if (!head_.bodies_differ) return 0;
  if (robot >= set_down_.size()) throw std::runtime_error{path_.string() + ": names no body for robot " + std::to_string(robot)};
  const auto& own = set_down_[robot];
  const auto after = std::ranges::upper_bound(own, frame, {}, &SetDown::frame);
  if (after == own.begin()) throw std::runtime_error{path_.string() + ": names no body for robot " + std::to_string(robot)};
  return std::prev(after)->body;
}

const RobotModel& RecordingReader::robot(std::size_t frame, std::size_t robot) const {
  return bodies()[body(frame, robot)];
}

bool RecordingReader::is_set_down(std::size_t frame, std::size_t robot) const {
  if (robot >= set_down_.size() || frame == 0) return false;
  return std::ranges::binary_search(set_down_[robot], frame, {}, &SetDown::frame);
}

double RecordingReader::time_s(std::size_t frame) const {
  const auto number = static_cast<std::int64_t>(frame);
  const std::int64_t tick = number / head_.frames_per_tick;
  const auto step = static_cast<double>(head_.times.step_of(number % head_.frames_per_tick, head_.frames_per_tick));
  return head_.first_time_s + (static_cast<double>(tick) + step / static_cast<double>(head_.times.steps)) * head_.times.tick_s;
}

std::size_t RecordingReader::frame_at(double time_s) const {
  const double last_s = this->time_s(frames_ - 1);
  if (!(time_s >= head_.first_time_s && time_s <= last_s)) {
    throw std::invalid_argument{"time " + number_text(time_s) + " s: must be between " + number_text(head_.first_time_s) +
                                " and " + number_text(last_s) + ", the times in " + path_.string()};
  }
  const double per_s = static_cast<double>(head_.frames_per_tick) / head_.times.tick_s;
  const double guess = (time_s - head_.first_time_s) * per_s + 1.0;
  std::size_t frame = guess < static_cast<double>(frames_ - 1) ? static_cast<std::size_t>(guess) : frames_ - 1;
  while (this->time_s(frame) > time_s) --frame;
  return frame;
}

Pose RecordingReader::root(std::size_t frame, std::size_t robot) const {
  std::array<std::int16_t, recording::pose_channels> values;
  for (std::size_t channel = 0; channel < values.size(); ++channel) values[channel] = value(frame, robot, channel);
  return recording::pose(values, head_.units);
}

double RecordingReader::joint_angle_rad(std::size_t frame, std::size_t robot, std::size_t joint) const {
  const std::size_t joints = head_.bodies_differ ? this->robot(frame, robot).hinges.size() : head_.joints;
  if (joint >= joints) throw std::out_of_range{"joint " + std::to_string(joint) + ": must be < " + std::to_string(joints)};
  return head_.units.joint_rad * value(frame, robot, recording::pose_channels + joint);
}

std::int16_t RecordingReader::value(std::size_t frame, std::size_t robot, std::size_t channel) const {
  if (frame >= frames_) throw std::out_of_range{"frame " + std::to_string(frame) + ": must be < " + std::to_string(frames_)};
  if (robot >= head_.robots)
    throw std::out_of_range{"robot " + std::to_string(robot) + ": must be < " + std::to_string(head_.robots)};
  const auto after = std::ranges::upper_bound(blocks_, frame, {}, &Block::first_frame);
  const auto block = static_cast<std::size_t>(after - blocks_.begin()) - 1;
  if (channel >= blocks_[block].channels) return 0;
  if (unpacked_.empty() || unpacked_[block].empty()) unpack(block);
  return unpacked_[block][(channel * head_.robots + robot) * blocks_[block].frames + frame - blocks_[block].first_frame];
}

void RecordingReader::unpack(std::size_t number) const {
  const Block& block = blocks_[number];
  std::ifstream file{path_, std::ios::binary};
  if (!file) throw std::runtime_error{path_.string() + ": cannot be read: " + std::strerror(errno)};
  file.seekg(block.at);
  std::string bytes(block.bytes, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  const auto damaged = [&] {
    return std::runtime_error{path_.string() + ": damaged in the block that begins at frame " +
                              std::to_string(block.first_frame)};
  };
  if (file.bad()) throw std::runtime_error{path_.string() + ": cannot be read at byte " + std::to_string(block.at)};
  if (!file) throw damaged();
  unpacked_.resize(blocks_.size());
  try {
    unpacked_[number] = recording::unpacked(bytes, block.channels * head_.robots, block.frames);
  } catch (const std::invalid_argument&) {
    throw damaged();
  }
  kept_.push_back(number);
  kept_values_ += unpacked_[number].size();
  while (kept_values_ > most_kept_values && kept_.size() > 2) {
    std::vector<std::int16_t>& oldest = unpacked_[kept_.front()];
    kept_values_ -= oldest.size();
    oldest = {};
    kept_.pop_front();
  }
}

}  // namespace trophic::io
