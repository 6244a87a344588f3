// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <trophic/io/next_free_folder.hpp>

namespace {

TEST_CASE("next free folder: existing files and dangling links -> next number") {
  using trophic::io::next_free_folder;
  const trophic::test::TemporaryFolder folder;
  const auto runs = folder.path() / "runs" / "first";
  CHECK(next_free_folder(runs) == folder.path() / "runs" / "first-1");
  std::filesystem::create_directories(folder.path() / "runs" / "first-1");
  CHECK(next_free_folder(runs) == folder.path() / "runs" / "first-2");
  std::filesystem::create_symlink("nowhere", folder.path() / "runs" / "first-2");
  CHECK(next_free_folder(runs) == folder.path() / "runs" / "first-3");
}

}  // namespace
