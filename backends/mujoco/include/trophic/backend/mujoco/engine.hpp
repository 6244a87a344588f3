// SPDX-License-Identifier: MIT
// Owners of MuJoCo's objects; its errors and warnings as C++ exceptions instead of exit() and a log file.
#pragma once

#include <mujoco/mujoco.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

namespace trophic::backend::mujoco {

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using ModelPtr = std::unique_ptr<mjModel, DeleteModel>;
using DataPtr = std::unique_ptr<mjData, DeleteData>;

/// An error that MuJoCo reported through mju_error.
struct EngineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// During its lifetime on a thread, mju_error on that thread throws EngineError instead of ending the process, and mju_warning is
/// silent: warnings are read from mjData. On other threads MuJoCo's own handler, or an earlier one, stays active. The mjData of
/// an interrupted call must be reset or destroyed.
class EngineGuard {
 public:
  EngineGuard() {
    static const bool installed = install();
    static_cast<void>(installed);
    ++depth();
  }
  ~EngineGuard() { --depth(); }
  EngineGuard(const EngineGuard&) = delete;
  EngineGuard& operator=(const EngineGuard&) = delete;

 private:
  using Handler = void (*)(const char*);

  static int& depth() {
    static thread_local int value = 0;
    return value;
  }
  static Handler& earlier_error() {
    static Handler handler = nullptr;
    return handler;
  }
  static Handler& earlier_warning() {
    static Handler handler = nullptr;
    return handler;
  }

  static bool install() {
    earlier_error() = mju_user_error;
    earlier_warning() = mju_user_warning;
    mju_user_error = on_error;
    mju_user_warning = on_warning;
    return true;
  }

  static void on_error(const char* text) {
    if (depth() > 0) throw EngineError{std::string{"MuJoCo: "} + text};
    if (earlier_error() != nullptr) return earlier_error()(text);
    std::fprintf(stderr, "MuJoCo error: %s\n", text);
    std::exit(EXIT_FAILURE);
  }

  static void on_warning(const char* text) {
    if (depth() > 0) return;
    if (earlier_warning() != nullptr) return earlier_warning()(text);
    std::fprintf(stderr, "MuJoCo warning: %s\n", text);
  }
};

}  // namespace trophic::backend::mujoco
