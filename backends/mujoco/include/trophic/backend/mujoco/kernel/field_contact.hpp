// SPDX-License-Identifier: MIT
// Contacts of boxes with a height field, equal to MuJoCo's.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <trophic/backend/mujoco/kernel/box_contact.hpp>
#include <trophic/backend/mujoco/kernel/model.hpp>
#include <trophic/backend/mujoco/kernel/portal.hpp>
#include <trophic/backend/mujoco/versions.hpp>
#include <utility>
#include <vector>

namespace trophic::backend::kernel {

/// The ground under a triangle of nodes: two parallel triangles, the lower one first.
struct Prism {
  std::array<portal::Point, 6> corner{};

  [[nodiscard]] portal::Point centre() const {
    portal::Point sum{};
    for (const portal::Point& point : corner) sum = sum + point;
    return sum * (1.0 / 6.0);
  }
  [[nodiscard]] portal::Point support(const portal::Point& direction) const {
    const std::size_t from = direction.z < 0.0 ? 0 : 3;
    std::size_t best = from;
    double most = dot(corner[from], direction);
    for (const std::size_t k : {from + 1, from + 2}) {
      const double along = dot(corner[k], direction);
      if (along > most) {
        best = k;
        most = along;
      }
    }
    return corner[best];
  }

  /// Replaces the first added of three nodes of the ground.
  void add(const portal::Point& node, double bottom_m) {
    for (std::size_t k = 0; k < 6; k += 3) {
      corner[k] = corner[k + 1];
      corner[k + 1] = corner[k + 2];
    }
    corner[2] = {node.x, node.y, bottom_m};
    corner[5] = node;
  }
  [[nodiscard]] bool is_below(double height_m) const {
    return corner[3].z < height_m && corner[4].z < height_m && corner[5].z < height_m;
  }
};

/// A box in the height field's axes.
struct BoxOnField {
  portal::Point middle;
  std::array<portal::Point, 3> axis;
  std::array<portal::Point, 3> edge;  ///< half of it, along each axis

  [[nodiscard]] portal::Point centre() const { return middle; }
  [[nodiscard]] portal::Point support(const portal::Point& direction) const {
    const auto signed_edge = [&](std::size_t k) {
      const double along = dot(axis[k], direction);
      return edge[k] * (along < 0.0 ? -1.0 : along > 0.0 ? 1.0 : 0.0);
    };
    return signed_edge(0) + signed_edge(1) + signed_edge(2) + middle;
  }
};

/// A box over the height field, placed again for each query in a MuJoCo model of both. One per thread.
class FieldCollider {
 public:
  explicit FieldCollider(const Field& field)
      : owner_{mj_copyModel(nullptr, field.model.get())},
        model_{*owner_},
        field_{field.geom},
        box_{static_cast<std::size_t>(field.box)},
        data_{mj_makeData(&model_)},
        found_(mjMAXCONPAIR) {
    mj_kinematics(&model_, data_.get());
  }

  /// Height of the highest node of the cells within `radius_m` of a point in x and y; beyond an edge, of the cells at it.
  [[nodiscard]] double highest_m(double x_m, double y_m, double radius_m) const {
    const int field = model_.geom_dataid[field_];
    const mjtNum* const size_m = model_.hfield_size + 4 * field;
    const mjtNum* const place_m = data_->geom_xpos + 3 * field_;
    const auto nodes_of = [&](double centre_m, double half_m, int nodes) {
      const double per_m = (nodes - 1) / (2.0 * half_m);
      const double first = std::floor((centre_m - radius_m + half_m) * per_m);
      const double last = std::ceil((centre_m + radius_m + half_m) * per_m);
      const double most = nodes - 1;
      return std::pair{static_cast<int>(std::clamp(first, 0.0, most)), static_cast<int>(std::clamp(last, 0.0, most))};
    };
    const int columns = model_.hfield_ncol[field];
    const auto [west, east] = nodes_of(x_m - place_m[0], size_m[0], columns);
    const auto [south, north] = nodes_of(y_m - place_m[1], size_m[1], model_.hfield_nrow[field]);
    float highest = 0.0F;
    const float* const heights = model_.hfield_data + model_.hfield_adr[field];
    for (int row = south; row <= north; ++row) {
      for (int column = west; column <= east; ++column) highest = std::max(highest, heights[row * columns + column]);
    }
    return place_m[2] + static_cast<double>(highest) * size_m[2];
  }

  /// Calls `take` with each contact that mj_collision would make of the height field and the box at `box`, moved by `origin_m`;
  /// points are relative to the origin, normals point to the box. False if rounding decides which points those are: where an
  /// axis of the box lies in a plane of the world's axes.
  template <class Take>
  [[nodiscard]] bool collide(const PlacedBox& box, const std::array<double, 3>& origin_m, const Take& take) {
    const std::size_t count = mujoco::is_mujoco_3 ? find_by_engine(box, origin_m) : find(box, origin_m);
    for (std::size_t c = 0; c < count; ++c) {
      const mujoco::FoundContact& contact = found_[c];
      if (!(contact.dist < 0.0)) continue;
      BoxContact found{{}, contact_frame(mujoco::normal_of(contact).data()), contact.dist};
      mju_sub3(found.point_m.data(), contact.pos, origin_m.data());
      take(found);
    }
    return count == 0 || !level(box);
  }

 private:
  /// Fills `found_` by MuJoCo's function and returns the number of contacts.
  std::size_t find_by_engine(const PlacedBox& box, const std::array<double, 3>& origin_m) {
    std::copy_n(box.half_m.data(), 3, model_.geom_size + 3 * box_);
    const auto& [x, y, z] = box.half_m;
    model_.geom_rbound[box_] = std::sqrt(x * x + y * y + z * z);
    place_geom(*data_, box_, box, origin_m);
    const int geom = static_cast<int>(box_);
    const int count = mjCOLLISIONFUNC[mjGEOM_HFIELD][mjGEOM_BOX](&model_, data_.get(), found_.data(), field_, geom, 0.0);
    return static_cast<std::size_t>(count);
  }

  /// The same by the kernel's own code: the prisms below the box, west to east, then south to north.
  std::size_t find(const PlacedBox& box, const std::array<double, 3>& origin_m) {
    const int field = model_.geom_dataid[field_];
    const mjtNum* const size_m = model_.hfield_size + 4 * field;
    const mjtNum* const place_m = data_->geom_xpos + 3 * field_;
    const BoxOnField on = on_field(box, origin_m, place_m);
    const portal::Point low = {on.support({-1, 0, 0}).x, on.support({0, -1, 0}).y, on.support({0, 0, -1}).z};
    const portal::Point high = {on.support({1, 0, 0}).x, on.support({0, 1, 0}).y, on.support({0, 0, 1}).z};
    if (low.x > size_m[0] || high.x < -size_m[0] || low.y > size_m[1] || high.y < -size_m[1] || low.z > size_m[2] ||
        high.z < -size_m[3]) {
      return 0;
    }
    const int columns = model_.hfield_ncol[field];
    const int rows = model_.hfield_nrow[field];
    const auto cells = [](double from_m, double to_m, double half_m, int nodes) {
      const auto node = [&](double at_m) { return (at_m + half_m) / (2 * half_m) * (nodes - 1); };
      return std::pair{std::max(0, static_cast<int>(std::floor(node(from_m)))),
                       std::min(nodes - 1, static_cast<int>(std::ceil(node(to_m))))};
    };
    const auto [west, east] = cells(low.x, high.x, size_m[0], columns);
    const auto [south, north] = cells(low.y, high.y, size_m[1], rows);
    const double step_x_m = (2.0 * size_m[0]) / (columns - 1);
    const double step_y_m = (2.0 * size_m[1]) / (rows - 1);
    const float* const heights = model_.hfield_data + model_.hfield_adr[field];
    const auto [tolerance, iterations] = mujoco::overlap_search(model_.opt);
    std::size_t count = 0;
    Prism prism;
    for (int row = south; row < north; ++row) {
      int nodes = 0;
      for (int column = west; column <= east; ++column) {
        for (const int up : {1, 0}) {
          prism.add({step_x_m * column - size_m[0], step_y_m * (row + up) - size_m[1],
                     static_cast<double>(heights[(row + up) * columns + column]) * size_m[2]},
                    -size_m[3]);
          if (++nodes < 3 || prism.is_below(low.z)) continue;
          const auto overlap = portal::find_overlap(prism, on, tolerance, iterations);
          if (!overlap) continue;
          mujoco::FoundContact& contact = found_[count++];
          const auto& [depth, direction, place] = *overlap;
          contact.dist = -depth;
          std::ranges::copy(std::array{direction.x, direction.y, direction.z}, mujoco::normal_of(contact).begin());
          std::ranges::copy(std::array{place.x + place_m[0], place.y + place_m[1], place.z + place_m[2]}, contact.pos);
          if (count == found_.size()) return count;
        }
      }
    }
    return count;
  }

  [[nodiscard]] static BoxOnField on_field(const PlacedBox& box, const std::array<double, 3>& origin_m, const mjtNum* place_m) {
    const auto point = [](const auto& of) { return portal::Point{of(0), of(1), of(2)}; };
    BoxOnField on;
    on.middle = point([&](std::size_t i) { return (box.centre_m[i] + origin_m[i]) - place_m[i]; });
    for (std::size_t k = 0; k < 3; ++k) {
      on.axis[k] = point([&](std::size_t i) { return box.axis[k][i]; });
      on.edge[k] = on.axis[k] * box.half_m[k];
    }
    return on;
  }

  /// Whether an axis of the box is, up to rounding, one of the world's.
  [[nodiscard]] static bool level(const PlacedBox& box) {
    constexpr double rounding = 1e-12;
    return std::ranges::any_of(box.axis, [](const auto& axis) {
      return std::ranges::any_of(axis, [](double part) { return std::abs(part) < rounding; });
    });
  }

  mujoco::ModelPtr owner_;
  mjModel& model_;
  int field_;
  std::size_t box_;
  mujoco::DataPtr data_;
  std::vector<mujoco::FoundContact> found_;
};

}  // namespace trophic::backend::kernel
