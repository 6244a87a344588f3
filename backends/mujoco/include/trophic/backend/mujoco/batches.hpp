// SPDX-License-Identifier: MIT
// Divides robots into batches; one thread steps the robots of a batch together.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <trophic/backend/clusters.hpp>
#include <trophic/backend/mujoco/kernel/batch.hpp>
#include <vector>

namespace trophic::backend::mujoco::TROPHIC_LANES {

/// The lanes of robots in a batch. Bodies in a pack have the same shape; robots that may touch are in the same batch.
struct BatchPlan {
  struct Pack {
    std::size_t shape;
    std::array<std::size_t, kernel::lane_count> robots;
    std::size_t used;
    [[nodiscard]] std::size_t room() const { return kernel::lane_count - used; }
  };
  std::vector<Pack> packs;
  std::vector<kernel::LaneIndex> order;  ///< group by group, ascending in each
  std::vector<std::array<kernel::LaneIndex, 2>> neighbours;

  [[nodiscard]] std::size_t robot(const kernel::LaneIndex& at) const { return packs[at.pack].robots[at.lane]; }
};

/// Fills batches with groups of robots, largest first. These take longest, so they share batches only if each thread has one.
class BatchPlanner {
 public:
  explicit BatchPlanner(std::size_t threads = 1) : threads_{threads} {}

  /// `groups`: ascending lists of robots that may touch each other; `discs`: robots whose discs do not touch cannot touch.
  /// `shape_of` returns the index of a body's shape. `lone`: further robots, which touch no others.
  template <class ShapeOf>
  [[nodiscard]] std::span<const BatchPlan> plan(std::span<const std::vector<std::size_t>> groups, std::span<const Disc> discs,
                                                const ShapeOf& shape_of, std::span<const std::size_t> lone = {}) {
    count_ = 0;
    for (OpenPacks& open : open_) open = {};
    for (const std::vector<std::size_t>& group : groups) {
      if (group.size() == 1) {
        place_alone(group.front(), shape_of(group.front()));
      } else {
        place_group(group, discs, shape_of);
      }
    }
    for (const std::size_t robot : lone) place_alone(robot, shape_of(robot));
    return {batches_.data(), count_};
  }

 private:
  /// Packs of one shape in the order in which they were made. None before `first` has room.
  struct OpenPacks {
    std::vector<std::array<std::size_t, 2>> packs;  ///< batch and pack
    std::size_t first = 0;
  };

  BatchPlan& add_batch() {
    if (count_ == batches_.size()) batches_.emplace_back();
    BatchPlan& batch = batches_[count_++];
    batch.packs.clear();
    batch.order.clear();
    batch.neighbours.clear();
    return batch;
  }

  OpenPacks& open(std::size_t shape) {
    if (shape >= open_.size()) open_.resize(shape + 1);
    return open_[shape];
  }

  kernel::LaneIndex place(BatchPlan& batch, std::size_t pack, std::size_t robot) {
    BatchPlan::Pack& own = batch.packs[pack];
    own.robots[own.used] = robot;
    batch.order.push_back({pack, own.used++});
    return batch.order.back();
  }

  std::size_t add_pack(BatchPlan& batch, std::size_t shape) {
    batch.packs.push_back({shape, {}, 0});
    open(shape).packs.push_back({count_ - 1, batch.packs.size() - 1});
    return batch.packs.size() - 1;
  }

  void place_alone(std::size_t robot, std::size_t shape) {
    OpenPacks& own = open(shape);
    const auto room = [&](const std::array<std::size_t, 2>& at) { return batches_[at[0]].packs[at[1]].room(); };
    while (own.first < own.packs.size() && room(own.packs[own.first]) == 0) ++own.first;
    if (own.first == own.packs.size()) add_pack(add_batch(), shape);
    const auto [batch, pack] = open(shape).packs[open(shape).first];
    place(batches_[batch], pack, robot);
  }

  /// The last pack of a shape in a batch, or the number of its packs.
  static std::size_t last_pack(const BatchPlan& batch, std::size_t shape) {
    const auto last =
        std::find_if(batch.packs.rbegin(), batch.packs.rend(), [&](const auto& pack) { return pack.shape == shape; });
    return last == batch.packs.rend() ? batch.packs.size() : static_cast<std::size_t>(batch.packs.rend() - last) - 1;
  }

  /// A group goes into the last batch if all threads have work and that batch has room for it, otherwise into a new one.
  template <class ShapeOf>
  void place_group(std::span<const std::size_t> group, std::span<const Disc> discs, const ShapeOf& shape_of) {
    const auto has_room = [&](std::size_t robot) {
      const std::size_t shape = shape_of(robot);
      const BatchPlan& batch = batches_[count_ - 1];
      const std::size_t pack = last_pack(batch, shape);
      const auto needed = std::ranges::count(group, shape, shape_of);
      return pack < batch.packs.size() && batch.packs[pack].room() >= static_cast<std::size_t>(needed);
    };
    BatchPlan& batch = count_ >= threads_ && std::ranges::all_of(group, has_room) ? batches_[count_ - 1] : add_batch();
    const std::size_t first = batch.order.size();
    for (const std::size_t robot : group) {
      std::size_t pack = last_pack(batch, shape_of(robot));
      if (pack == batch.packs.size() || batch.packs[pack].room() == 0) pack = add_pack(batch, shape_of(robot));
      place(batch, pack, robot);
    }
    for (std::size_t b = 1; b < group.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) {
        if (touch(discs[group[a]], discs[group[b]])) batch.neighbours.push_back({batch.order[first + a], batch.order[first + b]});
      }
    }
  }

  std::size_t threads_;  ///< at least 1
  std::vector<BatchPlan> batches_;
  std::size_t count_ = 0;
  std::vector<OpenPacks> open_;
};

}  // namespace trophic::backend::mujoco::TROPHIC_LANES

namespace trophic::backend::mujoco {
using namespace TROPHIC_LANES;
}
