// SPDX-License-Identifier: MIT
// Contacts of two overlapping boxes, bitwise equal to MuJoCo's.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <trophic/backend/mujoco/kernel/four.hpp>
#include <tuple>
#include <utility>

namespace trophic::backend::kernel {

using Point3 = std::array<double, 3>;

/// A box in world axes.
struct PlacedBox {
  Point3 centre_m;
  Point3 half_m;
  std::array<Point3, 3> axis;  ///< axis[k] is the direction of extent k
};

[[nodiscard]] TROPHIC_LANES_INLINE Point3 minus(const Point3& a, const Point3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
/// In the order of MuJoCo's function.
[[nodiscard]] TROPHIC_LANES_INLINE double dot3(const Point3& a, const Point3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A vector in three lanes.
[[nodiscard]] TROPHIC_LANES_INLINE Four lanes3(const Point3& a) {
  return Four{a[0], a[1], a[2], 0.0};
}
[[nodiscard]] TROPHIC_LANES_INLINE Four cross3(const Four& a, const Four& b) {
  return __builtin_shufflevector(a, a, 1, 2, 0, 3) * __builtin_shufflevector(b, b, 2, 0, 1, 3) -
         __builtin_shufflevector(a, a, 2, 0, 1, 3) * __builtin_shufflevector(b, b, 1, 2, 0, 3);
}

/// The axis that lets two boxes overlap least, then their contacts: the operations of MuJoCo's mjc_BoxBox up to version 3.5
/// (S. Kolev, Apache License 2.0) in their order, at margin 0.
///
/// Axis k < 3 is a face normal of the first box, k < 6 of the second, 6 + 3 i + j the product of edges i and j. Contacts are
/// found in the axes of a face turned upwards: the three axes of its box with signs, from the middle of the face.
class BoxOverlap {
 public:
  static constexpr std::size_t most = 24;
  std::size_t count = 0;
  std::array<Point3, most> points_m;
  std::array<double, most> depths_m;  ///< signed distances, negative where the boxes overlap; half of them if `on_face`
  Point3 normal;                      ///< from the first box to the second, of about unit length
  bool on_face = false;               ///< a face of one box meets the other
  double gap_m = 0.0;                 ///< if they are `separated`, their distance along the axis that showed it

  /// `apart_m` is added to the second box's centre.
  TROPHIC_LANES_INLINE BoxOverlap(const PlacedBox& first, const PlacedBox& second, const Point3& apart_m)
      : a_{first}, b_{second}, at_a_{first.centre_m} {
    for (std::size_t i = 0; i < 3; ++i) at_b_[i] = second.centre_m[i] + apart_m[i];
  }

  /// Whether the boxes overlap by less than `least_m` along an axis; else finds the least overlap.
  [[nodiscard]] TROPHIC_LANES_INLINE bool separated(double least_m) {
    const Four ax[3] = {lanes_of(a_.axis, 0), lanes_of(a_.axis, 1), lanes_of(a_.axis, 2)};
    const Four bx[3] = {lanes_of(b_.axis, 0), lanes_of(b_.axis, 1), lanes_of(b_.axis, 2)};
    Four row[3];     // cosines of one axis of the first with those of the second
    Four column[3];  // and the reverse
    for (std::size_t k = 0; k < 3; ++k) {
      row[k] = a_.axis[k][0] * bx[0] + a_.axis[k][1] * bx[1] + a_.axis[k][2] * bx[2];
      column[k] = ax[0] * b_.axis[k][0] + ax[1] * b_.axis[k][1] + ax[2] * b_.axis[k][2];
    }
    const Point3 to_b = minus(at_b_, at_a_);
    const Point3 to_a = minus(at_a_, at_b_);
    const Four b_from_a = ax[0] * to_b[0] + ax[1] * to_b[1] + ax[2] * to_b[2];
    const Four a_from_b = bx[0] * to_a[0] + bx[1] * to_a[1] + bx[2] * to_a[2];
    const Four reach_b = abs(column[0]) * b_.half_m[0] + abs(column[1]) * b_.half_m[1] + abs(column[2]) * b_.half_m[2];
    const Four reach_a = abs(row[0]) * a_.half_m[0] + abs(row[1]) * a_.half_m[1] + abs(row[2]) * a_.half_m[2];
    const Four over_a = Four{a_.half_m[0], a_.half_m[1], a_.half_m[2]} - abs(b_from_a) + reach_b;
    const Four over_b = Four{b_.half_m[0], b_.half_m[1], b_.half_m[2]} - abs(a_from_b) + reach_a;
    const Four least_face = select(over_a < over_b, over_a, over_b);
    if ((four_bits(least_face < least_m) & 7u) != 0) {
      gap_m = -std::min(std::min(least_face[0], least_face[1]), least_face[2]);
      return true;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      least_ += a_.half_m[i] * 3 + b_.half_m[i] * 3;
      b_from_a_[i] = b_from_a[i];
      a_from_b_[i] = a_from_b[i];
      for (std::size_t k = 0; k < 3; ++k) cosine_[k][i] = row[k][i];
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (over_a[i] < least_) std::tie(least_, axis_) = std::pair{over_a[i], i};
      if (over_b[i] < least_) std::tie(least_, axis_) = std::pair{over_b[i], 3 + i};
    }
    return cross_edges(row, least_m);
  }

  /// Finds the contacts.
  TROPHIC_LANES_INLINE void meet() {
    if (axis_ < 6) {
      meet_face();
    } else {
      meet_edge();
    }
  }

 private:
  static constexpr double rounding = 1e-12;
  static constexpr double tiny = 1e-15;  ///< mjMINVAL

  [[nodiscard]] TROPHIC_LANES_INLINE static Four lanes_of(const std::array<Point3, 3>& axis, std::size_t i) {
    return Four{axis[0][i], axis[1][i], axis[2][i], 0.0};
  }

  /// The nine products of edges; those of one edge of the first box are worked on at once.
  [[nodiscard]] TROPHIC_LANES_INLINE bool cross_edges(const Four (&row)[3], double least_m) {
    const Four size_low = {b_.half_m[1], b_.half_m[0], b_.half_m[0], 0.0};
    const Four size_high = {b_.half_m[2], b_.half_m[2], b_.half_m[1], 0.0};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t u = i == 0 ? 1 : 0;
      const std::size_t v = i == 2 ? 1 : 2;
      const double sign = i == 1 ? -1.0 : 1.0;
      const Four along_u = row[v] * -sign;
      const Four along_v = row[u] * sign;
      const Four length = sqrt(along_u * along_u + along_v * along_v);
      const FourMask known = length >= tiny;
      const Four scale = 1.0 / length;
      const Four tu = along_u * scale;
      const Four tv = along_v * scale;
      const Four between = b_from_a_[u] * tu + b_from_a_[v] * tv;
      const Four cosines = abs(row[i]);
      const Four over = a_.half_m[u] * abs(tu) + a_.half_m[v] * abs(tv) +
                        size_low * __builtin_shufflevector(cosines, cosines, 2, 2, 1, 3) / length +
                        size_high * __builtin_shufflevector(cosines, cosines, 1, 0, 0, 3) / length - abs(between);
      if (const unsigned apart = four_bits(known & (over < least_m)) & 7u; apart != 0) {
        for (std::size_t j = 0; j < 3; ++j) gap_m = (apart >> j & 1u) != 0 ? std::max(gap_m, -over[j]) : gap_m;
        return true;
      }
      for (std::size_t j = 0; j < 3; ++j) {
        if (known[j] == 0 || !(over[j] < least_ * (1 - rounding))) continue;
        std::tie(least_, axis_, inwards_) = std::tuple{over[j], 6 + 3 * i + j, between[j] < 0.0};
        edge_normal_ = {};
        edge_normal_[u] = tu[j];
        edge_normal_[v] = tv[j];
      }
    }
    return false;
  }

  /// How a box's axes become those of its face; opposite faces are three apart.
  struct Turn {
    std::array<std::size_t, 3> axis;
    Point3 sign;

    [[nodiscard]] TROPHIC_LANES_INLINE Point3 of(const Point3& a) const {
      return {0.0 + a[axis[0]] * sign[0], 0.0 + a[axis[1]] * sign[1], 0.0 + a[axis[2]] * sign[2]};
    }
    /// A vector in the axes of the face of a box, in those of the world.
    [[nodiscard]] TROPHIC_LANES_INLINE Point3 back(const PlacedBox& box, const Point3& a) const {
      Point3 sum;
      for (std::size_t i = 0; i < 3; ++i) sum[i] = dot3(of({box.axis[0][i], box.axis[1][i], box.axis[2][i]}), a);
      return sum;
    }
  };
  static constexpr std::array<Turn, 6> turns = {Turn{{2, 1, 0}, {-1, 1, 1}}, Turn{{0, 2, 1}, {1, -1, 1}},
                                                Turn{{0, 1, 2}, {1, 1, 1}},  Turn{{2, 1, 0}, {1, 1, -1}},
                                                Turn{{0, 2, 1}, {1, 1, -1}}, Turn{{0, 1, 2}, {-1, 1, -1}}};

  /// The sides of a parallelogram as lines: from a corner along s and t, and those across from them.
  struct Lines {
    Four start[3];
    Four way[3];
    TROPHIC_LANES_INLINE Lines(const Point3& corner, const Point3& s, const Point3& t) {
      for (std::size_t j = 0; j < 3; ++j) {
        start[j] = Four{corner[j], corner[j], corner[j] + s[j], corner[j] + t[j]};
        way[j] = Four{s[j], t[j], t[j], s[j]};
      }
    }
  };

  /// Calls `take(line, q, side, part, other)` where lines cut the lower and the upper side of a rectangle across x and y: how far
  /// along the line, and its other coordinate there.
  template <class Take>
  TROPHIC_LANES_INLINE static void cut(const Lines& lines, std::size_t count, const Point3& half, const Take& take) {
    Four part[2][2];
    Four other[2][2];
    unsigned hits[2][2];
    for (std::size_t q = 0; q < 2; ++q) {
      const Four inverse = 1.0 / lines.way[q];
      for (std::size_t side = 0; side < 2; ++side) {
        part[q][side] = ((side == 0 ? -half[q] : half[q]) - lines.start[q]) * inverse;
        other[q][side] = lines.start[1 - q] + lines.way[1 - q] * part[q][side];
        const FourMask missed = (part[q][side] < 0.0) | (part[q][side] > 1.0) | (abs(other[q][side]) > half[1 - q]);
        hits[q][side] = four_bits((abs(lines.way[q]) > tiny) & ~missed);
      }
    }
    for (std::size_t line = 0; line < count; ++line) {
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t q = k / 2;
        const std::size_t side = k % 2;
        if ((hits[q][side] >> line & 1u) != 0)
          take(line, q, side == 0 ? -half[q] : half[q], part[q][side][line], other[q][side][line]);
      }
    }
  }

  TROPHIC_LANES_INLINE void meet_face() {
    on_face = true;
    const bool of_b = axis_ >= 3;
    const PlacedBox& up = of_b ? b_ : a_;
    const PlacedBox& down = of_b ? a_ : b_;
    const Point3& from_up = of_b ? a_from_b_ : b_from_a_;
    const Turn& turn = turns[axis_ % 3 + (from_up[axis_ % 3] < 0 ? 3 : 0)];
    const Point3 half = {up.half_m[turn.axis[0]], up.half_m[turn.axis[1]], up.half_m[turn.axis[2]]};
    Point3 axes[3];  // of the lower box, seen from the face
    for (std::size_t i = 0; i < 3; ++i) {
      axes[i] = turn.of(of_b ? cosine_[i] : Point3{cosine_[0][i], cosine_[1][i], cosine_[2][i]});
    }
    // Its lowest corner, and the sides from there that are not steep.
    Point3 corner = turn.of(from_up);
    corner[2] -= half[2];
    Point3 sides[2] = {};
    std::size_t flat = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double way = down.half_m[i] * (axes[i][2] < 0 ? 1.0 : -1.0);
      const bool is_flat = std::abs(axes[i][2]) < 0.5 && flat < 2;
      for (std::size_t j = 0; j < 3; ++j) {
        corner[j] += axes[i][j] * way;
        if (is_flat) sides[flat][j] = axes[i][j] * (-2.0 * way);
      }
      flat += is_flat ? 1 : 0;
    }
    const auto& [s, t] = sides;
    const auto add = [&](const Point3& point) {
      if (point[2] > 0.0) return;
      points_m[count] = {point[0], point[1], point[2] * 0.5};
      depths_m[count] = points_m[count][2];
      ++count;
    };
    const Lines lines{corner, s, t};
    const auto on_line = [&](std::size_t line, double part) {
      Point3 point;
      for (std::size_t j = 0; j < 3; ++j) point[j] = lines.start[j][line] + lines.way[j][line] * part;
      return point;
    };
    cut(lines, flat == 2 ? 4 : flat, half,
        [&](std::size_t line, std::size_t, double, double part, double) { add(on_line(line, part)); });
    const double inverse = 1 / (s[0] * t[1] - t[0] * s[1]);
    for (unsigned i = 0; flat == 2 && i < 4; ++i) {
      const double x = i / 2 != 0 ? half[0] : -half[0];
      const double y = i % 2 != 0 ? half[1] : -half[1];
      const double u = ((x - corner[0]) * t[1] - (y - corner[1]) * t[0]) * inverse;
      const double v = ((y - corner[1]) * s[0] - (x - corner[0]) * s[1]) * inverse;
      if (!(u <= 0 || v <= 0 || u >= 1 || v >= 1)) add({x, y, corner[2] + u * s[2] + v * t[2]});
    }
    add(corner);
    const auto add_inside = [&](const Point3& point) {
      if (!(point[0] <= -half[0] || point[0] >= half[0] || point[1] <= -half[1] || point[1] >= half[1])) add(point);
    };
    const Point3 across = {lines.start[0][2], lines.start[1][2], lines.start[2][2]};
    if (flat > 0) add_inside(across);
    if (flat == 2) {
      add_inside({lines.start[0][3], lines.start[1][3], lines.start[2][3]});
      add_inside({across[0] + t[0], across[1] + t[1], across[2] + t[2]});
    }
    for (std::size_t i = 0; i < 3; ++i) normal[i] = (of_b ? -1.0 : 1.0) * (0.0 + up.axis[turn.axis[2]][i] * turn.sign[2]);
    finish(turn, up, of_b ? at_b_ : at_a_, half[2]);
  }

  /// Turns the points, from the face at this height, back into world axes.
  TROPHIC_LANES_INLINE void finish(const Turn& turn, const PlacedBox& up, const Point3& centre_m, double height_m) {
    for (std::size_t c = 0; c < count; ++c) {
      points_m[c][2] += height_m;
      points_m[c] = turn.back(up, points_m[c]);
      for (std::size_t i = 0; i < 3; ++i) points_m[c][i] += centre_m[i];
    }
  }

  TROPHIC_LANES_INLINE void meet_edge() {
    const std::size_t of_a = (axis_ - 6) / 3;
    const std::size_t of_b = (axis_ - 6) % 3;
    constexpr std::size_t others[3][2] = {{1, 2}, {0, 2}, {1, 0}};
    std::size_t b1 = others[of_b][0];
    std::size_t b2 = others[of_b][1];
    std::size_t a2 = others[of_a][1];
    if (std::abs(cosine_[of_a][b1]) < std::abs(cosine_[of_a][b2])) std::swap(b1, b2);
    if (std::abs(cosine_[others[of_a][0]][of_b]) < std::abs(cosine_[a2][of_b])) a2 = others[of_a][0];
    // On which side of the other axes the edges lie.
    const bool above_a = (edge_normal_[a2] > 0) != inwards_;
    const auto above_b = [&](std::size_t k) {
      return ((cosine_[of_a][3 - k - of_b] > 0) != inwards_) != ((k + 3 - of_b) % 3 == 1);
    };
    const Turn& turn = turns[a2 + (above_a ? 0 : 3)];
    const Point3 half = {a_.half_m[turn.axis[0]], a_.half_m[turn.axis[1]], a_.half_m[turn.axis[2]]};
    const auto axis_of_b = [&](std::size_t k) { return turn.of({cosine_[0][k], cosine_[1][k], cosine_[2][k]}); };
    const Point3 first = axis_of_b(b1);
    const Point3 second = axis_of_b(b2);
    const Point3 along = axis_of_b(of_b);
    const Point3 n = turn.of(edge_normal_);
    if (std::abs(n[2]) < tiny) return;
    const double upwards = 1 / n[2];
    const double height = upwards * (inwards_ ? -1.0 : 1.0);
    // The corners of the second box's face at the edge, and these moved along the normal onto the first's face.
    Point3 middle = turn.of(b_from_a_);
    middle[2] -= half[2];
    Point3 corners[4];
    Point3 shadows[4];
    for (std::size_t c = 0; c < 4; ++c) {
      const double one = b_.half_m[b1] * (above_b(b1) == (c < 2) ? 1.0 : -1.0);
      const double two = b_.half_m[b2] * (above_b(b2) ? 1.0 : -1.0);
      const double three = b_.half_m[of_b] * (c % 2 == 0 ? 1.0 : -1.0);
      for (std::size_t j = 0; j < 3; ++j) corners[c][j] = ((middle[j] + first[j] * one) + second[j] * two) + along[j] * three;
      const double down = -corners[c][2] * upwards;
      for (std::size_t j = 0; j < 3; ++j) shadows[c][j] = corners[c][j] + n[j] * down;
    }
    const Point3 s = minus(shadows[1], shadows[0]);
    const Point3 t = minus(shadows[2], shadows[0]);
    const auto add = [&](const Point3& point, double depth) {
      points_m[count] = point;
      depths_m[count++] = depth;
    };
    const Lines sides{corners[0], minus(corners[1], corners[0]), minus(corners[2], corners[0])};
    cut({shadows[0], s, t}, 4, half, [&](std::size_t line, std::size_t q, double at, double part, double other) {
      if ((sides.start[2][line] + sides.way[2][line] * part) * height > 0.0) return;
      Point3 point;
      for (std::size_t j = 0; j < 3; ++j) point[j] = sides.start[j][line] * 0.5 + sides.way[j][line] * (0.5 * part);
      point[q] += 0.5 * at;
      point[1 - q] += 0.5 * other;
      add(point, point[2] * height * 2);
    });
    const std::size_t cuts = count;
    double area = s[0] * t[1] - t[0] * s[1];  // MuJoCo keeps another number here once it has found a corner
    for (unsigned i = 0; i < 4; ++i) {
      const double x = i / 2 != 0 ? half[0] : -half[0];
      const double y = i % 2 != 0 ? half[1] : -half[1];
      double u = ((x - shadows[0][0]) * t[1] - (y - shadows[0][1]) * t[0]) * (1 / area);
      double v = ((y - shadows[0][1]) * s[0] - (x - shadows[0][0]) * s[1]) * (1 / area);
      const bool beyond_s = u < 0 || u > 1;
      const bool beyond_t = v < 0 || v > 1;
      if (cuts == 0 ? beyond_s && beyond_t : beyond_s || beyond_t) continue;
      u = u < 0 ? 0 : u > 1 ? 1 : u;
      v = v < 0 ? 0 : v > 1 ? 1 : v;
      Point3 on;
      for (std::size_t j = 0; j < 3; ++j) on[j] = (corners[0][j] * (1 - u - v) + corners[1][j] * u) + corners[2][j] * v;
      const Point3 away = minus({x, y, 0.0}, on);
      area = dot3(away, away);
      if (on[2] > 0 && area > 0) continue;
      add({(x + on[0]) * 0.5, (y + on[1]) * 0.5, (0 + on[2]) * 0.5}, std::sqrt(area) * (on[2] < 0 ? -1 : 1));
    }
    const std::size_t found = count;
    for (std::size_t i = 0; i < 4; ++i) {
      const double part = corners[i][2] * height;
      double square = 0;
      Point3 on = {shadows[i][0] * 0.5, shadows[i][1] * 0.5, 0};
      bool beyond[2];
      for (std::size_t j = 0; j < 2; ++j) {
        const double side = shadows[i][j] < -half[j] ? -half[j] : half[j];
        beyond[j] = shadows[i][j] < -half[j] || shadows[i][j] > half[j];
        if (!beyond[j]) continue;
        square += (shadows[i][j] - side) * (shadows[i][j] - side);
        on[j] = side * 0.5;
      }
      if (cuts != 0 ? beyond[0] || beyond[1] : found != 0 && beyond[0] && beyond[1]) continue;
      square += part * corners[i][2] * height;
      if (corners[i][2] > 0 && square > 0) continue;
      for (std::size_t j = 0; j < 3; ++j) on[j] += corners[i][j] * 0.5;
      add(on, std::sqrt(square) * (corners[i][2] < 0 ? -1 : 1));
    }
    normal = turn.back(a_, n);
    for (double& part : normal) part *= inwards_ ? -1.0 : 1.0;
    finish(turn, a_, at_a_, half[2]);
  }

  const PlacedBox& a_;
  const PlacedBox& b_;
  Point3 at_a_;
  Point3 at_b_;
  Point3 b_from_a_;
  Point3 a_from_b_;
  std::array<Point3, 3> cosine_;  ///< cosines of the first box's axes with those of the second
  double least_ = 0.0;
  std::size_t axis_ = 0;
  Point3 edge_normal_;
  bool inwards_ = false;
};

}  // namespace trophic::backend::kernel
