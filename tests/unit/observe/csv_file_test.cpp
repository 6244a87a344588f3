// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/io/csv_file.hpp>
#include <unit/observe/scene.hpp>

using namespace trophic;

TEST_CASE("csv: file exists or full disk -> error") {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("rows.csv", "mine\n");
  CHECK(test::message_of<std::runtime_error>([&] {
          io::LineFile{path, "header\n"};
        }) == "cannot create " + path + ": File exists");
  CHECK(test::content(path) == "mine\n");
  const auto other = folder.path() / "other.csv";
  io::LineFile file{other, "header\n"};
  file.buffer() += "row\n";
  CHECK(test::content(other) == "header\n");  // not before it is flushed
  file.flush();
  CHECK(test::content(other) == "header\nrow\n");
  for (int row = 0; row < 20'000; ++row) file.buffer() += "a row\n";
  CHECK(test::content(other).size() > 50'000);  // a long text goes sooner, by whole lines
  CHECK(test::content(other).ends_with("a row\n"));
  file.flush();
  CHECK(file.sum().rows == 20'001);
}
