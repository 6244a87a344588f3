// SPDX-License-Identifier: MIT
// The differences between MuJoCo 2.2 and later versions that concern the backend.
#pragma once

#include <mujoco/mujoco.h>
#include <pugixml.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <trophic/backend/mujoco/give_back_pages.hpp>

namespace trophic::backend::mujoco {

/// Whether the included header is newer than all versions that were tried (packaging/README.md).
inline constexpr bool is_untried = mjVERSION_HEADER >= 4001000;

/// Whether the included header is of MuJoCo 3.
inline constexpr bool is_mujoco_3 = mjVERSION_HEADER >= 300;

/// Whether MJCF's attribute `collision` limits collisions to the listed pairs. Without it, geoms without a contact type do.
inline constexpr bool has_collision_option = !is_mujoco_3;

/// Whether MuJoCo reports half the depth of face contacts between boxes: up to 3.3.7 (see box_depth.hpp).
inline constexpr bool halves_box_depth = mjVERSION_HEADER < 3004000;

/// Whether a test of two boxes finds other contacts than that of MuJoCo 3.4 to 3.11, so that the backend installs its own (see
/// box_test.hpp).
inline constexpr bool replaces_box_test = mjVERSION_HEADER >= 3012000;

/// The most contacts of two boxes.
inline constexpr std::size_t most_box_contacts = replaces_box_test ? 8 : mjMAXCONPAIR;

/// Whether a Runge-Kutta step combines the turns of the root by Munthe-Kaas' correction: the stages' angular velocities as rates
/// of one rotation vector.
inline constexpr bool corrects_turns = mjVERSION_HEADER >= 4000000;

/// Whether the Newton solver works with a sparse Jacobian: 4.0.0 factorizes some of its matrices wrongly (MuJoCo's issue 3767).
inline constexpr bool solves_sparse = mjVERSION_HEADER != 4000000;

/// The features that the backend turns off in all models, so that boxes meet height fields as in MuJoCo 2.2: by libccd's search,
/// in one point for each prism.
#if mjVERSION_HEADER >= 3008000
inline constexpr int turned_off = mjDSBL_NATIVECCD | mjDSBL_MULTICCD;
#elif mjVERSION_HEADER >= 330
inline constexpr int turned_off = mjDSBL_NATIVECCD;
#else
inline constexpr int turned_off = 0;
#endif

/// What a function in MuJoCo's table of collisions reads and writes: from 3.9 on not a whole contact.
template <class Function>
struct Collision;
template <class Data_, class Contact_>
struct Collision<int (*)(const mjModel*, Data_*, Contact_*, int, int, mjtNum)> {
  using Data = Data_;
  using Contact = Contact_;
};
using CollisionData = Collision<mjfCollision>::Data;
using FoundContact = Collision<mjfCollision>::Contact;

template <class Contact>
[[nodiscard]] auto normal_of(Contact& contact) {
  if constexpr (requires { contact.normal; }) {
    return std::span{contact.normal};
  } else {
    return std::span{contact.frame}.template first<3>();
  }
}

/// Puts a file into a virtual file system. Throws std::runtime_error if MuJoCo refuses it.
inline void add_file(mjVFS& files, const std::string& name, const std::string& content) {
  const auto size = static_cast<int>(content.size());
#if mjVERSION_HEADER >= 300
  const bool stored = mj_addBufferVFS(&files, name.c_str(), content.data(), size) == 0;
#else
  const bool stored = mj_makeEmptyFileVFS(&files, name.c_str(), size) == 0;
  if (stored) std::ranges::copy(content, static_cast<char*>(files.filedata[mj_findFileVFS(&files, name.c_str())]));
#endif
  if (!stored) throw std::runtime_error{"MuJoCo: cannot store " + name + " of " + std::to_string(content.size()) + " bytes"};
}

/// Sets the capacity for `rows` constraint rows and a quarter as many contacts, with a stack of `numbers` numbers. MuJoCo 2.3 and
/// later have one memory for stack, rows and contacts; pages that they do not use cost nothing.
inline void set_capacity(mjModel& model, std::size_t rows, std::size_t numbers) {
  model.njmax = static_cast<int>(rows);
  model.nconmax = static_cast<int>(rows / 4);
#if mjVERSION_HEADER >= 230
  // A row has its share of the Jacobian and its transpose with their indices, and 40 numbers; islands keep a copy.
  const std::size_t row = 2 * (3 * static_cast<std::size_t>(model.nv) + 40) + sizeof(mjContact) / 8;
  numbers = 2 * numbers + rows * row;
#endif
#if mjVERSION_HEADER >= 300
  model.narena = static_cast<decltype(model.narena)>(numbers * sizeof(mjtNum));
#else
  model.nstack = static_cast<int>(std::min<std::size_t>(numbers, std::numeric_limits<int>::max() / 8));
#endif
}

/// Writes a model's capacity as the attributes of MJCF's element `size`.
inline void write_capacity(pugi::xml_node size, const mjModel& model) {
#if mjVERSION_HEADER >= 300
  size.append_attribute("memory").set_value(std::to_string(model.narena).c_str());
#else
  size.append_attribute("njmax").set_value(model.njmax);
  size.append_attribute("nconmax").set_value(model.nconmax);
  size.append_attribute("nstack").set_value(model.nstack);
#endif
}

/// Returns the pages of the square matrix of the dual solvers, which MuJoCo 2.2 fills with zeros and the Newton solver never
/// reads. Later versions allocate it only for those solvers.
inline void give_back_dual_matrix([[maybe_unused]] const mjModel& model, [[maybe_unused]] mjData& data) {
#if mjVERSION_HEADER < 230
  const auto rows = static_cast<std::size_t>(model.njmax);
  give_back_pages(data.efc_AR, rows * rows * sizeof(mjtNum));
  give_back_pages(data.efc_AR_colind, rows * rows * sizeof(int));
#endif
}

/// Accuracy and limit of MuJoCo's search for the overlap of two convex geoms.
struct OverlapSearch {
  double tolerance = 0.0;
  int iterations = 0;
};
template <class Option>
[[nodiscard]] OverlapSearch overlap_search(const Option& option) {
  if constexpr (requires { option.mpr_tolerance; }) {
    return {option.mpr_tolerance, option.mpr_iterations};
  } else {
    return {option.ccd_tolerance, option.ccd_iterations};
  }
}

/// Whether the model tests only the pairs that it lists for contacts.
[[nodiscard]] inline bool tests_only_pairs(const mjModel& model) {
#if mjVERSION_HEADER >= 300
  return std::all_of(model.geom_contype, model.geom_contype + model.ngeom, [](int type) { return type == 0; });
#else
  return model.opt.collision == mjCOL_PAIR;
#endif
}

/// Whether the model tests the pairs that it lists.
[[nodiscard]] inline bool tests_pairs([[maybe_unused]] const mjModel& model) {
#if mjVERSION_HEADER >= 300
  return true;
#else
  return model.opt.collision != mjCOL_DYNAMIC;
#endif
}

}  // namespace trophic::backend::mujoco
