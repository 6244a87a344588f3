// SPDX-License-Identifier: MIT
// Bytes as text, for files that carry others.
#pragma once

#include <string>
#include <string_view>

namespace trophic::command::replay {

[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace trophic::command::replay
