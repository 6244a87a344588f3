// SPDX-License-Identifier: MIT
// Definitions of rewind.hpp.
#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <trophic/checkpoint/checkpoint_file.hpp>
#include <trophic/checkpoint/rewind.hpp>
#include <trophic/params/named_params.hpp>
#include <vector>

namespace trophic::checkpoint {

TROPHIC_INLINE std::optional<double> last_moment_s(const std::filesystem::path& run) {
  const std::vector<Checkpoint> all = read_all(run);
  return all.empty() ? std::nullopt : std::optional{all.front().time_s};
}

TROPHIC_INLINE void copy_until(const std::filesystem::path& run, double at_s, const std::filesystem::path& folder) {
  if (std::filesystem::exists(folder)) throw std::invalid_argument{folder.string() + ": exists already"};
  const std::vector<Checkpoint> all = read_all(run);
  const auto early = std::ranges::find_if(all, [&](const Checkpoint& one) { return one.time_s <= at_s; });
  if (early == all.end()) return;
  std::error_code error;
  const auto require = [&](const std::filesystem::path& path) {
    if (error) throw std::runtime_error{"cannot copy " + path.string() + ": " + error.message()};
  };
  std::filesystem::create_directories(folder, error);
  require(folder);
  for (const auto& entry : std::filesystem::directory_iterator{run}) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_regular_file() || name.starts_with("checkpoint.") || name.starts_with("manifest.")) continue;
    std::filesystem::copy_file(entry.path(), folder / name, error);
    require(entry.path());
  }
  // Last, so that a copy that was cut off has none.
  write(folder, *early);
}

TROPHIC_INLINE void check_may_follow(const observe::RunDescription& origin, const observe::RunDescription& run) {
  const auto may_change = [](const std::string& path) {
    return path == "seed" || path.starts_with("rules.") || path == "ecology.duration_s" || path == "backend.threads";
  };
  if (origin.backend != run.backend) {
    throw std::invalid_argument{"engine " + run.backend + ": must be " + origin.backend + ", as of the run that it begins from"};
  }
  for (const NamedParam& param : run.named_params) {
    if (may_change(param.path)) continue;
    const auto there = std::ranges::find(origin.named_params, param.path, &NamedParam::path);
    if (there != origin.named_params.end() && there->value == param.value) continue;
    throw std::invalid_argument{param.path + " = " + value_text(param) + ": must be " +
                                (there == origin.named_params.end() ? "missing" : value_text(*there)) +
                                ", as of the run that it begins from; only rules, seed and duration can change"};
  }
}

}  // namespace trophic::checkpoint
