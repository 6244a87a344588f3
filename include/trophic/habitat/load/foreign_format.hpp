// SPDX-License-Identifier: MIT
// The format of another program that a text is in, if it is not the expected one.
#pragma once

#include <string>
#include <string_view>
#include <trophic/support/cpp20.hpp>

namespace trophic::detail {

inline constexpr std::string_view revolve2_json = "a body of revolve2 as JSON";
inline constexpr std::string_view revolve2_yaml = "a body of revolve2 as YAML";
inline constexpr std::string_view robogen_text = "RoboGen's text";

/// The name of the format in which other programs describe robots; empty if it is none of those that are known.
[[nodiscard]] inline std::string_view foreign_format(std::string_view text) {
  const auto has = [&](std::string_view part) { return text.find(part) != std::string_view::npos; };
  const std::size_t begin = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (begin == std::string_view::npos) return "";
  const std::string_view first = text.substr(begin);
  if (first.starts_with('<')) return has("<mujoco") ? "MJCF, MuJoCo's XML" : has("<robot") ? "URDF" : has("<sdf") ? "SDF" : "XML";
  if (first.starts_with('{')) return has("\"core\"") || has("\"Core") ? revolve2_json : "JSON";
  for (const std::string_view core : {"0 Core", "0 E ", "0 N "}) {
    if (first.starts_with(core)) return robogen_text;
  }
  // Keys may stand in columns: "type   : Core".
  const auto has_key = [&](std::string_view key) {
    for (std::size_t at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1)) {
      const std::size_t next = text.find_first_not_of(' ', at + key.size());
      if (next != std::string_view::npos && text[next] == ':') return true;
    }
    return false;
  };
  if (has_key("type") && (has_key("body") || has_key("children"))) return revolve2_yaml;
  return first.starts_with("---") ? "YAML" : "";
}

/// ": is in FORMAT: must be TOML, ..."; empty for a text in no format that is known.
[[nodiscard]] inline std::string about_foreign_format(std::string_view text) {
  const std::string_view format = foreign_format(text);
  if (format.empty()) return "";
  const bool converts = format == revolve2_json || format == revolve2_yaml || format == robogen_text;
  return ": is " + std::string{format} +
         ": must be TOML, a robot a tree of cores, hinges and bricks as models/README.md describes it" +
         (converts ? "; `trophic convert` makes one of this" : "");
}

}  // namespace trophic::detail
