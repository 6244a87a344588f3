// SPDX-License-Identifier: MIT
// JSON, read and written in one place: what nlohmann-json makes of its templates is compiled once.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// Objects keep the order of their keys, in files as in memory.
using Json = nlohmann::ordered_json;

/// What a text says. Throws Json::exception where it is no JSON.
[[nodiscard]] Json parse_json(std::string_view text);

/// The same, but null where it is no JSON.
[[nodiscard]] Json parse_json_or_null(std::string_view text);

/// As text on one line or, with an indent >= 0, on a line for each value.
[[nodiscard]] std::string json_text(const Json& json, int indent = -1);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/support/json.ipp>
#endif
