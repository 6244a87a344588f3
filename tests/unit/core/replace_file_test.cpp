// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <iterator>
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

TEST_CASE("replace_file: links under the file's names -> what they lead to is left as it is") {
  const TemporaryFolder folder;
  const std::filesystem::path precious = folder.file("precious", "a PhD's worth");
  const std::filesystem::path path = folder.path() / "a.txt";
  const auto part = path.string() + ".part";
  std::filesystem::create_symlink(precious, part);
  replace_file(path, "one");
  CHECK(content(path) == "one");
  std::filesystem::create_hard_link(precious, part);
  replace_file(path, "two");
  CHECK(content(path) == "two");
  std::filesystem::remove(path);
  std::filesystem::create_symlink(precious, path);
  replace_file(path, "three");
  CHECK_FALSE(std::filesystem::is_symlink(path));
  CHECK(content(path) == "three");
  std::filesystem::create_symlink(folder.path() / "nowhere", part);
  replace_file(path, "four");
  CHECK_FALSE(std::filesystem::exists(folder.path() / "nowhere"));
  CHECK(content(precious) == "a PhD's worth");
}

TEST_CASE("where a file cannot be replaced the old one stands, and the error names it") {
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
