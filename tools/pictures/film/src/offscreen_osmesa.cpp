// SPDX-License-Identifier: MIT
// Offscreen by OSMesa, which needs no graphics card either.
#include <GL/osmesa.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "offscreen.hpp"

namespace trophic::film {

struct Offscreen::Context {
  static constexpr int side = 16;  // pictures are drawn into a buffer of MuJoCo's own
  OSMesaContext context = OSMesaCreateContextExt(GL_RGBA, 24, 8, 0, nullptr);
  std::vector<std::uint8_t> buffer = std::vector<std::uint8_t>(4 * side * side);
};

Offscreen::Offscreen() : context_{std::make_unique<Context>()} {
  Context& own = *context_;
  if (own.context == nullptr ||
      OSMesaMakeCurrent(own.context, own.buffer.data(), GL_UNSIGNED_BYTE, Context::side, Context::side) == 0) {
    throw std::runtime_error{"OSMesa gives no OpenGL to draw with"};
  }
}

Offscreen::~Offscreen() {
  OSMesaDestroyContext(context_->context);
}

}  // namespace trophic::film
