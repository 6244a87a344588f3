// SPDX-License-Identifier: MIT
// Draws pictures without a screen.
#pragma once

#include <memory>
#include <tools/film/camera.hpp>
#include <tools/film/image.hpp>
#include <tools/film/picture.hpp>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/robot_model.hpp>

namespace trophic::film {

/// Quality of a picture.
enum class Quality {
  fast,  ///< each pixel drawn once
  fine   ///< drawn twice as large and scaled down: smooth edges
};

/// One at a time in a thread.
class Renderer {
 public:
  /// A renderer of pictures of `width` times `height` pixels, both even, 16 to 4096. Throws std::invalid_argument for another
  /// size and std::runtime_error without OpenGL.
  Renderer(const RobotModel& robot, const Arena& arena, std::size_t width, std::size_t height, Quality quality);
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  /// Width over height of the part in which a picture's world is drawn: its title, legend, caption and scale are above and below
  /// it.
  [[nodiscard]] double aspect(const Picture& picture) const;

  [[nodiscard]] Image draw(const Picture& picture, const Camera& camera);

 private:
  class Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace trophic::film
