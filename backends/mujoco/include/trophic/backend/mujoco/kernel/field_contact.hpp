// SPDX-License-Identifier: MIT
// Contacts of boxes with a height field, by MuJoCo's own test.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <trophic/backend/mujoco/kernel/box_contact.hpp>
#include <trophic/backend/mujoco/kernel/model.hpp>
#include <utility>
#include <vector>

namespace trophic::backend::kernel {

/// A box over the height field, placed anew for each question in a MuJoCo model of both. One per thread.
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
    std::copy_n(box.half_m, 3, model_.geom_size + 3 * box_);
    const auto& [x, y, z] = box.half_m;
    model_.geom_rbound[box_] = std::sqrt(x * x + y * y + z * z);
    place_geom(*data_, box_, box, origin_m);
    const int geom = static_cast<int>(box_);
    const int count = mjCOLLISIONFUNC[mjGEOM_HFIELD][mjGEOM_BOX](&model_, data_.get(), found_.data(), field_, geom, 0.0);
    for (int c = 0; c < count; ++c) {
      const mjContact& contact = found_[static_cast<std::size_t>(c)];
      if (!(contact.dist < 0.0)) continue;
      BoxContact found{{}, contact_frame(contact.frame), contact.dist};
      mju_sub3(found.point_m.data(), contact.pos, origin_m.data());
      take(found);
    }
    return count == 0 || !level(box);
  }

 private:
  /// Whether an axis of the box is, but for rounding, one of the world's.
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
  std::vector<mjContact> found_;
};

}  // namespace trophic::backend::kernel
