// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <support/temporary_folder.hpp>
#include <trophic/support/new_file.hpp>
#include <trophic/support/whole_file.hpp>

using namespace trophic;
using test::message_of;

TEST_CASE("new file: finished -> has its name, not finished -> removed") {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "film.mp4";
  {
    const NewFile file{path};
    std::ofstream{file.part()} << "half";
    CHECK_FALSE(std::filesystem::exists(path));
    CHECK(message_of<std::runtime_error>([&] { NewFile{path}; }).ends_with("film.mp4: another program is writing it"));
    CHECK(read_whole_file(file.part()) == "half");
  }
  CHECK(std::filesystem::is_empty(folder.path()));
  std::ofstream{folder.path() / "film.mp4.part"} << "what a killed program left there";
  write_new_file(path, "whole");
  CHECK(read_whole_file(path) == "whole");
  CHECK_FALSE(std::filesystem::exists(folder.path() / "film.mp4.part"));
  CHECK(message_of<std::runtime_error>([&] { write_new_file(path, "other"); }).ends_with("film.mp4: it exists"));
  CHECK(read_whole_file(path) == "whole");
  CHECK_FALSE(std::filesystem::exists(folder.path() / "film.mp4.part"));
}

TEST_CASE("new file: its name is taken while it is written -> error, and what is there stays") {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "film.mp4";
  NewFile file{path};
  file.write("whole");
  std::ofstream{path} << "made meanwhile";
  CHECK(message_of<std::runtime_error>([&] { file.finish(); }).ends_with("film.mp4: File exists"));
  CHECK(read_whole_file(path) == "made meanwhile");
}

TEST_CASE("new file: child of a killed program still writes -> other file") {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "film.mp4";
  std::ofstream still_written{folder.path() / "film.mp4.part"};
  const NewFile file{path};
  still_written << "of another film" << std::flush;
  CHECK(read_whole_file(file.part()) == "");
}

TEST_CASE("new file: a link in its way -> removed, and what it leads to is neither made nor changed") {
  const test::TemporaryFolder folder;
  const std::string precious = folder.file("precious", "text");
  const std::filesystem::path path = folder.path() / "film.mp4";
  for (const std::filesystem::path& target : {std::filesystem::path{precious}, folder.path() / "nowhere"}) {
    std::filesystem::create_symlink(target, path.string() + ".part");
    write_new_file(path, "whole");
    CHECK(read_whole_file(path) == "whole");
    std::filesystem::remove(path);
  }
  std::filesystem::create_hard_link(precious, path.string() + ".part");
  write_new_file(path, "whole");
  CHECK(read_whole_file(precious) == "text");
  CHECK_FALSE(std::filesystem::exists(folder.path() / "nowhere"));
  std::filesystem::remove(path);
  std::filesystem::create_symlink(precious, path);
  CHECK(message_of<std::runtime_error>([&] { write_new_file(path, "other"); }).ends_with("film.mp4: it exists"));
}

TEST_CASE("a new file is made neither in a folder that is not there nor in a pipe") {
  const test::TemporaryFolder folder;
  const auto refusal = [&](const char* name) {
    return message_of<std::runtime_error>([&] { write_new_file(folder.path() / name, "text"); });
  };
  CHECK(refusal("none/x").ends_with("none/x: No such file or directory"));
  REQUIRE(::mkfifo((folder.path() / "pipe.part").c_str(), 0600) == 0);
  CHECK(refusal("pipe").ends_with("pipe.part already exists and is not a file"));
  std::filesystem::create_directory(folder.path() / "folder.part");
  CHECK(refusal("folder").ends_with("folder.part already exists and is not a file"));
}

TEST_CASE("new file: its name is changed to a link while it is written -> what other programs write goes into the file") {
  const test::TemporaryFolder folder;
  const std::string precious = folder.file("precious", "text");
  const std::filesystem::path path = folder.path() / "film.mp4";
  {
    const NewFile file{path};
    std::filesystem::rename(file.part(), folder.path() / "moved");
    std::filesystem::create_symlink(precious, file.part());
    std::ofstream{file.opened_again()} << "film";
  }
  CHECK(read_whole_file(precious) == "text");
  CHECK(read_whole_file(folder.path() / "moved") == "film");
}
