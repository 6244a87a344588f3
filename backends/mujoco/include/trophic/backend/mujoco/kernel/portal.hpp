// SPDX-License-Identifier: MIT
// Depth and place of the overlap of two convex bodies, with the bits that MuJoCo 2.2 gets from libccd.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

/// Minkowski portal refinement: Snethen, G. (2008). XenoCollide: Complex collision made simple. Game Programming Gems 7, 165-178.
/// Operations and their order are those of libccd 2.1 in double precision, because rounding decides the branches.
namespace trophic::backend::kernel::portal {

struct Point {
  double x, y, z;
};

[[nodiscard]] constexpr Point operator+(const Point& a, const Point& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[nodiscard]] constexpr Point operator-(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] constexpr Point operator*(const Point& a, double s) {
  return {a.x * s, a.y * s, a.z * s};
}
[[nodiscard]] constexpr double dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] constexpr Point cross(const Point& a, const Point& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline Point unit(const Point& a) {
  return a * (1.0 / std::sqrt(dot(a, a)));
}

[[nodiscard]] inline bool is_zero(double value) {
  return std::abs(value) < std::numeric_limits<double>::epsilon();
}
/// Whether two numbers are the same up to rounding.
[[nodiscard]] inline bool same(double a, double b) {
  const double apart = std::abs(a - b);
  return is_zero(apart) || apart < std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
}
[[nodiscard]] inline bool is_origin(const Point& a) {
  return same(a.x, 0.0) && same(a.y, 0.0) && same(a.z, 0.0);
}
/// Whether a number is at least or at most another, up to rounding.
[[nodiscard]] inline bool at_most(double a, double b) {
  return same(a, b) || a < b;
}
[[nodiscard]] inline bool not_negative(double a) {
  return is_zero(a) || a > 0.0;
}

/// A point of the difference of two bodies, and the points that it is the difference of.
struct Vertex {
  Point apart, first, second;
};

/// The point of a triangle that is nearest to the origin.
[[nodiscard]] inline Point nearest_of_triangle(const Point& a, const Point& b, const Point& c) {
  const Point ab = b - a;
  const Point ac = c - a;
  const double aa = dot(ab, ab);
  const double cc = dot(ac, ac);
  const double along_b = dot(a, ab);
  const double along_c = dot(a, ac);
  const double mixed = dot(ab, ac);
  const double area = cc * aa - mixed * mixed;
  double s = -1.0;
  double t = -1.0;
  if (!is_zero(area)) {
    s = (along_c * mixed - cc * along_b) / area;
    t = (-s * mixed - along_c) / cc;
  }
  if (not_negative(s) && at_most(s, 1.0) && not_negative(t) && at_most(t, 1.0) && at_most(t + s, 1.0)) return a + ab * s + ac * t;
  const auto nearest_of_edge = [](const Point& from, const Point& to) {
    const Point edge = to - from;
    const double part = -dot(from, edge) / dot(edge, edge);
    if (part < 0.0 || is_zero(part)) return from;
    if (part > 1.0 || same(part, 1.0)) return to;
    return edge * part + from;
  };
  Point nearest = nearest_of_edge(a, b);
  for (const Point& other : {nearest_of_edge(a, c), nearest_of_edge(b, c)}) {
    if (dot(other, other) < dot(nearest, nearest)) nearest = other;
  }
  return nearest;
}

/// An overlap of two bodies.
struct Overlap {
  double depth;
  Point direction;  ///< unit, from the first body to the second
  Point place;
};

/// The search for the overlap of two bodies. A body has a `centre()` and a `support(direction)`, its farthest point that way.
template <class First, class Second>
class Search {
 public:
  Search(const First& first, const Second& second) : first_{first}, second_{second} {}

  /// The overlap to a depth that is at most `tolerance` too small, unless that takes over `most_steps`; none where the bodies are
  /// apart or their overlap has no direction.
  [[nodiscard]] std::optional<Overlap> find(double tolerance, int most_steps) {
    v_[0].first = first_.centre();
    v_[0].second = second_.centre();
    v_[0].apart = v_[0].first - v_[0].second;
    if (is_origin(v_[0].apart)) v_[0].apart = v_[0].apart + Point{10.0 * std::numeric_limits<double>::epsilon(), 0.0, 0.0};

    const Point inward = unit(v_[0].apart * -1.0);
    v_[1] = support(inward);
    if (!beyond(v_[1], inward)) return std::nullopt;
    const Point across = cross(v_[0].apart, v_[1].apart);
    if (is_zero(dot(across, across))) return on_the_ray();
    if (!discover(unit(across)) || !reach_origin(tolerance)) return std::nullopt;
    return refine(tolerance, most_steps);
  }

 private:
  [[nodiscard]] Vertex support(const Point& direction) const {
    Vertex found;
    found.first = first_.support(direction);
    found.second = second_.support(direction * -1.0);
    found.apart = found.first - found.second;
    return found;
  }

  [[nodiscard]] static bool beyond(const Vertex& vertex, const Point& direction) {
    const double along = dot(vertex.apart, direction);
    return !is_zero(along) && !(along < 0.0);
  }

  /// The overlap where the first support lies on the ray from the centres through the origin.
  [[nodiscard]] std::optional<Overlap> on_the_ray() const {
    const Point& apart = v_[1].apart;
    if (is_origin(apart)) return std::nullopt;
    return Overlap{std::sqrt(dot(apart, apart)), unit(apart), (v_[1].first + v_[1].second) * 0.5};
  }

  /// The outward direction of the triangle of three vertices.
  [[nodiscard]] Point outward() const { return unit(cross(v_[2].apart - v_[1].apart, v_[3].apart - v_[1].apart)); }

  /// Completes a tetrahedron whose outer triangle is met by the ray from the centres through the origin. False: bodies are apart.
  [[nodiscard]] bool discover(const Point& across) {
    v_[2] = support(across);
    if (!beyond(v_[2], across)) return false;
    const auto normal = [&] { return unit(cross(v_[1].apart - v_[0].apart, v_[2].apart - v_[0].apart)); };
    Point direction = normal();
    if (dot(direction, v_[0].apart) > 0.0) {
      std::swap(v_[1], v_[2]);
      direction = direction * -1.0;
    }
    const auto outside = [&](const Vertex& a, const Vertex& b) {
      const double side = dot(cross(a.apart, b.apart), v_[0].apart);
      return side < 0.0 && !is_zero(side);
    };
    while (true) {
      v_[3] = support(direction);
      if (!beyond(v_[3], direction)) return false;
      if (outside(v_[1], v_[3])) {
        v_[2] = v_[3];
      } else if (outside(v_[3], v_[2])) {
        v_[1] = v_[3];
      } else {
        return true;
      }
      direction = normal();
    }
  }

  /// Replaces the vertex of the outer triangle so that the ray still meets it.
  void expand(const Vertex& vertex) {
    const Point side = cross(vertex.apart, v_[0].apart);
    if (dot(v_[1].apart, side) > 0.0) {
      v_[dot(v_[2].apart, side) > 0.0 ? 1 : 3] = vertex;
    } else {
      v_[dot(v_[3].apart, side) > 0.0 ? 2 : 1] = vertex;
    }
  }

  /// Whether a support is at most `tolerance` farther out than the triangle.
  [[nodiscard]] bool is_surface(const Vertex& vertex, const Point& direction, double tolerance) const {
    const double out = dot(vertex.apart, direction);
    double gain = out - dot(v_[1].apart, direction);
    for (std::size_t k = 2; k < 4; ++k) gain = std::min(gain, out - dot(v_[k].apart, direction));
    return at_most(gain, tolerance);
  }

  /// Moves the triangle out until the origin is inside. False: bodies are apart.
  [[nodiscard]] bool reach_origin(double tolerance) {
    while (true) {
      const Point direction = outward();
      if (not_negative(dot(direction, v_[1].apart))) return true;
      const Vertex vertex = support(direction);
      if (!not_negative(dot(vertex.apart, direction)) || is_surface(vertex, direction, tolerance)) return false;
      expand(vertex);
    }
  }

  /// Moves the triangle out to the surface of the difference.
  [[nodiscard]] std::optional<Overlap> refine(double tolerance, int most_steps) {
    for (int step = 0;; ++step) {
      const Point direction = outward();
      const Vertex vertex = support(direction);
      if (is_surface(vertex, direction, tolerance) || step > most_steps) break;
      expand(vertex);
    }
    const Point nearest = nearest_of_triangle(v_[1].apart, v_[2].apart, v_[3].apart);
    const double depth = std::sqrt(dot(nearest, nearest));
    if (is_zero(depth)) return std::nullopt;
    return Overlap{depth, unit(nearest), place()};
  }

  /// The origin as a point of both bodies, by its barycentric coordinates in the tetrahedron or, where that is flat, the
  /// triangle.
  [[nodiscard]] Point place() const {
    const auto volume = [&](std::size_t a, std::size_t b, std::size_t c) {
      return dot(cross(v_[a].apart, v_[b].apart), v_[c].apart);
    };
    std::array<double, 4> weight = {volume(1, 2, 3), volume(3, 2, 0), volume(0, 1, 3), volume(2, 1, 0)};
    double sum = weight[0] + weight[1] + weight[2] + weight[3];
    if (is_zero(sum) || sum < 0.0) {
      const Point direction = outward();
      const auto area = [&](std::size_t a, std::size_t b) { return dot(cross(v_[a].apart, v_[b].apart), direction); };
      weight = {0.0, area(2, 3), area(3, 1), area(1, 2)};
      sum = weight[1] + weight[2] + weight[3];
    }
    Point first{};
    Point second{};
    for (std::size_t k = 0; k < weight.size(); ++k) {
      first = first + v_[k].first * weight[k];
      second = second + v_[k].second * weight[k];
    }
    const double share = 1.0 / sum;
    return (first * share + second * share) * 0.5;
  }

  const First& first_;
  const Second& second_;
  std::array<Vertex, 4> v_;
};

/// The overlap of two bodies, to a depth that is at most `tolerance` too small unless that takes over `most_steps`; none where
/// they are apart. Not inlined, so that it is compiled once.
template <class First, class Second>
[[nodiscard, gnu::noinline]] std::optional<Overlap> find_overlap(const First& first, const Second& second, double tolerance,
                                                                 int most_steps) {
  return Search{first, second}.find(tolerance, most_steps);
}

}  // namespace trophic::backend::kernel::portal
