// SPDX-License-Identifier: MIT
// Text over a picture: names, caption, title, legend, scale.
#pragma once

#include <mujoco/mujoco.h>

#include <span>
#include <string>
#include <tools/film/camera.hpp>
#include <tools/film/picture.hpp>

namespace trophic::film {

/// Texts and flat marks over what MuJoCo drew last; places are pixels from the lower left corner.
class Overlay {
 public:
  /// A place and its surroundings.
  struct Disc {
    double x = 0.0;
    double y = 0.0;
    double radius = 0.0;
  };

  Overlay(const mjrContext& context, const mjrRect& view) : context_{context}, view_{view} {}

  void text(double x, double y, const std::string& text, const Colour& colour, bool is_large = false) const;
  void bar(double x, double y, double width, double height, const Colour& colour, float opacity = 1.0F) const;
  void disc(double x, double y, double radius, const Colour& colour) const;
  void ring(double x, double y, double radius, double thickness, const Colour& colour) const;
  void line(double x0, double y0, double x1, double y1, double thickness, const Colour& colour) const;

  [[nodiscard]] double width_of(const std::string& text, bool is_large = false) const;
  [[nodiscard]] double line_height(bool is_large = false) const {
    return is_large ? context_.charHeightBig : context_.charHeight;
  }
  [[nodiscard]] double width() const { return view_.width; }
  [[nodiscard]] double height() const { return view_.height; }

 private:
  const mjrContext& context_;
  mjrRect view_;
};

/// The part of a picture in which the world is drawn: between title and legend above it and caption and scale below it.
[[nodiscard]] mjrRect stage_of(const Overlay& overlay, const Picture& picture);

/// Writes what a picture says in words. `robots`: where they are.
void write_over(const Overlay& overlay, const Picture& picture, const Camera& camera, std::span<const Overlay::Disc> robots);

}  // namespace trophic::film
