// SPDX-License-Identifier: MIT
// An OpenGL context without a screen, current in the thread that made it: by EGL, on Mesa its platform without surfaces, which
// needs no screen, server or graphics card; else the default display.
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
