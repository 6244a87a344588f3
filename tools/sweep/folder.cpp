// SPDX-License-Identifier: MIT
// Definitions of folder.hpp.
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string_view>
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

/// Throws std::invalid_argument unless a folder holds this plan.
inline void check_same_plan(const std::filesystem::path& folder, const std::string& plan) {
  const std::filesystem::path path = folder / plan_name;
  if (!std::filesystem::exists(path)) {
    throw std::invalid_argument{folder.string() + ": exists already and is not a sweep's folder; runs are never overwritten"};
  }
  const std::string there = read_whole_file(path);
  if (there == plan) return;
  const auto differs = std::ranges::mismatch(there, plan).in1;
  const auto line = 1 + std::count(there.begin(), differs, '\n');
  throw std::invalid_argument{path.string() + ":" + std::to_string(line) +
                              ": the folder holds another plan from this run on; rules, parameters, models or the sweep changed: "
                              "take another --out"};
}

}  // namespace detail

void make_or_join(const std::filesystem::path& folder, const std::vector<PlannedRun>& plan, const std::vector<NamedText>& files) {
  const std::string text = plan_text(plan);
  if (std::filesystem::exists(folder)) return detail::check_same_plan(folder, text);
  const std::filesystem::path name = without_slash(folder);
  if (name.has_parent_path()) std::filesystem::create_directories(name.parent_path());
  const std::filesystem::path making = detail::new_folder_beside(name);
  for (const auto& [file, content] : files) {
    std::filesystem::create_directories((making / file).parent_path());
    replace_file(making / file, content);
  }
  replace_file(making / plan_name, text);
  std::error_code error;
  std::filesystem::rename(making, name, error);
  if (!error) return;
  std::filesystem::remove_all(making);
  if (!std::filesystem::exists(folder)) throw std::runtime_error{"cannot make " + folder.string() + ": " + error.message()};
  detail::check_same_plan(folder, text);
}

}  // namespace trophic::sweep
