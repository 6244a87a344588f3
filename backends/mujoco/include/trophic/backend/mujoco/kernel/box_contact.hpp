// SPDX-License-Identifier: MIT
// Contacts of two boxes, by MuJoCo's own box-box test.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <pugixml.hpp>
#include <trophic/backend/mujoco/compile.hpp>
#include <vector>

namespace trophic::backend::kernel {

/// A box in world axes.
struct PlacedBox {
  double centre_m[3];
  double half_m[3];
  double axis[3][3];  ///< axis[k] is the direction of extent k
};

/// A contact of a box with another or the ground.
struct BoxContact {
  std::array<double, 3> point_m;
  std::array<std::array<double, 3>, 3> frame;  ///< normal towards the second box, and MuJoCo's two tangents
  double depth_m;                              ///< signed distance, negative
};

/// As MuJoCo's function, with its bits, but inlined.
[[nodiscard]] inline double dot3(const double* a, const double* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// As MuJoCo's function, with its bits, but inlined: a vector without length becomes the x axis.
inline void normalize3(std::array<double, 3>& vector) {
  const double length = std::sqrt(dot3(vector.data(), vector.data()));
  if (length < mjMINVAL) {
    vector = {1.0, 0.0, 0.0};
    return;
  }
  const double scale = 1.0 / length;
  for (double& part : vector) part *= scale;
}

/// Normal along `direction` and MuJoCo's choice of tangents: the first is the part across the normal of y, of z where the normal
/// is within 60 degrees of +-y; the second completes the frame.
[[nodiscard]] inline std::array<std::array<double, 3>, 3> contact_frame(const mjtNum* direction) {
  std::array<std::array<double, 3>, 3> frame{};
  auto& [normal, first, second] = frame;
  std::copy_n(direction, 3, normal.begin());
  normalize3(normal);
  const std::size_t axis = std::abs(normal[1]) < 0.5 ? 1 : 2;
  for (std::size_t i = 0; i < 3; ++i) first[i] = (i == axis ? 1.0 : 0.0) - normal[axis] * normal[i];
  normalize3(first);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    second[i] = normal[j] * first[k] - normal[k] * first[j];
  }
  return frame;
}

/// Puts geom `geom` where `at` is, moved by `moved_m`.
inline void place_geom(mjData& data, std::size_t geom, const PlacedBox& at, const std::array<double, 3>& moved_m) {
  mju_add3(data.geom_xpos + 3 * geom, at.centre_m, moved_m.data());
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 3; ++i) data.geom_xmat[9 * geom + 3 * i + k] = at.axis[k][i];
  }
}

/// Two boxes in a MuJoCo scene of their own, placed anew for each question. One per thread.
class BoxCollider {
 public:
  explicit BoxCollider(mujoco::BoxDepth depth = mujoco::BoxDepth::engine) {
    pugi::xml_document document;
    auto root = document.append_child("mujoco");
    if (depth == mujoco::BoxDepth::whole) mujoco::ask_whole_box_depth(root);
    auto world = root.append_child("worldbody");
    for (int box = 0; box < 2; ++box) {
      auto geom = world.append_child("geom");
      geom.append_attribute("type") = "box";
      geom.append_attribute("size") = "1 1 1";
    }
    model_ = mujoco::compile(document, std::nullopt);
    mujoco::set_capacity(*model_, 4, 1000);
    data_.reset(mj_makeData(model_.get()));
    found_.resize(mjMAXCONPAIR);
  }

  /// Calls `take` with each contact that mj_collision would make of the two boxes, the second moved by `apart_m`, at margin 0.
  /// False if rounding decides which points those are: where edges are parallel to edges or faces, and where two points are the
  /// same but for rounding.
  template <class Take>
  [[nodiscard]] bool collide(const PlacedBox& first, const PlacedBox& second, const std::array<double, 3>& apart_m,
                             const Take& take) {
    if (aligned(first, second)) return false;
    place(0, first, {});
    place(1, second, apart_m);
    const int count = mjCOLLISIONFUNC[mjGEOM_BOX][mjGEOM_BOX](model_.get(), data_.get(), found_.data(), 0, 1, 0.0);
    const auto end = found_.begin() + count;
    std::array<std::array<double, 3>, 3> frame{};
    for (auto contact = found_.begin(); contact != end; ++contact) {
      const auto same_point = [&](const mjContact& other) {
        const double between_m[] = {contact->pos[0] - other.pos[0], contact->pos[1] - other.pos[1],
                                    contact->pos[2] - other.pos[2]};
        return std::sqrt(dot3(between_m, between_m)) < rounding_m;
      };
      if (std::any_of(contact + 1, end, same_point)) return false;
      // One face or one pair of edges gives all points, so that most normals are the one before.
      if (contact == found_.begin() || !std::equal(contact->frame, contact->frame + 3, contact[-1].frame)) {
        frame = contact_frame(contact->frame);
      }
      if (contact->dist < 0.0) take(BoxContact{{contact->pos[0], contact->pos[1], contact->pos[2]}, frame, contact->dist});
    }
    return true;
  }

 private:
  static constexpr double rounding_m = 1e-10;

  /// Whether an edge of one box is parallel, but for rounding, to an edge or to a face of the other.
  [[nodiscard]] static bool aligned(const PlacedBox& first, const PlacedBox& second) {
    constexpr double rounding = 1e-12;
    return std::ranges::any_of(first.axis, [&](const auto& u) {
      return std::ranges::any_of(second.axis, [&](const auto& v) {
        const double cosine = std::abs(dot3(u, v));
        return cosine < rounding || cosine > 1.0 - rounding;
      });
    });
  }

  void place(std::size_t box, const PlacedBox& at, const std::array<double, 3>& moved_m) {
    std::copy_n(at.half_m, 3, model_->geom_size + 3 * box);
    place_geom(*data_, box, at, moved_m);
  }

  mujoco::ModelPtr model_;
  mujoco::DataPtr data_;
  std::vector<mjContact> found_;
};

}  // namespace trophic::backend::kernel
