// SPDX-License-Identifier: MIT
// Definitions of folder.hpp.
#include <unistd.h>

#include <cstddef>
#include <stdexcept>
#include <system_error>
#include <tools/command/host_name.hpp>
#include <tools/sweep/folder.hpp>
#include <trophic/support/replace_file.hpp>
#include <trophic/support/whole_file.hpp>
#include <trophic/support/without_slash.hpp>

namespace trophic::sweep {

namespace detail {

/// Makes a folder that no other program has, to be renamed.
[[nodiscard]] inline std::filesystem::path new_folder_beside(const std::filesystem::path& name) {
  const std::string beginning = name.string() + ".making-" + host_name() + "-" + std::to_string(::getpid()) + "-";
  for (std::size_t number = 0;; ++number) {
    std::filesystem::path folder = beginning + std::to_string(number);
    if (std::filesystem::exists(std::filesystem::symlink_status(folder))) continue;
    if (std::filesystem::create_directory(folder)) return folder;
  }
}

/// The first three fields that differ between a run of a folder and one of a sweep, the engine first, and their number.
[[nodiscard]] inline std::pair<std::string, std::size_t> differences(const PlannedRun& there, const PlannedRun& here) {
  std::pair<std::string, std::size_t> found;
  const auto compare = [&](const std::string& name, const Json& its, const Json& ours) {
    if (its == ours || ++found.second > 3) return;
    found.first += (found.second > 1 ? "; " : "") + name + " = " + json_text(its) + " there, " + json_text(ours) + " here";
  };
  compare("engine", there.engine, here.engine);
  compare("rule_table", there.rule_table, here.rule_table);
  for (const auto& [path, value] : there.settings.items()) {
    if (path != duration_path) compare(path, value, here.settings.value(path, Json{}));
  }
  for (const auto& [path, value] : here.settings.items()) {
    if (path != duration_path && !there.settings.contains(path)) compare(path, nullptr, value);
  }
  if (there.until_s > here.until_s) compare("until_s", there.until_s, here.until_s);
  compare("replicate", there.replicate, here.replicate);
  compare("shadow", there.shadow, here.shadow);
  compare("seed", there.seed, here.seed);
  compare("replay_hz", there.output.replay_hz, here.output.replay_hz);
  compare("agents_every", there.output.agents_every_ticks, here.output.agents_every_ticks);
  compare("senses", there.output.senses, here.output.senses);
  compare("states", there.output.states, here.output.states);
  compare("fingerprint", there.fingerprint, here.fingerprint);
  return found;
}

/// Throws std::invalid_argument unless a plan has every run of a folder, to the same end or a later one.
inline void check_grown(const std::filesystem::path& path, const std::vector<PlannedRun>& plan) {
  for (const PlannedRun& there : read_plan(path)) {
    std::pair<std::string, std::size_t> least{"", std::string::npos};
    for (const PlannedRun& here : plan) {
      const auto found = differences(there, here);
      if (found.second < least.second) least = found;
    }
    if (least.second == 0) continue;
    throw std::invalid_argument{path.string() + ":" + std::to_string(there.index + 1) +
                                ": the folder holds another plan, whose run the sweep lacks: " + least.first +
                                "; a sweep can get more values, replicates and time: take another --out"};
  }
}

}  // namespace detail

void make_or_join(const std::filesystem::path& folder, const std::vector<PlannedRun>& plan, const std::vector<NamedText>& files) {
  const std::string text = plan_text(plan);
  const auto write_in = [&](const std::filesystem::path& place) {
    for (const auto& [file, content] : files) {
      std::filesystem::create_directories((place / file).parent_path());
      replace_file(place / file, content);
    }
    replace_file(place / plan_name, text);
  };
  const auto join = [&] {
    if (!std::filesystem::exists(folder / plan_name)) {
      throw std::invalid_argument{folder.string() + ": exists already and is not a sweep's folder; runs are never overwritten"};
    }
    if (read_whole_file(folder / plan_name) == text) return;
    detail::check_grown(folder / plan_name, plan);
    write_in(folder);
  };
  if (std::filesystem::exists(folder)) return join();
  const std::filesystem::path name = without_slash(folder);
  if (name.has_parent_path()) std::filesystem::create_directories(name.parent_path());
  const std::filesystem::path making = detail::new_folder_beside(name);
  write_in(making);
  std::error_code error;
  std::filesystem::rename(making, name, error);
  if (!error) return;
  std::filesystem::remove_all(making);
  if (!std::filesystem::exists(folder)) throw std::runtime_error{"cannot make " + folder.string() + ": " + error.message()};
  join();
}

}  // namespace trophic::sweep
