// SPDX-License-Identifier: MIT
// Definitions of overlay.hpp.
#include <tools/film/overlay.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
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
      return overlay.bar(x - radius, y - 0.5, 2.0 * radius, 1.0, mixed(paper, entry.colour, 0.45F));
  }
}

/// In one row below `top`, or in several if it is too long. Returns where it ends.
double draw_legend(const Overlay& overlay, const std::vector<LegendEntry>& legend, double top) {
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
    draw_mark(overlay, entry, x + radius, y - 0.5 * line, radius);
    overlay.text(x + 2.8 * radius, y - 0.82 * line, entry.text, ink);
    x += width;
  }
  return y - 1.15 * line;
}

/// A bar of 1, 2, 5, ... metres, about a tenth of the picture long at what the camera looks at.
void draw_scale(const Overlay& overlay, const Camera& camera) {
  const double metre = overlay.height() / (2.0 * half_height() * camera.distance_m);
  const double wished = 0.12 * overlay.width() / metre;
  const double power = std::pow(10.0, std::floor(std::log10(wished)));
  const double metres = (wished >= 5.0 * power ? 5.0 : wished >= 2.0 * power ? 2.0 : 1.0) * power;
  const double line = overlay.line_height();
  const double right = overlay.width() - 0.8 * line;
  const double left = right - metres * metre;
  const double y = 0.7 * line;
  const double thin = std::max(1.0, 0.1 * line);
  overlay.bar(left, y, right - left, thin, ink);
  for (const double end : {left, right - thin}) overlay.bar(end, y - 0.2 * line, thin, 0.4 * line + thin, ink);
  const std::string text = number_text(metres) + " m";
  overlay.text(0.5 * (left + right - overlay.width_of(text)), y + 0.3 * line, text, ink);
}

/// Above the scale.
void draw_curves(const Overlay& overlay, const Picture& picture) {
  const double line = overlay.line_height();
  const double width = 0.24 * overlay.width();
  const double one = 0.14 * overlay.height() / picture.most;  // height of one individual
  const double left = overlay.width() - width - 0.8 * line;
  const double bottom = 2.6 * line;
  overlay.bar(left, bottom, width, picture.most * one, paper);
  overlay.bar(left, bottom, width, 1.0, ink);
  for (const Curve& curve : picture.curves) {
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      const auto& [x0, y0] = curve.points[i - 1];
      const auto& [x1, y1] = curve.points[i];
      overlay.line(left + x0 * width, bottom + y0 * one, left + x1 * width, bottom + y1 * one, 2.0, curve.colour);
    }
  }
  overlay.text(left + 0.3 * line, bottom + picture.most * one - 0.9 * line, number_text(picture.most), ink);
}

/// Text on a plate.
void write_plate(const Overlay& overlay, double x, double y, const std::string& text, const Colour& colour, bool is_large) {
  const double line = overlay.line_height(is_large);
  overlay.bar(x - 0.25 * line, y - 0.2 * line, overlay.width_of(text, is_large) + 0.5 * line, 1.1 * line, colour);
  overlay.text(x, y, text, paper, is_large);
}

/// Next to its robot, below `top`, and to the right of the caption instead of under it.
void write_name(const Overlay& overlay, const Name& name, const Camera& camera, double top, const Picture& picture) {
  const auto point = seen_at(camera, name.at_m);
  if (!point) return;
  const double line = overlay.line_height(picture.is_small);
  const Sight sight{camera};
  const double depth_m = (name.at_m - sight.eye_m).dot(sight.forward);
  const double radius = 1.2 * name.radius_m * 0.5 * overlay.height() / (half_height() * depth_m);
  const double width = overlay.width_of(name.text, picture.is_small);
  const double x = 0.5 * (overlay.width() + point->x * overlay.height() - width);
  const double y = 0.5 * (1.0 + point->y) * overlay.height() + (name.is_below ? -radius - 1.1 * line : radius + 0.4 * line);
  const bool is_beside_caption = !picture.caption.empty() && y < 0.018 * overlay.height() + 1.5 * line;
  const double left = 0.4 * line + (is_beside_caption ? overlay.width_of(picture.caption, picture.is_small) + 1.2 * line : 0.0);
  write_plate(overlay, std::clamp(x, left, std::max(left, overlay.width() - width - 0.4 * line)), std::min(y, top - 1.2 * line),
              name.text, name.colour, picture.is_small);
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

void write_over(const Overlay& overlay, const Picture& picture, const Camera& camera) {
  const double line = overlay.line_height();
  double top = overlay.height() - 0.3 * line;
  if (!picture.title.empty()) {
    overlay.text(0.6 * line, top - 0.82 * line, picture.title, ink);
    top -= 1.25 * line;
  }
  if (!picture.legend.empty()) top = draw_legend(overlay, picture.legend, top);
  for (const Name& name : picture.names) write_name(overlay, name, camera, top, picture);
  if (picture.has_scale) draw_scale(overlay, camera);
  if (!picture.curves.empty()) draw_curves(overlay, picture);
  if (picture.caption.empty()) return;
  if (picture.is_small) return write_plate(overlay, 0.5 * line, 0.5 * line, picture.caption, ink, true);
  overlay.text(0.012 * overlay.width(), 0.018 * overlay.height(), picture.caption, ink);
}

}  // namespace trophic::film
