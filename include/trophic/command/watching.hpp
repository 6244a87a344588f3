// SPDX-License-Identifier: MIT
// `--watch`: a run in a window while it goes on, in programs that are linked with trophic::watch.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <trophic/ecology/simulation.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/observe/stop_on_signal.hpp>
#include <trophic/run/checkpoint/resume.hpp>
// Who links trophic::watch has this definition.
#ifdef TROPHIC_WITH_WATCH
#include <trophic/pictures/watch/session.hpp>
#endif

namespace trophic::command {

/// A window that a run can be seen in.
class Window {
 public:
  Window() = default;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  virtual ~Window() = default;

  /// Calls `simulate` while the window shows what it is told, and returns what that returns.
  [[nodiscard]] virtual int show(const std::function<int()>& simulate) = 0;
  /// As checkpoint::run_with_checkpoints, and the window is told.
  virtual void run_with_checkpoints(Simulation& ecology, double until_s, const std::filesystem::path& folder,
                                    const checkpoint::Schedule& schedule, const std::optional<checkpoint::Checkpoint>& from,
                                    io::RunFolder& files, observe::Progress& progress, const observe::StopOnSignal& stop) = 0;
};

/// Opens a window with a title. Throws std::invalid_argument, saying what is missing, where none can be opened.
using OpenWindow = std::unique_ptr<Window> (*)(const std::string& title);

#ifdef TROPHIC_WITH_WATCH
[[nodiscard]] inline std::unique_ptr<Window> open_window(const std::string& title) {
  class Watched final : public Window {
   public:
    explicit Watched(const std::string& name) : session_{name} {}
    [[nodiscard]] int show(const std::function<int()>& simulate) override { return session_.show(simulate); }
    void run_with_checkpoints(Simulation& ecology, double until_s, const std::filesystem::path& folder,
                              const checkpoint::Schedule& schedule, const std::optional<checkpoint::Checkpoint>& from,
                              io::RunFolder& files, observe::Progress& progress, const observe::StopOnSignal& stop) override {
      checkpoint::run_with_checkpoints(ecology, until_s, folder, schedule, from, files, progress, stop, session_.spectator());
    }

   private:
    watch::Session session_;
  };
  return std::make_unique<Watched>(title);
}
#endif

}  // namespace trophic::command
