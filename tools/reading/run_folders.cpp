// SPDX-License-Identifier: MIT
// Definitions of run_folders.hpp.
#include <tools/reading/run_folders.hpp>

#include <tools/command/check_folder.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/plain_text.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::analysis {

std::vector<std::filesystem::path> run_folders(const std::filesystem::path& path, std::vector<std::string>& remarks) {
  check_folder(path);
  const std::filesystem::path list = path / "replicates.json";
  if (!std::filesystem::exists(list)) return {path};
  std::vector<std::filesystem::path> folders;
  try {
    const Json json = parse_sealed(read_whole_file(list));
    if (!json.is_object())
      throw std::invalid_argument{list.string() + ": is not a JSON object, or was modified after trophic wrote it"};
    for (const auto& replicate : json.at("replicates")) {
      const auto folder_name = replicate.at("folder").get<std::string>();
      if (!is_plain(folder_name)) {
        throw std::invalid_argument{list.string() + ": folder = " + json_text(folder_name) +
                                    ": must be text without control characters"};
      }
      const std::filesystem::path name = folder_name;
      if (name.has_parent_path() || name == "..") {
        throw std::invalid_argument{list.string() + ": folder = " + name.string() + ": must be the name of a folder next to it"};
      }
      const std::filesystem::path folder = path / name;
      if (std::filesystem::is_directory(folder)) {
        folders.push_back(folder);
      } else {
        remarks.push_back(folder.string() + ": is missing, because the replicate was not run");
      }
    }
  } catch (const Json::exception& error) {
    throw std::invalid_argument{list.string() + ": " + reason_of(error)};
  }
  return folders;
}

}  // namespace trophic::analysis
