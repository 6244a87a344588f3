// SPDX-License-Identifier: MIT
// Writes checkpoints of a run, and resumes a run from one.
#pragma once

#include <filesystem>
#include <trophic/ecology/simulation.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/run/checkpoint/checkpoint_file.hpp>
#include <trophic/run/checkpoint/schedule.hpp>

namespace trophic::checkpoint {

/// An observer that takes part in checkpoints: its state and the lengths of the files to which it appends go into a
/// section of this name. Archives write and read: see trophic/params/archive.hpp and, for files,
/// trophic/io/growing_file.hpp.
template <class O>
concept Checkpointed = Persists<O> && requires {
  { O::section } -> std::convertible_to<std::string_view>;
};

/// The parts of the participating observers, in order.
template <class... Observers>
[[nodiscard]] Parts parts_of(Observers&... observers) {
  Parts parts;
  [[maybe_unused]] const auto add = [&]<class O>(O& observer) {
    if constexpr (Checkpointed<O>) parts.push_back({O::section, [&observer](Archive& archive) { archive(observer); }});
  };
  (add(observers), ...);
  return parts;
}

/// The section of the ecology itself.
inline constexpr std::string_view ecology_section = "ecology";

/// Writes the present moment of an ecology and its participating observers into a folder, between two ticks.
void write(const std::filesystem::path& folder, Simulation& ecology, const observe::RunDescription& run, const Parts& parts = {});

/// Throws std::invalid_argument naming the difference if a checkpoint is from a different run or a different program's code.
void check_same_run(const Checkpoint& checkpoint, const observe::RunDescription& run);

/// Starts an ecology with different rules or a different seed from a checkpoint. Throws std::invalid_argument if its robots or
/// states of rules differ, and otherwise as `restore`.
void restore_any(const Checkpoint& checkpoint, Simulation& ecology, const Parts& parts = {});

/// Restores an ecology that was made from the same parameters, and its participating observers, from a checkpoint.
/// Files are truncated to their length at that moment. Throws std::invalid_argument if the checkpoint is from a different run or
/// different observers; std::runtime_error for a file that is missing or shorter than it was.
void restore(const Checkpoint& checkpoint, Simulation& ecology, const Parts& parts = {});

/// An observer that writes checkpoints of the run and of its participating observers into a folder, as often as its schedule
/// demands and when the run ends or is interrupted. In each tick the others must be called before this one.
class CheckpointWriter {
 public:
  CheckpointWriter(std::filesystem::path folder, Schedule schedule, Parts parts)
      : folder_{std::move(folder)}, schedule_{schedule}, parts_{std::move(parts)} {}

  void on_start(const observe::RunDescription& run, const View& view) {
    run_ = run;
    last_s_ = view.time_s;
  }
  void between_ticks(Simulation& ecology, bool last) {
    if (!last && !due(ecology.time_s())) return;
    const double before_s = watch_.elapsed_s();
    write(folder_, ecology, run_, parts_);
    std::error_code ignored;
    if (last && (ecology.time_s() >= run_.until_s || ecology.view().is_over))
      std::filesystem::remove(folder_ / predecessor_name, ignored);
    written_s_ = watch_.elapsed_s();
    cost_s_ = written_s_ - before_s;
    last_s_ = ecology.time_s();
  }

 private:
  [[nodiscard]] bool due(double time_s) const {
    if (!(schedule_.every_s > 0.0) || time_s - last_s_ < schedule_.every_s) return false;
    return cost_s_ <= schedule_.most_share * (watch_.elapsed_s() - written_s_);
  }

  std::filesystem::path folder_;
  Schedule schedule_;
  Parts parts_;
  observe::RunDescription run_;
  observe::Stopwatch watch_;  ///< decides when checkpoints are written, never changes a result
  double last_s_ = 0.0;
  double written_s_ = 0.0;
  double cost_s_ = 0.0;
};

}  // namespace trophic::checkpoint

#if TROPHIC_HEADER_ONLY
#include <trophic/run/checkpoint/checkpoint_writer.ipp>
#endif
