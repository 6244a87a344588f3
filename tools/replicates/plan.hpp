// SPDX-License-Identifier: MIT
// The replicates of an experiment, with their seeds and folders.
#pragma once

#include <tools/replicates/rewind.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/run/checkpoint/schedule.hpp>
#include <trophic/support/rng.hpp>

namespace trophic::replicates {

/// One run of several that differ in their seed alone.
struct Replicate {
  std::size_t index = 0;
  std::uint64_t seed = 0;
  std::filesystem::path folder;
};

/// The seed of a replicate: the top 53 bits of the stream (master seed, replicate, index), so that every reader of JSON keeps it
/// exact. It depends neither on the number of replicates nor on their order.
[[nodiscard]] inline std::uint64_t seed_of(std::uint64_t master_seed, std::size_t index) {
  return Rng{master_seed, Stream::replicate, index}.bits() >> 11;
}

/// A bound far above any real set; a plan of them all still fits the memory.
inline constexpr std::size_t most_replicates = 100'000;

/// "replicate-00", "replicate-01", ...
[[nodiscard]] inline std::string name_of(std::size_t index) {
  return std::string{"replicate-"} + (index < 10 ? "0" : "") + std::to_string(index);
}

struct Plan {
  std::filesystem::path out;  ///< holds replicates.json and a folder per replicate
  std::uint64_t master_seed = 1;
  std::size_t count = 10;
  std::size_t jobs = 1;                   ///< replicates at a time; results do not depend on it
  bool resume = false;                    ///< use a folder that exists: run missing replicates, resume interrupted ones
  checkpoint::Schedule checkpoints = {};  ///< of each replicate
  io::OutputOptions output = {};          ///< how much of each run is written
  std::optional<checkpoint::Snapshot> snapshot = {};  ///< of a run at a moment of which they all begin
  io::OwnTablesOf own_tables = {};                    ///< written by each run

  /// Throws std::invalid_argument for a number out of bounds or no folder.
  void check() const {
    if (out.empty()) throw std::invalid_argument{"out: must name a folder"};
    if (count == 0) throw std::invalid_argument{"replicates = 0: must be >= 1"};
    if (jobs == 0) throw std::invalid_argument{"jobs = 0: must be >= 1"};
    if (count > most_replicates) {
      throw std::invalid_argument{"replicates = " + std::to_string(count) + ": must be <= " + std::to_string(most_replicates)};
    }
  }

  [[nodiscard]] std::vector<Replicate> all() const {
    std::vector<Replicate> replicates;
    for (std::size_t i = 0; i < count; ++i) replicates.push_back({i, seed_of(master_seed, i), out / name_of(i)});
    return replicates;
  }
};

}  // namespace trophic::replicates
