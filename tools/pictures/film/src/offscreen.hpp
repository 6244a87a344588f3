// SPDX-License-Identifier: MIT
// An OpenGL context without a screen, current in the thread that made it. One of offscreen_osmesa.cpp and offscreen_egl.cpp is
// linked.
#pragma once

#include <memory>

namespace trophic::film {

class Offscreen {
 public:
  /// Throws std::runtime_error if the system has no OpenGL that draws without a screen.
  Offscreen();
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;
  ~Offscreen();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace trophic::film
