// SPDX-License-Identifier: MIT
// An error of a file whose content is unknown.
#pragma once

#include <stdexcept>
#include <trophic/support/cpp20.hpp>

namespace trophic {

/// Thrown if the system cannot open or read an existing file, which therefore must not count as missing or damaged.
class UnreadableFile : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace trophic
