// SPDX-License-Identifier: MIT
// The format of another program that a text is in, if it is not the expected one.
#pragma once

#include <string>
#include <string_view>

namespace trophic::detail {

/// The name of the format in which other programs describe robots; empty if it is none of those that are known.
[[nodiscard]] inline std::string_view foreign_format(std::string_view text) {
  const auto has = [&](std::string_view part) { return text.find(part) != std::string_view::npos; };
  const std::size_t begin = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (begin == std::string_view::npos) return "";
  const std::string_view first = text.substr(begin);
  if (first.starts_with('<')) return has("<mujoco") ? "MJCF, MuJoCo's XML" : has("<robot") ? "URDF" : has("<sdf") ? "SDF" : "XML";
  if (first.starts_with('{')) return has("\"core\"") || has("\"Core\"") ? "a body of revolve2 as JSON" : "JSON";
  if (has("CoreComponent") && !has("body:")) return "RoboGen's text";
  if (has("body:") && has("type:")) return "a body of revolve2 as YAML";
  return first.starts_with("---") ? "YAML" : "";
}

/// ": is in FORMAT: must be TOML, ..."; empty for a text in no format that is known.
[[nodiscard]] inline std::string about_foreign_format(std::string_view text) {
  const std::string_view format = foreign_format(text);
  if (format.empty()) return "";
  return ": is " + std::string{format} +
         ": must be TOML, a robot a tree of cores, hinges and bricks as models/README.md describes it";
}

}  // namespace trophic::detail
