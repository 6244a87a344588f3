// SPDX-License-Identifier: MIT
// Definitions of renderer.hpp.
#include <stdexcept>
#include <string>
#include <trophic/pictures/drawing/drawing.hpp>
#include <trophic/pictures/film/renderer.hpp>

#include "offscreen.hpp"

namespace trophic::film {

namespace {

std::size_t checked(const char* name, std::size_t size) {
  if (size % 2 == 0 && size >= 16 && size <= 4096) return size;
  throw std::invalid_argument{std::string{name} + " = " + std::to_string(size) + ": must be even, >= 16 and <= 4096"};
}

}  // namespace

struct Renderer::Parts {
  std::size_t scale;
  std::size_t width;
  std::size_t height;
  Offscreen offscreen;
  drawing::Drawing canvas;

  Parts(const RobotModel& robot, const Arena& arena, std::size_t wide, std::size_t high, Quality quality)
      : scale{quality == Quality::fine ? 2U : 1U},
        width{scale * checked("width", wide)},
        height{scale * checked("height", high)},
        offscreen{},
        canvas{robot, arena, drawing::Canvas::buffer, width, height, scale == 2} {}
};

Renderer::Renderer(const RobotModel& robot, const Arena& arena, std::size_t width, std::size_t height, Quality quality)
    : parts_{std::make_unique<Parts>(robot, arena, width, height, quality)} {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Image Renderer::draw(const drawing::Picture& picture, const drawing::Camera& camera) {
  parts_->canvas.draw(picture, camera, parts_->width, parts_->height);
  Image image = parts_->canvas.read();
  return parts_->scale == 2 ? halved(image) : image;
}

}  // namespace trophic::film
