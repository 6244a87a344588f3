// SPDX-License-Identifier: MIT
// A stretch of a recorded run as a glTF scene: all individuals, with the motion of their bodies and joints.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <map>
#include <optional>
#include <tools/recording/read_recording.hpp>
#include <tools/trophic/replay/gltf_file.hpp>
#include <tools/trophic/replay/recorded_agents.hpp>
#include <tools/trophic/replay/recorded_run.hpp>
#include <trophic/habitat/arena.hpp>
#include <trophic/params/params.hpp>
#include <vector>

namespace trophic::command::replay {

/// An individual is a node of its own, "robot 17", with a node for each link and box below it; before its birth and after its
/// death its scale is 0. One animation, "run", begins with the first frame at or before the stretch; a second of it is a second
/// of the ecology's clock. Each species has a colour; inactive individuals have it too.
class GltfScene {
 public:
  /// More bytes of motion than this are refused: few programs open them.
  static constexpr double most_bytes = 1e9;

  /// Throws std::invalid_argument for `only` who does not live in the stretch, for a stretch that takes too much room, and for
  /// tables that are not the run's.
  GltfScene(const RecordedRun& run, double from_s, double to_s, std::optional<IndividualId> only);

  [[nodiscard]] const GltfFile& file() const { return file_; }
  [[nodiscard]] std::size_t individuals() const { return individuals_; }
  [[nodiscard]] std::size_t frames() const { return last_ - first_ + 1; }

 private:
  [[nodiscard]] float since_first(std::size_t frame) const;

  void add_arena(const Arena& arena);

  void add_food(std::size_t parent);
  void add_obstacle(std::size_t parent, std::size_t material, const Obstacle& one);
  void add_zone(std::size_t parent, std::size_t material, const Zone& one, double wide_m);
  void add_slopes(std::size_t parent, std::size_t material, const HeightField& field);

  /// Adds the individuals that lived in a body, one after another, or only one of them.
  void add_occupants(std::size_t body, std::optional<IndividualId> only);

  /// `next`: the first frame of the next occupant; beyond the last frame for an individual that survives.
  void add_individual(std::size_t body, const io::AgentRow& row, std::size_t from, std::size_t next);

  /// How a link stands to its parent.
  [[nodiscard]] Eigen::Quaterniond turned(std::size_t link, std::size_t frame, std::size_t body) const;

  void add_motion(const io::AgentRow& row, const std::vector<std::size_t>& links, std::size_t from, std::size_t to);
  /// Adds the one of an orientation's two quaternions that is nearer to the one before.
  static void add_turn(std::vector<float>& turns, const Eigen::Quaterniond& turn, Eigen::Quaterniond& before);

  void add_lifetime(std::size_t node, std::size_t from, std::size_t next);

  [[nodiscard]] std::size_t times_between(std::size_t from, std::size_t to);

  const io::RecordingReader& recording_;
  std::size_t first_;
  std::size_t last_;
  RecordedAgents agents_;
  RecordedFood food_;
  GltfFile file_;
  std::vector<std::size_t> cores_;  ///< meshes, by species
  std::vector<std::size_t> limbs_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> times_;
  std::size_t individuals_ = 0;
};

}  // namespace trophic::command::replay
