// SPDX-License-Identifier: MIT
// The arena as ODE geometry: planes for floor and walls, a height field for slopes, cylinders and boxes for obstacles.
#pragma once

#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <trophic/backend/ode/engine.hpp>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/load/arena.hpp>
#include <vector>

namespace trophic::backend::ode {

/// The ground of the arena. Boxes over the flat middle touch the plane z = 0 in either kind of arena; the height field, which
/// costs more, is tested only for boxes that reach beyond it.
class Ground {
 public:
  explicit Ground(const Arena& arena) : floor_{dCreatePlane(nullptr, 0.0, 0.0, 1.0, 0.0)}, flat_m_{arena.half_side_m} {
    for (const Obstacle& one : arena.obstacles) add(one);
    if (arena.height_field) {
      flat_m_ = std::min(flat_m_, flat_half_side_m(*arena.height_field));
      build_heights(*arena.height_field);
      return;
    }
    for (const auto& [x, y] : {std::array{1.0, 0.0}, std::array{-1.0, 0.0}, std::array{0.0, 1.0}, std::array{0.0, -1.0}}) {
      walls_.emplace_back(dCreatePlane(nullptr, -x, -y, 0.0, -arena.half_side_m));
    }
  }

  /// Calls `touch(ground geom)` for each part of the ground that a box with this bounding sphere could touch.
  template <class Touch>
  void for_each_near(const double* centre_m, double radius_m, Touch&& touch) const {
    for (const Standing& one : obstacles_) {
      if (distance_m(one.obstacle, centre_m[0], centre_m[1]) > radius_m) continue;
      for (const GeomPtr& part : one.parts) touch(part.get());
    }
    const double reach_m = std::max(std::abs(centre_m[0]), std::abs(centre_m[1])) + radius_m;
    if (heights_ && reach_m > flat_m_) return touch(heights_.get());
    if (centre_m[2] < radius_m) touch(floor_.get());
    if (heights_ || reach_m < flat_m_) return;
    for (const GeomPtr& wall : walls_) touch(wall.get());
  }

 private:
  struct Standing {
    Obstacle obstacle;
    std::vector<GeomPtr> parts;
  };

  /// A pillar is a cylinder, a wall a box with a cylinder at each end.
  void add(const Obstacle& one) {
    Standing standing{.obstacle = one, .parts = {}};
    const double half_m = 0.5 * one.height_m;
    const auto end = [&](double x_m, double y_m) {
      standing.parts.emplace_back(dCreateCylinder(nullptr, one.radius_m, one.height_m));
      dGeomSetPosition(standing.parts.back().get(), x_m, y_m, half_m);
    };
    end(one.x_m, one.y_m);
    if (!one.is_pillar()) {
      end(one.to_x_m, one.to_y_m);
      standing.parts.emplace_back(dCreateBox(nullptr, one.length_m(), 2.0 * one.radius_m, one.height_m));
      dGeomSetPosition(standing.parts.back().get(), one.middle_x_m(), one.middle_y_m(), half_m);
      dMatrix3 turn;
      dRFromAxisAndAngle(turn, 0.0, 0.0, 1.0, one.turn_rad());
      dGeomSetRotation(standing.parts.back().get(), turn);
    }
    obstacles_.push_back(std::move(standing));
  }

  /// ODE's height fields lie in x and z with heights along y: turned by 90 degrees about x, so that rows run against y.
  void build_heights(const HeightField& field) {
    std::vector<double> rows_turned;
    for (std::size_t iy = field.nodes; iy-- > 0;) {
      const auto row = field.height_m.begin() + static_cast<std::ptrdiff_t>(iy * field.nodes);
      rows_turned.insert(rows_turned.end(), row, row + static_cast<std::ptrdiff_t>(field.nodes));
    }
    const double side_m = 2.0 * field.half_extent_m;
    const int nodes = static_cast<int>(field.nodes);
    constexpr int copy = 1;
    constexpr int no_wrap = 0;
    constexpr double thickness_m = 10.0;
    height_data_.reset(dGeomHeightfieldDataCreate());
    dGeomHeightfieldDataBuildDouble(height_data_.get(), rows_turned.data(), copy, side_m, side_m, nodes, nodes, 1.0, 0.0,
                                    thickness_m, no_wrap);
    const auto [low, high] = std::ranges::minmax(field.height_m);
    dGeomHeightfieldDataSetBounds(height_data_.get(), low - thickness_m, high);
    heights_.reset(dCreateHeightfield(nullptr, height_data_.get(), 1));
    const dMatrix3 turned{1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0};
    dGeomSetRotation(heights_.get(), turned);
  }

  GeomPtr floor_;
  double flat_m_;
  std::vector<GeomPtr> walls_;
  std::vector<Standing> obstacles_;
  HeightsPtr height_data_;
  GeomPtr heights_;
};

}  // namespace trophic::backend::ode
