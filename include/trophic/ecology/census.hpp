// SPDX-License-Identifier: MIT
// The individual in each body, the size of each species, and the search tree.
#pragma once

#include <optional>
#include <span>
#include <trophic/population/search_tree.hpp>
#include <unordered_map>
#include <vector>

namespace trophic {

/// Keeps counts, bodies by id and the marks of the search tree consistent with the individuals. Owned by the population.
class Census {
 public:
  explicit Census(std::size_t species) : members_(species) {}

  [[nodiscard]] std::span<const Individual> all() const { return individuals_; }
  [[nodiscard]] std::size_t bodies() const { return individuals_.size(); }
  [[nodiscard]] std::span<const std::size_t> members() const { return members_; }  ///< number per species
  [[nodiscard]] const Individual& operator[](BodyIndex body) const { return individuals_[body]; }
  /// The body of an individual; empty if it is dead.
  [[nodiscard]] std::optional<BodyIndex> body_of(IndividualId id) const {
    const auto found = bodies_.find(id);
    return found == bodies_.end() ? std::nullopt : std::optional{found->second};
  }

  /// For changes to members that searches do not read. After a change of species, tag or activity, call `mark`.
  [[nodiscard]] Individual& change(BodyIndex body) { return individuals_[body]; }
  [[nodiscard]] std::span<Individual> change_all() { return individuals_; }
  void mark(BodyIndex body) {
    if (!poses_.empty()) tree_.mark(body, poses_[body], individuals_[body]);
  }

  void reserve(std::size_t bodies) { individuals_.reserve(bodies); }
  /// Adds a body with an individual or a spare one.
  void add(Individual one) {
    if (one.lives()) count(one, individuals_.size());
    individuals_.push_back(std::move(one));
  }
  /// Puts an individual into a body, replacing its occupant, if any.
  void replace(BodyIndex body, Individual born) {
    remove(body);
    count(born, body);
    individuals_[body] = std::move(born);
    mark(body);
  }
  /// Removes the individual from a body.
  void vacate(BodyIndex body) {
    remove(body);
    individuals_[body] = spare_body(individuals_[body].tag, individuals_[body].target_angle_rad);
    mark(body);
  }

  /// Records that bodies stand at `poses`, one per body, and keeps a reference to them. From now on searches can use a tree,
  /// until `leave_tree`.
  void stand_at(std::span<const GroundPose> poses) {
    poses_ = poses;
    tree_ = SearchTree{poses_, individuals_};
  }
  /// Call this if bodies have moved: searches then visit all of them until the next `stand_at`.
  void leave_tree() { poses_ = {}; }
  /// The tree that finds the closest bodies; null before `stand_at`.
  [[nodiscard]] const SearchTree* tree() const { return poses_.empty() ? nullptr : &tree_; }
  /// The tree of the last `stand_at`, which has the old places of bodies that have moved since.
  [[nodiscard]] const SearchTree& last_tree() const { return tree_; }

  /// Recounts after the individuals were read from an archive.
  void count_all() {
    std::ranges::fill(members_, std::size_t{0});
    bodies_.clear();
    for (BodyIndex body = 0; body < individuals_.size(); ++body)
      if (individuals_[body].lives()) count(individuals_[body], body);
  }
  /// The individuals, for writing to an archive or reading from it; call `count_all` after reading.
  [[nodiscard]] std::vector<Individual>& saved() { return individuals_; }

 private:
  void count(const Individual& one, BodyIndex body) {
    ++members_[one.species];
    bodies_[one.id] = body;
  }
  void remove(BodyIndex body) {
    if (!individuals_[body].lives()) return;
    --members_[individuals_[body].species];
    bodies_.erase(individuals_[body].id);
  }

  std::vector<Individual> individuals_;
  std::vector<std::size_t> members_;
  std::unordered_map<IndividualId, BodyIndex> bodies_ = {};
  std::span<const GroundPose> poses_ = {};
  SearchTree tree_;
};

}  // namespace trophic
