// SPDX-License-Identifier: MIT
// Definitions of json.hpp.
#pragma once

#include <string>
#include <string_view>
#include <trophic/support/json.hpp>

namespace trophic {

TROPHIC_INLINE Json parse_json(std::string_view text) {
  return Json::parse(text);
}

TROPHIC_INLINE Json parse_json_or_null(std::string_view text) {
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) json = nullptr;
  return json;
}

TROPHIC_INLINE std::string json_text(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace trophic
