// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/reading/csv_reader.hpp>
#include <trophic/observe/event.hpp>

using namespace trophic;
using analysis::CsvReader;
using test::message_of;
using test::TemporaryFolder;

TEST_CASE("columns are found by name, in the order asked for") {
  const TemporaryFolder folder;
  CsvReader csv{folder.file("t.csv", "a,b,c\n1,2.5,caught\r\n-3,,?\n"), {"c", "a", "b"}};
  REQUIRE(csv.next());
  CHECK(csv.get<Cause>(0) == Cause::caught);
  CHECK(csv.get<int>(1) == 1);
  CHECK(*csv.get_optional<double>(2) == 2.5);
  REQUIRE(csv.next());
  CHECK(csv.get<int>(1) == -3);
  CHECK_FALSE(csv.get_optional<double>(2));
  CHECK(message_of<std::runtime_error>([&] {
          static_cast<void>(csv.get<observe::EventKind>(0));
        }).ends_with("t.csv:3: c = \"?\": must be one of the names that the program writes"));
  CHECK(message_of<std::runtime_error>([&] { static_cast<void>(csv.get<Cause>(0)); }).ends_with("must be the name of a cause"));
  CHECK_THROWS_AS(static_cast<void>(csv.get<std::uint64_t>(1)), std::runtime_error);
  CHECK_FALSE(csv.next());
  CHECK_FALSE(csv.truncated());
}

TEST_CASE("a last line without its newline is truncated, however whole it looks") {
  const TemporaryFolder folder;
  CsvReader csv{folder.file("t.csv", "a,b\n1,2\n3,4"), {"a"}};
  CHECK(csv.next());
  CHECK_FALSE(csv.next());
  CHECK(csv.truncated());
}

TEST_CASE("a missing file, a folder and a file without header are refused by name") {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& path) { return message_of<std::runtime_error>([&] { CsvReader{path, {"a"}}; }); };
  const std::string missing = (folder.path() / "none.csv").string();
  CHECK(error(missing) == missing + ": cannot be read: No such file or directory");
  CHECK(error(folder.path().string()) == folder.path().string() + ": is not a regular file");
  const std::string bare = folder.file("bare.csv", "a");
  CHECK(error(bare) == bare + ": has no header");
  const std::string wrong = folder.file("wrong.csv", "b\n1\n");
  CHECK(error(wrong) == wrong + ":1: no column \"a\"; another kind of file?");
}

TEST_CASE("cell in quotes -> its text, commas in it too") {
  const TemporaryFolder folder;
  CsvReader csv{folder.file("t.csv", "a,b,c\n1,\"[7,9]\",2\n\"[3]\",x,3\n"), {"a", "b", "c"}};
  REQUIRE(csv.next());
  CHECK(csv.get<std::string>(1) == "[7,9]");
  CHECK(csv.get<int>(2) == 2);
  REQUIRE(csv.next());
  CHECK(csv.get<std::string>(0) == "[3]");
  CHECK(csv.get<int>(2) == 3);
}
