// SPDX-License-Identifier: MIT
// Texts as words of a shell.
#pragma once

#include <string>
#include <string_view>

namespace trophic::command::detail {

/// Quotes a text for bash.
[[nodiscard]] inline std::string shell_text(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string{"'\\''"} : std::string{c};
  return quoted + "'";
}

}  // namespace trophic::command::detail
