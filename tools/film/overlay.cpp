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
      return overlay.ring(x, y, radius, thin, entry.colour);
    case Mark::catch_:
      overlay.ring(x, y, radius, thin, entry.colour);
      overlay.line(x - 0.6 * radius, y - 0.6 * radius, x + 0.6 * radius, y + 0.6 * radius, thin, entry.colour);
      return overlay.line(x - 0.6 * radius, y + 0.6 * radius, x + 0.6 * radius, y - 0.6 * radius, thin, entry.colour);
    case Mark::death:
      return overlay.ring(x, y, radius, 1.0, entry.colour);
    case Mark::marked:
      overlay.disc(x, y, 0.5 * radius, mixed(paper, entry.colour, 0.45F));
      return overlay.ring(x, y, radius, thin, entry.colour);
    case Mark::trail:
      return overlay.bar(x - radius, y - 0.5 * thin, 2.0 * radius, thin, mixed(paper, entry.colour, 0.7F));
    case Mark::sight:
      return overlay.bar(x - radius, y - 0.5, 2.0 * radius, 1.0, mixed(paper, entry.colour, 0.45F));
  }
}

/// In one row below `top`, or in several if it is too long.
void draw_legend(const Overlay& overlay, const std::vector<LegendEntry>& legend, double top) {
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

/// The cross of a catch, which lies on the floor and is seen through the body there.
void draw_cross(const Overlay& overlay, const Flash& flash, const Camera& camera) {
  const double reach = 0.64 * flash.radius_m;
  const double thickness = std::max(2.0, 0.07 * flash.radius_m * overlay.height() / (half_height() * camera.distance_m));
  for (const double side : {-1.0, 1.0}) {
    const auto from = seen_at(camera, {flash.x_m - reach, flash.y_m - side * reach, 0.0});
    const auto to = seen_at(camera, {flash.x_m + reach, flash.y_m + side * reach, 0.0});
    if (!from || !to) continue;
    const auto x = [&](const PicturePoint& point) { return 0.5 * (overlay.width() + point.x * overlay.height()); };
    const auto y = [&](const PicturePoint& point) { return 0.5 * (1.0 + point.y) * overlay.height(); };
    if (std::max(std::abs(from->y), std::abs(to->y)) > 2.0) continue;
    overlay.line(x(*from), y(*from), x(*to), y(*to), thickness, catch_colour);
  }
}

}  // namespace

void Overlay::text(double x, double y, const std::string& text, const Colour& colour) const {
  // mjr_text would place it in the rectangle that was drawn last.
  const mjrRect place{static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y - 0.25 * line_height())),
                      static_cast<int>(std::ceil(width_of(text))), static_cast<int>(std::lround(1.25 * line_height()))};
  mjr_label(place, mjFONT_NORMAL, text.c_str(), 0.0F, 0.0F, 0.0F, 0.0F, colour[0], colour[1], colour[2], &context_);
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

double Overlay::width_of(const std::string& text) const {
  return std::accumulate(text.begin(), text.end(), 0.0, [&](double sum, char c) {
    const auto code = static_cast<unsigned char>(c);
    return sum + (code < 127 ? context_.charWidth[code] : context_.charWidth[0]);
  });
}

void write_over(const Overlay& overlay, const Picture& picture, const Camera& camera) {
  const double line = overlay.line_height();
  for (const Flash& flash : picture.flashes) {
    if (flash.is_catch) draw_cross(overlay, flash, camera);
  }
  for (const Name& name : picture.names) {
    const auto point = seen_at(camera, name.at_m);
    if (!point) continue;
    const double x = 0.5 * (overlay.width() + point->x * overlay.height()) + 0.8 * line;
    const double y = 0.5 * (1.0 + point->y) * overlay.height() + 1.1 * line;
    overlay.bar(x - 0.25 * line, y - 0.25 * line, overlay.width_of(name.text) + 0.5 * line, 1.15 * line, ink);
    overlay.text(x, y, name.text, paper);
  }
  double top = overlay.height() - 0.3 * line;
  if (!picture.title.empty()) {
    overlay.text(0.6 * line, top - 0.82 * line, picture.title, ink);
    top -= 1.25 * line;
  }
  draw_legend(overlay, picture.legend, top);
  if (picture.has_scale) draw_scale(overlay, camera);
  if (!picture.caption.empty()) overlay.text(0.012 * overlay.width(), 0.018 * overlay.height(), picture.caption, ink);
}

}  // namespace trophic::film
