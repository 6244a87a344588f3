// SPDX-License-Identifier: MIT
// Start-up of ODE and owners of its objects; its errors and warnings as C++ exceptions instead of abort() and exit().
#pragma once

#include <ode/ode.h>

#include <array>
#include <cstdarg>
#include <cstdio>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

namespace trophic::backend::ode {

static_assert(sizeof(dReal) == sizeof(double), "trophic's ODE backend needs ODE built for double precision (dDOUBLE)");

/// An error that ODE reported through dError, dDebug (a failed assertion) or dMessage.
struct EngineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Must live on every thread that calls ODE. Starts the library with its first object in the process (it is never closed: other
/// code in the process may use it) and gives each thread its collision buffers. While one lives on a thread, ODE's errors,
/// failed assertions and messages on that thread throw EngineError instead of ending the process or printing; on other threads
/// ODE's own handlers, or earlier ones, stay active. The world of an interrupted call must be discarded.
class EngineGuard {
 public:
  EngineGuard() {
    static const Handlers& handlers = earlier();
    static_cast<void>(handlers);
    static thread_local const bool ready = dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll)) != 0;
    if (!ready) throw EngineError{"ODE: cannot allocate its data for a thread, such as collision buffers"};
    ++depth();
  }
  ~EngineGuard() { --depth(); }
  EngineGuard(const EngineGuard&) = delete;
  EngineGuard& operator=(const EngineGuard&) = delete;

 private:
  struct Handlers {
    dMessageFunction* error = nullptr;
    dMessageFunction* debug = nullptr;
    dMessageFunction* message = nullptr;
  };

  static int& depth() {
    static thread_local int value = 0;
    return value;
  }

  /// The handlers that were set earlier; the first call starts ODE and sets the library's own.
  static const Handlers& earlier() {
    static const Handlers handlers = [] {
      if (dInitODE2(0) == 0) throw EngineError{"ODE: cannot initialise the library"};
      const Handlers before{.error = dGetErrorHandler(), .debug = dGetDebugHandler(), .message = dGetMessageHandler()};
      dSetErrorHandler(on_error);
      dSetDebugHandler(on_debug);
      dSetMessageHandler(on_message);
      return before;
    }();
    return handlers;
  }

  static void report(dMessageFunction* before, int number, const char* format, va_list arguments) {
    if (depth() == 0 && before != nullptr) return before(number, format, arguments);
    std::array<char, 512> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    if (depth() > 0) throw EngineError{std::string{"ODE: "} + text.data()};
    std::fprintf(stderr, "ODE %d: %s\n", number, text.data());
  }
  static void on_error(int number, const char* format, va_list arguments) { report(earlier().error, number, format, arguments); }
  static void on_debug(int number, const char* format, va_list arguments) { report(earlier().debug, number, format, arguments); }
  static void on_message(int number, const char* format, va_list arguments) {
    report(earlier().message, number, format, arguments);
  }
};

struct DeleteWorld {
  void operator()(dWorldID world) const { dWorldDestroy(world); }
};
struct DeleteThreading {
  void operator()(dThreadingImplementationID threading) const { dThreadingFreeImplementation(threading); }
};
struct DeleteGroup {
  void operator()(dJointGroupID group) const { dJointGroupDestroy(group); }
};
struct DeleteGeom {
  void operator()(dGeomID geom) const { dGeomDestroy(geom); }
};
struct DeleteHeights {
  void operator()(dHeightfieldDataID heights) const { dGeomHeightfieldDataDestroy(heights); }
};
using WorldPtr = std::unique_ptr<dxWorld, DeleteWorld>;
using ThreadingPtr = std::unique_ptr<dxThreadingImplementation, DeleteThreading>;
using GroupPtr = std::unique_ptr<dxJointGroup, DeleteGroup>;
using GeomPtr = std::unique_ptr<dxGeom, DeleteGeom>;
using HeightsPtr = std::unique_ptr<dxHeightfieldData, DeleteHeights>;

/// ODE has one random sequence per process: code that sets or draws from it holds this mutex.
[[nodiscard]] inline std::mutex& random_sequence_mutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace trophic::backend::ode
