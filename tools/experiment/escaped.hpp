// SPDX-License-Identifier: MIT
// Text as LaTeX and Markdown show it letter by letter.
#pragma once

#include <string>
#include <string_view>

namespace trophic {

[[nodiscard]] std::string markdown_text(std::string_view text);

/// Quotation marks open and close, and a line may break after _ and /.
[[nodiscard]] std::string latex_text(std::string_view text);

}  // namespace trophic
