// SPDX-License-Identifier: MIT
// `--watch`: a live view of a run, in programs that are linked with trophic::watch.
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
// Linking trophic::watch defines this.
#ifdef TROPHIC_WITH_WATCH
#include <trophic/pictures/watch/session.hpp>
#endif

namespace trophic::command {

/// A window that shows a run.
class Window {
 public:
  Window() = default;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  virtual ~Window() = default;

  /// Calls `simulate` while the window shows the run, and returns its result.
  [[nodiscard]] virtual int show(const std::function<int()>& simulate) = 0;
  /// As checkpoint::run_with_checkpoints, with the window as an observer.
  virtual void run_with_checkpoints(Simulation& ecology, double until_s, const std::filesystem::path& folder,
                                    const checkpoint::Schedule& schedule, const std::optional<checkpoint::Checkpoint>& from,
                                    io::RunFolder& files, observe::Progress& progress, const observe::StopOnSignal& stop) = 0;
};

/// Opens a window with a title. Throws std::invalid_argument, naming what is missing, if none can be opened.
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
