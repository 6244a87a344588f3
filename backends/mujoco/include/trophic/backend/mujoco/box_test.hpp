// SPDX-License-Identifier: MIT
// The whole depth of face contacts between boxes, for the models that request it.
#pragma once

#include <mujoco/mujoco.h>
#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <trophic/backend/mujoco/box_depth.hpp>
#include <trophic/backend/mujoco/kernel/box_contact.hpp>
#include <trophic/backend/mujoco/versions.hpp>

namespace trophic::backend::mujoco {

/// The name of the custom number with which a model requests the whole depth.
inline constexpr const char* whole_box_depth = "trophic.whole_box_depth";

/// Writes the request into the MJCF document with this root.
inline void ask_whole_box_depth(pugi::xml_node mujoco) {
  auto numeric = mujoco.append_child("custom").append_child("numeric");
  numeric.append_attribute("name") = whole_box_depth;
  numeric.append_attribute("data") = "1";
}

[[nodiscard]] inline bool asks_whole_box_depth(const mjModel& model) {
  for (int i = 0; i < model.nnumeric; ++i) {
    if (std::strcmp(model.names + model.name_numericadr[i], whole_box_depth) == 0) {
      return model.numeric_data[model.numeric_adr[i]] != 0.0;
    }
  }
  return false;
}

/// Whether a contact of two boxes lies on a face of one of them and has half its depth.
///
/// A face contact's normal is that of the face, bit for bit. The point lies midway between the two surfaces, half the depth
/// inside the face. If the depth itself is reported, it is twice the distance of the point from the face; if half of it is, it
/// equals that distance.
[[nodiscard]] inline bool has_half_depth(const mjModel& model, const mjData& data, const FoundContact& contact, int first,
                                         int second) {
  const auto normal = normal_of(contact);
  for (const int geom : {first, second}) {
    const mjtNum* const rotation = data.geom_xmat + 9 * geom;
    for (int axis = 0; axis < 3; ++axis) {
      const mjtNum column[3] = {rotation[axis], rotation[3 + axis], rotation[6 + axis]};
      const bool along = normal[0] == column[0] && normal[1] == column[1] && normal[2] == column[2];
      const bool against = normal[0] == -column[0] && normal[1] == -column[1] && normal[2] == -column[2];
      if (!along && !against) continue;
      mjtNum from_centre[3];
      mju_sub3(from_centre, contact.pos, data.geom_xpos + 3 * geom);
      const mjtNum outwards = geom == first ? mju_dot3(from_centre, normal.data()) : -mju_dot3(from_centre, normal.data());
      const mjtNum from_face = outwards - model.geom_size[3 * geom + axis];
      if (std::abs(from_face) > 0.75 * std::abs(contact.dist)) return true;
    }
  }
  return false;
}

/// The box-box test that was installed first: MuJoCo's own or a replacement.
[[nodiscard]] inline mjfCollision& engine_box_test() {
  static mjfCollision function = nullptr;
  return function;
}

/// The contacts that MuJoCo 3.4 to 3.11 finds, by the kernel's test.
inline int find_box_contacts(const mjModel& model, const mjData& data, FoundContact* contacts, int first, int second) {
  const auto placed = [&](int geom) {
    kernel::PlacedBox box;
    std::copy_n(data.geom_xpos + 3 * geom, 3, box.centre_m.begin());
    std::copy_n(model.geom_size + 3 * geom, 3, box.half_m.begin());
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 3; ++i) box.axis[k][i] = (data.geom_xmat + 9 * geom)[3 * i + k];
    }
    return box;
  };
  const kernel::PlacedBox a = placed(first);
  const kernel::PlacedBox b = placed(second);
  kernel::BoxOverlap overlap{a, b, {}};
  if (overlap.separated(kernel::least_overlap_m)) return 0;
  overlap.meet();
  kernel::keep_contacts(overlap);
  for (std::size_t c = 0; c < overlap.count; ++c) {
    FoundContact& contact = contacts[c] = {};
    contact.dist = overlap.depths_m[c] * (overlap.on_face ? 2.0 : 1.0);
    std::ranges::copy(overlap.points_m[c], contact.pos);
    std::ranges::copy(overlap.normal, normal_of(contact).begin());
  }
  return static_cast<int>(overlap.count);
}

/// The same with whole depths in models that request them. A pure function, so any thread may call it.
inline int test_boxes(const mjModel* model, CollisionData* data, FoundContact* contacts, int first, int second, mjtNum margin) {
  if (replaces_box_test && asks_whole_box_depth(*model)) return find_box_contacts(*model, *data, contacts, first, second);
  const int count = engine_box_test()(model, data, contacts, first, second, margin);
  if (count == 0 || !asks_whole_box_depth(*model)) return count;
  for (FoundContact* contact = contacts; contact != contacts + count; ++contact) {
    if (has_half_depth(*model, *data, *contact, first, second)) contact->dist *= 2.0;
  }
  return count;
}

/// Installs `test_boxes` in MuJoCo's table, once per process. Must be called before such a model is stepped.
inline void install_box_test() {
  static const bool installed = [] {
    mjfCollision& entry = mjCOLLISIONFUNC[mjGEOM_BOX][mjGEOM_BOX];
    engine_box_test() = entry;
    entry = test_boxes;
    return true;
  }();
  static_cast<void>(installed);
}

}  // namespace trophic::backend::mujoco
