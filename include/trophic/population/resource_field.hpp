// SPDX-License-Identifier: MIT
// A food of the world: energy on a square grid over the floor.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <trophic/habitat/arena.hpp>
#include <trophic/params/archive.hpp>
#include <trophic/support/units.hpp>

namespace trophic {

/// Energy in J in the cells of a square grid over the flat floor of an arena, with further numbers per cell for the rule
/// Resource, such as the time until a cell regrows, and circular zones. Cells are numbered row by row from the corner with the
/// smallest x and y.
class ResourceField {
 public:
  ResourceField() = default;
  /// `side`: number of cells in a row. `layers`: further numbers per cell. All values are 0. Throws std::invalid_argument for an
  /// empty grid.
  ResourceField(const Arena& arena, std::size_t side, std::size_t layers = 0)
      : side_{side}, half_side_m_{arena.half_side_m}, food_J_(side * side), layers_(layers, std::vector<double>(side * side)) {
    if (side == 0 || side > 10'000) {
      throw std::invalid_argument{"rules.resource: " + std::to_string(side) + " cells in a row: must be >= 1 and <= 10000"};
    }
  }

  [[nodiscard]] std::size_t side() const { return side_; }
  [[nodiscard]] std::size_t cells() const { return food_J_.size(); }
  [[nodiscard]] double cell_m() const { return 2.0 * half_side_m_ / static_cast<double>(side_); }

  /// The cell of a position; outside the floor, the nearest cell.
  [[nodiscard]] std::size_t cell_at(double x_m, double y_m) const { return place(y_m) * side_ + place(x_m); }
  [[nodiscard]] std::size_t cell_at(const GroundPose& pose) const { return cell_at(pose.x_m, pose.y_m); }
  /// The centre of a cell; its heading is 0.
  [[nodiscard]] GroundPose centre(std::size_t cell) const {
    const auto at_m = [&](std::size_t one) { return (static_cast<double>(one) + 0.5) * cell_m() - half_side_m_; };
    return {.x_m = at_m(cell % side_), .y_m = at_m(cell / side_)};
  }

  [[nodiscard]] double& food_J(std::size_t cell) { return food_J_.at(cell); }
  [[nodiscard]] double food_J(std::size_t cell) const { return food_J_.at(cell); }
  [[nodiscard]] std::span<const double> food_J() const { return food_J_; }
  [[nodiscard]] double& layer(std::size_t number, std::size_t cell) { return layers_.at(number).at(cell); }
  [[nodiscard]] double layer(std::size_t number, std::size_t cell) const { return layers_.at(number).at(cell); }
  [[nodiscard]] std::size_t layers() const { return layers_.size(); }

  /// The radius of the circular zone around the centre of a cell, such as a mating zone; 0 without a zone.
  [[nodiscard]] double zone_m(std::size_t cell) const { return zone_m_.empty() ? 0.0 : zone_m_.at(cell); }
  [[nodiscard]] bool has_zones() const { return !zone_m_.empty(); }
  void set_zone(std::size_t cell, double radius_m) {
    zone_m_.resize(cells());
    zone_m_.at(cell) = radius_m;
  }

  [[nodiscard]] double total_J() const { return std::accumulate(food_J_.begin(), food_J_.end(), 0.0); }

  /// Writes all numbers to an archive, or reads those of a field of the same size.
  void persist(Archive& archive) {
    const std::size_t cells = food_J_.size();
    const std::size_t layers = layers_.size();
    archive(food_J_, layers_, zone_m_);
    if (!archive.reads()) return;
    Archive::require(food_J_.size() == cells && layers_.size() == layers, "a resource of a different size");
    for (const auto& layer : layers_) Archive::require(layer.size() == cells, "a resource of a different size");
    Archive::require(zone_m_.empty() || zone_m_.size() == cells, "a resource of a different size");
  }

 private:
  [[nodiscard]] std::size_t place(double at_m) const {
    const double cell = std::floor((at_m + half_side_m_) / cell_m());
    return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(side_ - 1)));
  }

  std::size_t side_ = 0;
  double half_side_m_ = 0.0;
  std::vector<double> food_J_;
  std::vector<std::vector<double>> layers_;
  std::vector<double> zone_m_;
};

}  // namespace trophic
