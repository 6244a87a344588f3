// SPDX-License-Identifier: MIT
// Definitions of page_parts.hpp.
#include <algorithm>
#include <iostream>
#include <iterator>
#include <tools/reading/pooled_runs.hpp>
#include <tools/trophic/replay/page.hpp>
#include <tools/trophic/replay/page_parts.hpp>
#include <tools/trophic/replay/recorded_run.hpp>
#include <trophic/support/new_file.hpp>

namespace trophic::command::replay {

Json write_parts(const std::filesystem::path& folder, std::span<const std::vector<std::filesystem::path>> sets,
                 std::optional<std::uint64_t> most, const std::string& who) {
  constexpr std::uint64_t usual = 2;
  if (most == std::uint64_t{0}) return {};
  const std::filesystem::path viewer = folder / "viewer.html";
  Json parts = Json::array();
  try {
    write_new_file(viewer, std::string{viewer_page()});
    for (const auto& set : sets) {
      std::vector<std::filesystem::path> runs;
      std::vector<std::string> remarks;
      for (const auto& path : set) std::ranges::copy(analysis::run_folders(path, remarks), std::back_inserter(runs));
      for (const auto& run : std::span{runs}.first(std::min<std::size_t>(most.value_or(usual), runs.size()))) {
        const std::vector<RecordedRun> recorded{open_run(run)};
        for (const std::string& remark : recorded[0].remarks) std::cerr << who << ": " << remark << "\n";
        const std::filesystem::path part = folder / ("replay-" + std::to_string(parts.size()) + ".html");
        write_new_file(part, runs_part(recorded, {}));
        parts.push_back({{"run", run.string()}, {"part", part.string()}});
      }
    }
  } catch (const std::invalid_argument& error) {
    if (most) throw;
    std::cerr << who << ": no replays: " << error.what() << "\n";
    return {};
  }
  return {{"viewer", viewer.string()}, {"runs", parts}};
}

}  // namespace trophic::command::replay
