// SPDX-License-Identifier: MIT
// Definitions of escaped.hpp.
#include <tools/experiment/escaped.hpp>

namespace trophic {

namespace {

/// `text` with each character of `special` replaced by what `escape` gives for it.
template <class Escape>
std::string escaped(std::string_view text, std::string_view special, Escape&& escape) {
  std::string result;
  for (const char letter : text) {
    if (special.find(letter) == std::string_view::npos) {
      result += letter;
    } else {
      result += escape(letter);
    }
  }
  return result;
}

}  // namespace

std::string markdown_text(std::string_view text) {
  return escaped(text, "\\`*_<>[]|~", [](char letter) { return std::string{'\\', letter}; });
}

std::string latex_text(std::string_view text) {
  bool open = false;
  return escaped(text, "\\{}$&#%_^~<>|\"/", [&](char letter) -> std::string {
    switch (letter) {
      case '\\':
        return "\\textbackslash{}";
      case '^':
        return "\\textasciicircum{}";
      case '~':
        return "\\textasciitilde{}";
      case '<':
        return "\\textless{}";
      case '>':
        return "\\textgreater{}";
      case '|':
        return "\\textbar{}";
      case '"':
        open = !open;
        return open ? "``" : "''";
      case '_':
      case '/':
        return (letter == '_' ? "\\_" : "/") + std::string{"\\allowbreak{}"};
      default:
        return {'\\', letter};
    }
  });
}

}  // namespace trophic
