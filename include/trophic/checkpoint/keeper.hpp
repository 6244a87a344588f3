// SPDX-License-Identifier: MIT
// Keeps checkpoints of a run, and lets a run go on from one.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/checkpoint/checkpoint_file.hpp>
#include <trophic/checkpoint/schedule.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/params/archive.hpp>
#include <trophic/population/view.hpp>
#include <trophic/support/version.hpp>
#include <tuple>
#include <type_traits>
#include <utility>

namespace trophic::checkpoint {

/// An observer that takes part in checkpoints: what it remembers and the lengths of the files that it appends to go into a
/// section of its own, of this name. Archives write and read: see trophic/params/archive.hpp and, for files,
/// trophic/observe/growing_file.hpp.
template <class O>
concept Kept = Persists<O> && requires {
  { O::section } -> std::convertible_to<std::string_view>;
};

/// The section of the ecology itself.
inline constexpr std::string_view ecology_section = "ecology";

namespace detail {

template <class T>
[[nodiscard]] Section section_of(std::string_view name, T& object) {
  Archive archive;
  archive(object);
  return {std::string{name}, archive.bytes()};
}

template <class T>
void read_section(const Checkpoint& from, std::string_view name, T& object) {
  const std::string& bytes = from.section(name);
  try {
    Archive archive{bytes};
    archive(object);
    archive.finish();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument{"section \"" + std::string{name} + "\" of the checkpoint: " + error.what()};
  }
}

}  // namespace detail

/// The moment at which an ecology and those of its observers that take part are, between two ticks.
template <class Ecology, class... Observers>
[[nodiscard]] Checkpoint take(Ecology& ecology, const observe::RunDescription& run, Observers&... observers) {
  Checkpoint moment{.fingerprint = run.fingerprint,
                    .program_version = std::string{version},
                    .seed = run.seed,
                    .tick = ecology.tick(),
                    .time_s = ecology.time_s(),
                    .sections = {detail::section_of(ecology_section, ecology)}};
  [[maybe_unused]] const auto add = [&]<class O>(O& observer) {
    if constexpr (Kept<O>) moment.sections.push_back(detail::section_of(O::section, observer));
  };
  (add(observers), ...);
  return moment;
}

/// Throws std::invalid_argument naming what differs if a checkpoint is not of this run, seed aside.
void check_same_rules(const Checkpoint& checkpoint, const observe::RunDescription& run);

/// Also where the seed differs.
void check_same_run(const Checkpoint& checkpoint, const observe::RunDescription& run);

/// Lets an ecology of other rules or another seed begin from a checkpoint. Throws std::invalid_argument for one of other robots
/// or other states of rules, else as `restore`.
template <class Ecology, class... Observers>
void restore_any(const Checkpoint& checkpoint, Ecology& ecology, Observers&... observers) {
  constexpr std::size_t sections = (1 + ... + (Kept<Observers> ? 1 : 0));
  if (checkpoint.sections.size() > sections) {
    throw std::invalid_argument{"the checkpoint holds " + std::to_string(checkpoint.sections.size()) +
                                " sections, the last of \"" + checkpoint.sections.back().name + "\": must be " +
                                std::to_string(sections) + "; the run was made with more than this command"};
  }
  detail::read_section(checkpoint, ecology_section, ecology);
  [[maybe_unused]] const auto read = [&]<class O>(O& observer) {
    if constexpr (Kept<O>) detail::read_section(checkpoint, O::section, observer);
  };
  (read(observers), ...);
}

/// Lets an ecology that has been made from the same numbers, and those of its observers that take part, go on from a checkpoint.
/// Files are cut to what they were. Throws std::invalid_argument if the checkpoint is not of this run or of other observers;
/// std::runtime_error for a file that is missing or shorter than it was.
template <class Ecology, class... Observers>
void restore(const Checkpoint& checkpoint, Ecology& ecology, Observers&... observers) {
  check_same_run(checkpoint, ecology.describe(0.0));
  restore_any(checkpoint, ecology, observers...);
}

/// An observer that writes checkpoints of the run and of its other observers, those that take part, into a folder: as often as
/// its schedule says, where the run ends and where it is stopped. Refers to them. They must be told of a tick before this one is.
template <class... Observers>
class Keeper {
 public:
  Keeper(std::filesystem::path folder, Schedule schedule, Observers&... observers)
      : folder_{std::move(folder)}, schedule_{schedule}, observers_{observers...} {}

  void on_start(const observe::RunDescription& run, const View& view) {
    run_ = run;
    last_s_ = view.time_s;
  }

  template <class Ecology>
  void between_ticks(Ecology& ecology, bool last) {
    if (!last && !due(ecology.time_s())) return;
    const double before_s = watch_.elapsed_s();
    std::apply([&](auto&... observers) { write(folder_, take(ecology, run_, observers...)); }, observers_);
    if (last && ecology.time_s() >= run_.until_s) remove_predecessor(folder_);
    written_s_ = watch_.elapsed_s();
    cost_s_ = written_s_ - before_s;
    last_s_ = ecology.time_s();
    ++written_;
  }

  /// How many it has written.
  [[nodiscard]] std::uint64_t written() const { return written_; }

 private:
  [[nodiscard]] bool due(double time_s) const {
    if (!(schedule_.every_s > 0.0) || time_s - last_s_ < schedule_.every_s) return false;
    return cost_s_ <= schedule_.most_share * (watch_.elapsed_s() - written_s_);
  }

  std::filesystem::path folder_;
  Schedule schedule_;
  std::tuple<Observers&...> observers_;
  observe::RunDescription run_;
  observe::Stopwatch watch_;  ///< decides when checkpoints are written, never what is in a result
  double last_s_ = 0.0;
  double written_s_ = 0.0;
  double cost_s_ = 0.0;
  std::uint64_t written_ = 0;
};

}  // namespace trophic::checkpoint

#if TROPHIC_HEADER_ONLY
#include <trophic/checkpoint/keeper.ipp>
#endif
