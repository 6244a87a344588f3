// SPDX-License-Identifier: MIT
// The library's version.
#pragma once

#include <string_view>
#include <trophic/support/cpp20.hpp>

namespace trophic {

inline constexpr std::string_view version = "0.1.0";

}  // namespace trophic
