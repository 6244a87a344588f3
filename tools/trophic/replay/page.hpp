// SPDX-License-Identifier: MIT
// A page that carries runs: the viewer, the recordings, and of the tables what a viewer needs.
#pragma once

#include <string>
#include <string_view>
#include <tools/trophic/replay/recorded_run.hpp>
#include <vector>

namespace trophic::command::replay {

/// Throws std::invalid_argument where the program was built without the viewer.
[[nodiscard]] std::string_view viewer_page();

/// The part of the viewer's page for these runs: their index, then their files.
[[nodiscard]] std::string runs_part(const std::vector<RecordedRun>& runs, const Window& window);

/// The page. Throws std::invalid_argument for a table that cannot be read.
[[nodiscard]] std::string page_of(const std::vector<RecordedRun>& runs, const Window& window);

}  // namespace trophic::command::replay
