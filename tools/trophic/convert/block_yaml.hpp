// SPDX-License-Identifier: MIT
// Reads the part of YAML in which Revolve writes bodies.
#pragma once

#include <string>
#include <string_view>
#include <trophic/support/json.hpp>

namespace trophic::convert {

/// Nested lines `KEY: VALUE` as objects of texts; of a document with a key `body` only that. A value in brackets is kept as a
/// text. Throws std::invalid_argument "FILE:LINE: ..." for other YAML: tabs, lists, tags, anchors, texts over several lines, a
/// key twice, more than 128 levels.
[[nodiscard]] Json read_block_yaml(std::string_view text, const std::string& file);

}  // namespace trophic::convert
