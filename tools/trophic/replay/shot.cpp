// SPDX-License-Identifier: MIT
// Definitions of shot.hpp.
#include <tools/trophic/replay/shot.hpp>

#include <Eigen/Geometry>
#include <limits>

namespace trophic::command::replay {

namespace {

/// The part of half a picture that robots may take above its middle, below it, and to its sides.
constexpr double above = 0.66;
constexpr double below = 0.82;
constexpr double aside = 0.84;

/// The closest shot in a direction, and how deep the paths are in it. `lift` moves the robots from the middle (0) to the upper
/// edge (1) of a picture that is higher than they need.
std::pair<Shot, double> framed(std::span<const Track> tracks, double azimuth_deg, double elevation_deg, double lift) {
  const film::Sight axes{{.distance_m = 0.0, .azimuth_deg = azimuth_deg, .elevation_deg = elevation_deg}};
  Eigen::AlignedBox3d box;  // to the right, up, and away from the camera
  for (const Track& track : tracks) {
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(1.2 * track.radius_m);
    for (const Eigen::Vector3d& place : track.places_m) {
      const Eigen::Vector3d seen{place.dot(axes.right), place.dot(axes.up), place.dot(axes.forward)};
      box.extend(Eigen::Vector3d{seen - reach}).extend(Eigen::Vector3d{seen + reach});
    }
  }
  const double half_high = box.sizes().y() / (above + below);
  const double slack = std::max(0.0, 0.5 * box.sizes().x() / (aside * aspect_of_shots) - half_high);
  const double up = box.center().y() + 0.5 * (below - above) * half_high - lift * above * slack;
  Shot shot{.at_m = box.center().x() * axes.right + up * axes.up, .azimuth_deg = azimuth_deg, .elevation_deg = elevation_deg};
  shot.at_m -= shot.at_m.z() / axes.forward.z() * axes.forward;  // on the floor
  shot.near_m = shot.at_m.dot(axes.forward) - box.min().z();
  shot.high_m = std::max((box.max().y() - up) / above, (up - box.min().y()) / below) / film::half_height();
  shot.wide_m = 0.5 * box.sizes().x() / aside / film::half_height();
  return {shot, box.sizes().z()};
}

/// The share of a picture beyond the edge of an arena.
double outside_share(const film::Sight& sight, const film::Edge& edge) {
  constexpr int steps = 10;
  int outside = 0;
  for (int ix = 0; ix < steps; ++ix) {
    for (int iy = 0; iy < steps; ++iy) {
      const double x = aspect_of_shots * ((2 * ix + 1.0) / steps - 1.0);
      const double y = (2 * iy + 1.0) / steps - 1.0;
      const Eigen::Vector3d ray = sight.forward + film::half_height() * (x * sight.right + y * sight.up);
      double leaves = std::numeric_limits<double>::infinity();
      for (int axis = 0; axis < 2; ++axis) {
        if (std::abs(ray[axis]) > 1e-9)
          leaves = std::min(leaves, (std::copysign(edge.at_m, ray[axis]) - sight.eye_m[axis]) / ray[axis]);
      }
      if (sight.eye_m.z() + leaves * ray.z() > edge.height_m) ++outside;
    }
  }
  return outside / static_cast<double>(steps * steps);
}

}  // namespace

Shot shot_of(std::span<const Track> tracks, const Arena& arena) {
  Shot best;
  double least = std::numeric_limits<double>::infinity();
  for (const double elevation_deg : {-38.0, -50.0, -64.0}) {
    for (int step = 0; step < 24; ++step) {
      const double azimuth_deg = std::fmod(90.0 + 15.0 * step, 360.0);
      for (const double lift : {0.0, 0.5, 1.0}) {
        auto [shot, deep_m] = framed(tracks, azimuth_deg, elevation_deg, lift);
        const film::Camera camera = shot.camera(aspect_of_shots);
        const film::Sight sight{camera};
        shot.is_inside = sight.eye_m.head<2>().cwiseAbs().maxCoeff() < 0.99 * arena.half_side_m;
        shot.outside_share = outside_share(sight, film::edge_of(arena));
        constexpr double little = 0.08;  // a strip behind a wall does no harm
        const double cost = (shot.is_inside ? 0.0 : 100.0) + 3.0 * std::max(0.0, shot.outside_share - little) +
                            std::log(camera.distance_m - shot.near_m + 0.5 * deep_m) + 0.01 * -elevation_deg + 0.08 * lift;
        if (cost >= least) continue;
        least = cost;
        best = shot;
      }
    }
  }
  return best;
}

}  // namespace trophic::command::replay
