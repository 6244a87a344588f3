// SPDX-License-Identifier: MIT
// Numbers that describe the shape of a body: those of [miras2018], and plain counts.
#pragma once

#include <cstddef>
#include <trophic/habitat/body/module.hpp>
#include <trophic/params/params.hpp>

namespace trophic::body {

/// The shape of a body of m modules on their grid, each descriptor between 0 and 1, as [miras2018] defines them for flat bodies.
/// A body in three dimensions has a third side of its bounding box in `coverage`; the others do not change.
///   size             m / most modules that a plan may have; above 1 for a larger plan
///   proportion       shorter / longer side of the bounding box seen from above
///   coverage         m / cells of the bounding box
///   branching        b / floor((m - 2) / 3), b: modules with all four faces attached; 0 if m < 5
///   limbs            l / l_max, l: modules but the core with one face attached; l_max = 2 floor((m - 6) / 3) + (m - 6) mod 3 + 4
///                    if m >= 6, else m - 1; 0 if m = 1
///   length_of_limbs  e / (m - 2), e: modules but the core with two faces attached; 0 if m < 3
///   symmetry         the larger of two shares: of the modules off the plane y = 0 (x = 0) through the core, those with a module
///                    of the same type at the mirrored cell; 0 for a plane that contains all modules
///   joints           j / floor((m - 1) / 2), j: hinges between two modules that are core or brick; 0 if m < 3
struct Descriptors {
  double size = 0.0;
  double proportion = 0.0;
  double coverage = 0.0;
  double branching = 0.0;
  double limbs = 0.0;
  double length_of_limbs = 0.0;
  double symmetry = 0.0;
  double joints = 0.0;

  friend bool operator==(const Descriptors&, const Descriptors&) = default;
  static constexpr auto fields() {
    return std::tuple{field("size", &Descriptors::size),         field("proportion", &Descriptors::proportion),
                      field("coverage", &Descriptors::coverage), field("branching", &Descriptors::branching),
                      field("limbs", &Descriptors::limbs),       field("length_of_limbs", &Descriptors::length_of_limbs),
                      field("symmetry", &Descriptors::symmetry), field("joints", &Descriptors::joints)};
  }
};

/// Describes a body. `most_modules` (> 0) is the size to which `size` refers.
[[nodiscard]] Descriptors descriptors_of(const ModuleTree& tree, std::size_t most_modules);

/// Modules of a type.
[[nodiscard]] std::size_t count(const ModuleTree& tree, ModuleType type);

}  // namespace trophic::body

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/body/descriptors.ipp>
#endif
