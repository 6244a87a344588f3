// SPDX-License-Identifier: MIT
// Definitions of offscreen.hpp.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <tools/film/offscreen.hpp>

namespace trophic::film {

struct Offscreen::Context {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLSurface surface = EGL_NO_SURFACE;
  EGLContext context = EGL_NO_CONTEXT;

  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    if (surface != EGL_NO_SURFACE) eglDestroySurface(display, surface);
  }

  /// Returns whether a context was made and is current.
  [[nodiscard]] bool open() {
    ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);  // Mesa would complain on standard error of a home that is not writable
    display = display_without_screen();
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) return false;
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return false;
    constexpr std::array<EGLint, 13> wanted{EGL_SURFACE_TYPE,
                                            EGL_PBUFFER_BIT,
                                            EGL_RENDERABLE_TYPE,
                                            EGL_OPENGL_BIT,
                                            EGL_RED_SIZE,
                                            8,
                                            EGL_GREEN_SIZE,
                                            8,
                                            EGL_BLUE_SIZE,
                                            8,
                                            EGL_DEPTH_SIZE,
                                            24,
                                            EGL_NONE};
    // Pictures are drawn into a buffer of MuJoCo's own.
    constexpr std::array<EGLint, 5> size{EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (eglChooseConfig(display, wanted.data(), &config, 1, &found) != EGL_TRUE || found == 0) return false;
    surface = eglCreatePbufferSurface(display, config, size.data());
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    return context != EGL_NO_CONTEXT && eglMakeCurrent(display, surface, surface, context) == EGL_TRUE;
  }

 private:
  [[nodiscard]] static EGLDisplay display_without_screen() {
    const char* const extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (extensions != nullptr && std::string_view{extensions}.find("EGL_MESA_platform_surfaceless") != std::string_view::npos) {
      return eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    }
    return eglGetDisplay(EGL_DEFAULT_DISPLAY);
  }
};

Offscreen::Offscreen() : context_{std::make_unique<Context>()} {
  if (!context_->open()) throw std::runtime_error{"EGL gives no OpenGL to draw with"};
}

Offscreen::~Offscreen() = default;

}  // namespace trophic::film
