// SPDX-License-Identifier: MIT
// Recognises the format of another program in a text that is not in the expected one.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <trophic/support/cpp20.hpp>

namespace trophic::detail {

inline constexpr std::string_view robogen_text = "RoboGen's text";

/// The name of the first element of an XML text.
[[nodiscard]] inline std::string_view xml_root(std::string_view text) {
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    if (text.substr(at).starts_with("<!--")) {
      at = text.find("-->", at);
    } else if (!text.substr(at + 1).starts_with('?') && !text.substr(at + 1).starts_with('!')) {
      return text.substr(at + 1, text.find_first_of(" \t\r\n/>", at + 1) - at - 1);
    }
    if (at == std::string_view::npos) break;
  }
  return "";
}

/// The name of the format in which other programs describe robots, by its first element or line; empty for an unknown format.
[[nodiscard]] inline std::string_view foreign_format(std::string_view text) {
  std::string_view line;  // the first line that is neither empty nor a comment
  do {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n\xEF\xBB\xBF"), text.size()));
    line = text.substr(0, text.find_first_of("\r\n"));
    if (line.starts_with('#')) text.remove_prefix(line.size());
  } while (line.starts_with('#'));
  if (line.starts_with('<')) {
    const std::string_view root = xml_root(text);
    return root == "mujoco" ? "MJCF, MuJoCo's XML" : root == "robot" ? "URDF" : root == "sdf" ? "SDF" : "XML";
  }
  if (line.starts_with('{')) return "JSON";
  if (line.starts_with("0 ") && line.find_first_of("=:") == std::string_view::npos) return robogen_text;
  const std::size_t colon = line.find(':');
  const bool has_key =
      colon != std::string_view::npos && line.find_first_of("=[") > colon && (colon + 1 == line.size() || line[colon + 1] == ' ');
  return line.starts_with("---") || line.starts_with("%YAML") || has_key ? "YAML" : "";
}

/// ": is in FORMAT: must be TOML, ..."; empty for a text in an unknown format.
[[nodiscard]] inline std::string about_foreign_format(std::string_view text) {
  const std::string_view format = foreign_format(text);
  if (format.empty()) return "";
  const bool converts = format == "JSON" || format == "YAML" || format == robogen_text;
  return ": is " + std::string{format} +
         ": must be TOML that describes the robot as a tree of cores, hinges and bricks (models/README.md)" +
         (converts ? "; `trophic convert` converts a body of RoboGen, Revolve or revolve2" : "");
}

}  // namespace trophic::detail
