// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <support/temporary_folder.hpp>
#include <trophic/support/whole_file.hpp>

using namespace trophic;
using test::message_of;
using test::TemporaryFolder;

TEST_CASE("whole file: any bytes -> every byte is read") {
  const TemporaryFolder folder;
  const std::string text{"a\0b\r\n\xff", 6};
  CHECK(read_whole_file(folder.file("text", text)) == text);
  CHECK(read_whole_file(folder.file("empty", "")).empty());
}

TEST_CASE("whole file: not a file, missing or too large -> refused at once") {
  const TemporaryFolder folder;
  const auto refusal = [](const std::filesystem::path& path, std::uint64_t most = 100) {
    return message_of<std::invalid_argument>([&] { static_cast<void>(read_whole_file(path, most)); });
  };
  const auto pipe = folder.path() / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(refusal(pipe) == pipe.string() + ": is not a regular file");
  CHECK(refusal(folder.path()) == folder.path().string() + ": is not a regular file");
  CHECK(refusal("/dev/zero") == "/dev/zero: is not a regular file");
  CHECK(refusal(folder.path() / "none") == (folder.path() / "none").string() + ": cannot be read: No such file or directory");
  const std::string large = folder.file("large", std::string(101, 'x'));
  CHECK(refusal(large) == large + ": has 101 bytes: must be <= 100");
}
