// SPDX-License-Identifier: MIT
// A hash of words of eight bytes.
#pragma once

#include <bit>
#include <cstdint>
#include <trophic/support/cpp20.hpp>

namespace trophic {

/// FNV-1a over words, rotated after each so that high bits reach low ones. It detects changes, not forgery.
class WordHash {
 public:
  void add(std::uint64_t word) { value_ = std::rotl((value_ ^ word) * 0x100000001b3ULL, 29); }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

}  // namespace trophic
