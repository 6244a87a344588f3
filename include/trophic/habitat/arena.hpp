// SPDX-License-Identifier: MIT
// The ground of an experiment, for any physics engine.
#pragma once

#include <cstddef>
#include <optional>
#include <trophic/params/params.hpp>
#include <vector>

namespace trophic {

/// Heights on a regular square grid that spans [-half_extent_m, half_extent_m] in x and y; linear in between.
struct HeightField {
  std::size_t nodes = 0;  ///< nodes along each side, >= 2
  double half_extent_m = 0.0;
  std::vector<double> height_m;  ///< nodes * nodes values, y-major: height_m[iy * nodes + ix], >= 0

  static constexpr auto fields() {
    return std::tuple{field("nodes", &HeightField::nodes), field("half_extent_m", &HeightField::half_extent_m),
                      field("height_m", &HeightField::height_m)};
  }
};

/// A square arena centred at the origin with its floor at z = 0.
struct Arena {
  std::string name;
  double half_side_m = 10.0;                ///< the floor is flat for |x|, |y| <= half_side_m: walls or slopes begin there
  double extent_m = 20.0;                   ///< largest terrain extent (the paper's "maximum terrain bounds")
  double friction = 1.0;                    ///< sliding friction coefficient of floor and walls
  std::optional<HeightField> height_field;  ///< none: a plane with four vertical walls

  static constexpr auto fields() {
    return std::tuple{field("name", &Arena::name), field("half_side_m", &Arena::half_side_m), field("extent_m", &Arena::extent_m),
                      field("friction", &Arena::friction), field("height_field", &Arena::height_field)};
  }
};

}  // namespace trophic
