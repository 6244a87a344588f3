// SPDX-License-Identifier: MIT
// YAML as JSON.
#pragma once

#include <trophic/support/json.hpp>

namespace trophic::convert {

/// The key of an object's line.
inline constexpr const char* line_key = "\n";

/// The first document of a YAML text, whose scalars are texts or null and whose objects have their line; of one with a key `body`
/// only that. Throws std::invalid_argument "FILE:LINE: ..." for another text, a key that is not a text or appears twice, more
/// than 128 levels, 100 keys of an object or 100 000 values.
[[nodiscard]] Json read_yaml(const std::string& text, const std::string& file);

}  // namespace trophic::convert
