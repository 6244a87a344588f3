// SPDX-License-Identifier: MIT
// Definitions of overlay.hpp.
#include <tools/film/overlay.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>
#include <trophic/params/params.hpp>
#include <vector>

namespace trophic::film {

namespace {

constexpr Colour paper{1.0F, 1.0F, 1.0F};

/// A mark of the legend, in the middle of a square as high as a line.
void draw_mark(const Overlay& overlay, const LegendEntry& entry, double x, double y, double radius) {
  using Mark = LegendEntry::Mark;
  const double thin = std::max(1.0, 0.22 * radius);
  switch (entry.mark) {
    case Mark::species:
      return overlay.disc(x, y, radius, entry.colour);
    case Mark::filled:
      overlay.disc(x, y, radius, mixed(paper, entry.colour, 0.45F));
      return overlay.ring(x, y, radius, thin, entry.colour);
    case Mark::hollow:
    case Mark::zone:
      return overlay.ring(x, y, radius, thin, entry.colour);
    case Mark::catch_:
      return overlay.ring(x, y, radius, 0.7 * thin, entry.colour);
    case Mark::death:
      return overlay.ring(x, y, radius, 1.0, entry.colour);
    case Mark::marked:
      overlay.disc(x, y, 0.5 * radius, mixed(paper, entry.colour, 0.45F));
      return overlay.ring(x, y, radius, thin, entry.colour);
    case Mark::trail:
      return overlay.bar(x - radius, y - 0.5 * thin, 2.0 * radius, thin, mixed(paper, entry.colour, 0.7F));
    case Mark::food:
      return overlay.bar(x - radius, y - radius, 2.0 * radius, 2.0 * radius, entry.colour);
    case Mark::sight:
      for (const double dash : {-1.0, -0.2, 0.6})
        overlay.bar(x + dash * radius, y - 0.5 * thin, 0.5 * radius, thin, mixed(paper, entry.colour, 0.7F));
      return;
    case Mark::reach:
      return overlay.ring(x, y, radius, 1.0, entry.colour);
  }
}

/// In one row below `top`, or in several if it is too long. Returns where it ends. `is_drawn`: false to measure it only.
double draw_legend(const Overlay& overlay, const std::vector<LegendEntry>& legend, double top, bool is_drawn = true) {
  const double line = overlay.line_height();
  const double radius = 0.32 * line;
  const double margin = 0.6 * line;
  double x = margin;
  double y = top;
  for (const LegendEntry& entry : legend) {
    const double width = 2.6 * radius + overlay.width_of(entry.text) + 0.9 * line;
    if (x > margin && x + width > overlay.width()) {
      x = margin;
      y -= 1.15 * line;
    }
    if (is_drawn) {
      draw_mark(overlay, entry, x + radius, y - 0.5 * line, radius);
      overlay.text(x + 2.8 * radius, y - 0.82 * line, entry.text, ink);
    }
    x += width;
  }
  return y - 1.15 * line;
}

/// Title and legend, from the top. Returns where they end.
double draw_head(const Overlay& overlay, const Picture& picture, bool is_drawn) {
  const double line = overlay.line_height();
  double top = overlay.height() - 0.3 * line;
  if (!picture.title.empty()) {
    if (is_drawn) overlay.text(0.6 * line, top - 0.82 * line, picture.title, ink);
    top -= 1.25 * line;
  }
  return picture.legend.empty() ? top : draw_legend(overlay, picture.legend, top, is_drawn);
}

/// A bar of 1, 2, 5, ... metres, about a tenth of the picture long at what the camera looks at.
void draw_scale(const Overlay& overlay, const Camera& camera, const mjrRect& stage) {
  const double metre = stage.height / (2.0 * half_height() * camera.distance_m);
  const double wished = 0.12 * overlay.width() / metre;
  const double power = std::pow(10.0, std::floor(std::log10(wished)));
  const double metres = (wished >= 5.0 * power ? 5.0 : wished >= 2.0 * power ? 2.0 : 1.0) * power;
  const double line = overlay.line_height();
  const double right = overlay.width() - 0.8 * line;
  const double left = right - metres * metre;
  const double y = 0.65 * line;
  const double thin = std::max(1.0, 0.1 * line);
  overlay.bar(left, y, right - left, thin, ink);
  for (const double end : {left, right - thin}) overlay.bar(end, y - 0.2 * line, thin, 0.4 * line + thin, ink);
  const std::string text = number_text(metres) + " m";
  overlay.text(left - overlay.width_of(text) - 0.6 * line, 0.35 * line, text, ink);
}

/// In the upper right corner of the stage, beside the far end of the arena.
void draw_curves(const Overlay& overlay, const Picture& picture, const mjrRect& stage) {
  const double line = overlay.line_height();
  const double width = 0.2 * stage.width;
  const double one = 0.2 * stage.height / picture.most;  // height of one individual
  const double left = stage.width - width - 0.8 * line;
  const double bottom = stage.bottom + 0.78 * stage.height;
  overlay.bar(left, bottom, width, picture.most * one, paper);
  overlay.bar(left, bottom, width, 1.0, ink);
  for (const Curve& curve : picture.curves) {
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      const auto& [x0, y0] = curve.points[i - 1];
      const auto& [x1, y1] = curve.points[i];
      overlay.line(left + x0 * width, bottom + y0 * one, left + x1 * width, bottom + y1 * one, 2.0, curve.colour);
    }
  }
  overlay.text(left, bottom - 1.1 * line, "individuals, up to " + number_text(picture.most), ink);
}

/// Text on a plate.
void write_plate(const Overlay& overlay, double x, double y, const std::string& text, const Colour& colour, bool is_large) {
  const double line = overlay.line_height(is_large);
  overlay.bar(x - 0.25 * line, y - 0.2 * line, overlay.width_of(text, is_large) + 0.5 * line, 1.1 * line, colour);
  overlay.text(x, y, text, paper, is_large);
}

/// A rectangle of text.
struct Plate {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;

  /// The area that lies on another one, or on a robot.
  [[nodiscard]] double on(const Plate& other) const {
    const double wide = std::min(x + width, other.x + other.width) - std::max(x, other.x);
    const double high = std::min(y + height, other.y + other.height) - std::max(y, other.y);
    return wide > 0.0 && high > 0.0 ? wide * high : 0.0;
  }
  [[nodiscard]] double on(const Overlay::Disc& robot) const {
    return on(Plate{robot.x - robot.radius, robot.y - robot.radius, 2.0 * robot.radius, 2.0 * robot.radius});
  }
};

/// The place round a robot that covers least of robots and of other names, the nearest of several.
Plate place_of_name(const Overlay::Disc& own, double width, double height, const mjrRect& stage,
                    std::span<const Overlay::Disc> robots, std::span<const Plate> taken) {
  Plate best;
  double least = std::numeric_limits<double>::infinity();
  for (const double gap : {0.4, 1.4, 2.8, 4.5, 7.0}) {
    for (int turn = 0; turn < 16; ++turn) {
      const double angle = std::numbers::pi * (0.5 + 0.125 * (turn % 2 == 0 ? turn / 2 : -(turn + 1) / 2));
      const double away = own.radius + gap * height;
      Plate plate{.width = width, .height = height};
      plate.x = own.x + std::cos(angle) * (away + 0.5 * width) - 0.5 * width;
      plate.y = own.y + std::sin(angle) * (away + 0.5 * height) - 0.5 * height;
      plate.x = std::clamp(plate.x, 2.0, std::max(2.0, stage.width - width - 2.0));
      plate.y = std::clamp(plate.y, stage.bottom + 2.0, std::max(stage.bottom + 2.0, stage.bottom + stage.height - height - 2.0));
      double cost = 0.01 * gap * width * height;
      for (const Overlay::Disc& robot : robots) cost += plate.on(robot);
      for (const Plate& other : taken) cost += 4.0 * plate.on(other);
      if (cost >= least) continue;
      least = cost;
      best = plate;
    }
  }
  return best;
}

/// Names next to their robots, with a line to those that are farther away.
void write_names(const Overlay& overlay, const Picture& picture, const mjrRect& stage, std::span<const Overlay::Disc> robots) {
  const double line = overlay.line_height(picture.is_small);
  std::vector<Plate> taken;
  if (picture.is_small && !picture.caption.empty()) taken.push_back({0.0, 0.0, overlay.width(), 1.8 * line});
  for (const Name& name : picture.names) {
    const Overlay::Disc& own = robots[name.robot];
    if (!(own.radius > 0.0)) continue;  // behind the camera
    const Colour& colour = picture.robots[name.robot].colour;
    const double width = overlay.width_of(name.text, picture.is_small) + 0.5 * line;
    const Plate plate = place_of_name(own, width, 1.1 * line, stage, robots, taken);
    const double x = std::clamp(own.x, plate.x, plate.x + plate.width);
    const double y = std::clamp(own.y, plate.y, plate.y + plate.height);
    const double away = std::hypot(x - own.x, y - own.y);
    if (away > own.radius + line) {
      const double edge = own.radius / away;
      overlay.line(std::lerp(own.x, x, edge), std::lerp(own.y, y, edge), x, y, std::max(1.0, 0.1 * line), colour);
    }
    write_plate(overlay, plate.x + 0.25 * line, plate.y + 0.2 * line, name.text, colour, picture.is_small);
    taken.push_back(plate);
  }
}

}  // namespace

void Overlay::text(double x, double y, const std::string& text, const Colour& colour, bool is_large) const {
  // mjr_text would place it in the rectangle that was drawn last.
  const mjrRect place{static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y - 0.25 * line_height(is_large))),
                      static_cast<int>(std::ceil(width_of(text, is_large))),
                      static_cast<int>(std::lround(1.25 * line_height(is_large)))};
  mjr_label(place, is_large ? mjFONT_BIG : mjFONT_NORMAL, text.c_str(), 0.0F, 0.0F, 0.0F, 0.0F, colour[0], colour[1], colour[2],
            &context_);
}

void Overlay::bar(double x, double y, double width, double height, const Colour& colour, float opacity) const {
  const mjrRect place{static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y)),
                      std::max(1, static_cast<int>(std::lround(width))), std::max(1, static_cast<int>(std::lround(height)))};
  mjr_rectangle(place, colour[0], colour[1], colour[2], opacity);
}

void Overlay::disc(double x, double y, double radius, const Colour& colour) const {
  ring(x, y, radius, radius, colour);
}

void Overlay::ring(double x, double y, double radius, double thickness, const Colour& colour) const {
  const auto half_chord = [](double r, double dy) { return r > std::abs(dy) ? std::sqrt(r * r - dy * dy) : 0.0; };
  for (double dy = -std::floor(radius); dy <= radius; dy += 1.0) {
    const double outer = half_chord(radius, dy);
    const double inner = half_chord(radius - thickness, dy);
    if (outer <= 0.0) continue;
    if (inner <= 0.0) {
      bar(x - outer, y + dy, 2.0 * outer, 1.0, colour);
      continue;
    }
    bar(x - outer, y + dy, outer - inner, 1.0, colour);
    bar(x + inner, y + dy, outer - inner, 1.0, colour);
  }
}

void Overlay::line(double x0, double y0, double x1, double y1, double thickness, const Colour& colour) const {
  const double steps = std::max(1.0, std::ceil(std::max(std::abs(x1 - x0), std::abs(y1 - y0))));
  for (double i = 0.0; i <= steps; i += 1.0) {
    const double x = std::lerp(x0, x1, i / steps);
    const double y = std::lerp(y0, y1, i / steps);
    bar(x - 0.5 * thickness, y - 0.5 * thickness, thickness, thickness, colour);
  }
}

double Overlay::width_of(const std::string& text, bool is_large) const {
  const auto& widths = is_large ? context_.charWidthBig : context_.charWidth;
  return std::accumulate(text.begin(), text.end(), 0.0, [&](double sum, char c) {
    const auto code = static_cast<unsigned char>(c);
    return sum + widths[code < 127 ? code : 0];
  });
}

mjrRect stage_of(const Overlay& overlay, const Picture& picture) {
  const double line = overlay.line_height();
  const bool has_head = !picture.title.empty() || !picture.legend.empty();
  const double top = has_head ? draw_head(overlay, picture, false) + 0.3 * line : overlay.height();
  const double bottom = picture.has_scale ? 1.6 * line : 0.0;
  return {0, static_cast<int>(bottom), static_cast<int>(overlay.width()), static_cast<int>(top) - static_cast<int>(bottom)};
}

void write_over(const Overlay& overlay, const Picture& picture, const Camera& camera, std::span<const Overlay::Disc> robots) {
  const mjrRect stage = stage_of(overlay, picture);
  write_names(overlay, picture, stage, robots);
  if (stage.bottom > 0) overlay.bar(0.0, 0.0, overlay.width(), stage.bottom, paper);
  const double top = stage.bottom + stage.height;
  if (top < overlay.height()) overlay.bar(0.0, top, overlay.width(), overlay.height() - top, paper);
  static_cast<void>(draw_head(overlay, picture, true));
  if (picture.has_scale) draw_scale(overlay, camera, stage);
  if (!picture.curves.empty()) draw_curves(overlay, picture, stage);
  if (picture.caption.empty()) return;
  const double line = overlay.line_height();
  if (picture.is_small) return write_plate(overlay, 0.5 * line, 0.5 * line, picture.caption, ink, true);
  overlay.text(0.6 * line, 0.35 * line, picture.caption, ink);
}

}  // namespace trophic::film
