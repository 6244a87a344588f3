// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <support/temporary_folder.hpp>
#include <trophic/support/replace_file.hpp>

using namespace trophic;
using test::message_of;
using test::TemporaryFolder;

namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

}  // namespace

TEST_CASE("replace file: new text -> replaced as a whole, no other file left") {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.file("a.txt", "a long old text\n");
  replace_file(path, std::string{"new\0", 4});
  CHECK(content(path) == std::string{"new\0", 4});
  replace_file(path, "");
  CHECK(content(path).empty());
  CHECK(std::distance(std::filesystem::directory_iterator{folder.path()}, {}) == 1);
}

TEST_CASE("replace file: failure -> old file kept, error with its name") {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.file("a.txt", "old");
  std::filesystem::create_directory(path.string() + ".part");
  CHECK(message_of<std::runtime_error>([&] { replace_file(path, "new"); }) ==
        "cannot write " + path.string() + ": Is a directory");
  CHECK(content(path) == "old");
  const std::string nowhere = (folder.path() / "none" / "a.txt").string();
  CHECK(message_of<std::runtime_error>([&] { replace_file(nowhere, "new"); }) ==
        "cannot write " + nowhere + ": No such file or directory");
}
