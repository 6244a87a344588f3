// SPDX-License-Identifier: MIT
// Draws pictures with MuJoCo's renderer in the current OpenGL context: without a screen (renderer.hpp) or in a window.
#pragma once

#include <memory>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/pictures/drawing/camera.hpp>
#include <trophic/pictures/drawing/image.hpp>
#include <trophic/pictures/drawing/picture.hpp>

namespace trophic::drawing {

/// Target of a drawing: a buffer of a fixed size, whose pixels can be read, or the window of the current context.
enum class Canvas { buffer, window };

/// Place of a text in a picture.
enum class Corner { top_left, top_right, bottom_left };

/// Must not outlive the OpenGL context that was current when it was made, and is used while that is current.
class Drawing {
 public:
  /// Throws std::runtime_error if OpenGL cannot draw onto such a canvas. `width` and `height`: pixels of a buffer, unused for
  /// a window. `large_text`: letters twice as large.
  Drawing(const RobotModel& robot, const Arena& arena, Canvas canvas, std::size_t width, std::size_t height, bool large_text);
  Drawing(Drawing&&) noexcept;
  Drawing& operator=(Drawing&&) noexcept;
  ~Drawing();

  /// Throws std::runtime_error for more objects than fit into one picture. `width` and `height`: of the buffer, or of the
  /// window now.
  void draw(const Picture& picture, const Camera& camera, std::size_t width, std::size_t height);

  /// Writes text over the last drawing: two columns, lines separated by \n; the second may be empty.
  void write(Corner corner, const std::string& left, const std::string& right);

  /// The last drawing.
  [[nodiscard]] Image read() const;

 private:
  class Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace trophic::drawing
