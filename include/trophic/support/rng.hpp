// SPDX-License-Identifier: MIT
// Counter-based random numbers: a stream is identified by (seed, purpose, individual, event) and does not depend on earlier
// draws.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <trophic/support/linkage.hpp>
#include <utility>

namespace trophic {

/// The purpose of a stream. Each rule has its own, so that an extra draw in one rule never shifts the draws of another.
enum class Stream : std::uint64_t {
  placement,
  newborn_tag,
  initial_genome,
  genome_source,
  parent,
  mutation,
  captures,
  sacrifice,
  senescence,
  replicate,
  null_model = 11,  // 10 stays unused: renumbering would change evolved gaits
  gait_founder,
  gait_selection,
  gait_variation,
  visibility,
  sensors,
  recruitment,
  contest,
  brain_structure,
  brain_growth,
  gait_genes,
  gait_mutation,
  body_genes,
  body_mutation,
  crossover,
  resource,
  bites,
  endowment,
  birth_place,
  traits,
  user = 1'000'000,  ///< first number for users' rules
};

namespace detail {

/// Four 64-bit random words: Philox 4x64 with 10 rounds at this counter.
[[nodiscard]] std::array<std::uint64_t, 4> philox(const std::array<std::uint64_t, 4>& counter,
                                                  const std::array<std::uint64_t, 2>& key);

}  // namespace detail

/// A stream of random numbers (Philox 4x64, 10 rounds [salmon2011]). Equal identifiers give equal bits and uniform numbers on
/// every platform, and equal normal numbers up to the last bit of the C library's log and cos. Both transforms are the library's
/// own because those of `<random>` differ between standard libraries. Cheap to construct and copy. Not for cryptography.
class Rng {
 public:
  /// `other` distinguishes streams of one individual and event, for example by the observed individual or the index of a sensor.
  Rng(std::uint64_t seed, Stream purpose, std::uint64_t individual = 0, std::uint64_t event = 0, std::uint64_t other = 0)
      : key_{seed, static_cast<std::uint64_t>(purpose)}, counter_{0, individual, event, other} {}

  /// 64 random bits.
  std::uint64_t bits() {
    if (used_ == block_.size()) {
      block_ = detail::philox(counter_, key_);
      ++counter_[0];
      used_ = 0;
    }
    return block_[used_++];
  }

  /// Uniform in [0, 1), a multiple of 2^-53. One draw of 64 bits.
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

  /// Uniform in [lower, upper). One draw.
  double uniform(double lower, double upper) { return lower + (upper - lower) * uniform(); }

  /// Normal with the given mean and standard deviation: Box-Muller, cosine branch. Two draws.
  double normal(double mean, double standard_deviation) {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    const double angle = 2.0 * std::numbers::pi * uniform();
    return mean + standard_deviation * radius * std::cos(angle);
  }

  /// True with the given probability. One draw.
  bool chance(double probability) { return uniform() < probability; }

  /// Uniform in {0, ..., size - 1}, without bias for sizes below 2^53 (to 2^-53). `size` > 0. One draw.
  std::size_t index(std::size_t size) { return static_cast<std::size_t>(uniform() * static_cast<double>(size)); }

  /// Fisher-Yates shuffle. items.size() - 1 draws.
  template <class T>
  void shuffle(std::span<T> items) {
    for (std::size_t left = items.size(); left > 1; --left) std::swap(items[left - 1], items[index(left)]);
  }

 private:
  std::array<std::uint64_t, 2> key_;
  std::array<std::uint64_t, 4> counter_;
  std::array<std::uint64_t, 4> block_{};
  std::size_t used_ = 4;
};

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/support/rng.ipp>
#endif
