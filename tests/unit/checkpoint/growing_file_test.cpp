// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cstdint>
#include <iterator>
#include <support/temporary_folder.hpp>
#include <trophic/io/growing_file.hpp>
#include <utility>

namespace {

using namespace trophic;
using test::message_of;
using test::TemporaryFolder;

std::string content(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

std::uint32_t crc(const std::string& bytes) {
  boost::crc_32_type sum;
  sum.process_bytes(bytes.data(), bytes.size());
  return sum.checksum();
}

}  // namespace

TEST_CASE("growing file: resumed -> cut to its length at the checkpoint, and ends with the same bytes") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "table.csv";
  Archive archive;
  {
    GrowingFile file{path, Opening::created};
    file.append("one\n");
    file.persist(archive);
    file.append("two, half of it");
  }
  CHECK(content(path) == "one\ntwo, half of it");
  GrowingFile file{path, Opening::resumed};
  CHECK(file.length() == 19);
  Archive back{archive.bytes()};
  file.persist(back);
  CHECK(content(path) == "one\n");
  GrowingFile moved = std::move(file);
  moved.append("two\n");
  CHECK(content(path) == "one\ntwo\n");
  CHECK(moved.length() == 8);
  CHECK(moved.checksum() == crc("one\ntwo\n"));
}

TEST_CASE("growing file: bytes changed before the checkpoint's length -> refused and left as they are") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "table.csv";
  Archive archive;
  const std::string written = std::string(100'000, 'x') + "1,2\n";
  {
    GrowingFile file{path, Opening::created};
    file.append(written);
    file.persist(archive);
    file.append("a row after the checkpoint\n");
  }
  const std::string whole = content(path);
  const auto refusal = [&](const std::string& changed) {
    std::ofstream{path, std::ios::binary} << changed;
    GrowingFile file{path, Opening::resumed};
    Archive back{archive.bytes()};
    const std::string said = message_of<DamagedFile>([&] { file.persist(back); });
    if (!said.empty()) CHECK(content(path) == changed);
    return said;
  };
  std::string digit = whole;
  digit[written.size() - 2] = '3';
  CHECK(refusal(digit) == "cannot continue " + path.string() + ": its first 100004 bytes have checksum " +
                              std::to_string(crc(digit.substr(0, written.size()))) + ": must be " + std::to_string(crc(written)) +
                              ", as at the checkpoint; the file was damaged or modified after the run wrote it");
  std::string zeros = whole;
  std::fill_n(zeros.begin() + 4096, 4096, '\0');
  CHECK_FALSE(refusal(zeros).empty());
  CHECK_FALSE(refusal("\r" + whole).empty());
  std::string later = whole;
  later.back() = '!';
  CHECK(refusal(later).empty());
  CHECK(content(path) == written);
}

TEST_CASE("growing file: a link, or a file with another name -> refused to be continued") {
  const TemporaryFolder folder;
  const std::string precious = folder.file("precious", "text");
  const auto path = folder.path() / "table.csv";
  const auto refusal = [&] { return message_of<std::runtime_error>([&] { GrowingFile{path, Opening::resumed}; }); };
  std::filesystem::create_symlink(precious, path);
  CHECK(refusal() == "cannot open " + path.string() + ": it is a symbolic link");
  std::filesystem::remove(path);
  std::filesystem::create_hard_link(precious, path);
  CHECK(refusal() ==
        "cannot continue " + path.string() + ": it has a second name (a hard link), whose file would change as well");
  CHECK(content(precious) == "text");
}

TEST_CASE("a file is never overwritten, and one that is too short, missing or a pipe is refused") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "table.csv";
  Archive archive;
  {
    GrowingFile file{path, Opening::created};
    file.append("some bytes");
    file.persist(archive);
  }
  CHECK(message_of<std::runtime_error>([&] {
          GrowingFile{path, Opening::created};
        }) == "cannot create " + path.string() + ": File exists");
  std::filesystem::resize_file(path, 4);
  GrowingFile file{path, Opening::resumed};
  Archive back{archive.bytes()};
  CHECK(message_of<std::runtime_error>([&] { file.persist(back); }) ==
        "cannot continue " + path.string() + ": it has 4 bytes: must be >= 10, as many as it had at the checkpoint");
  CHECK_THROWS_AS((GrowingFile{folder.path() / "none", Opening::resumed}), std::runtime_error);
  REQUIRE(::mkfifo((folder.path() / "pipe").c_str(), 0600) == 0);
  CHECK_THROWS_AS((GrowingFile{folder.path() / "pipe", Opening::resumed}), std::runtime_error);
}
