// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/reading/run_folders.hpp>
#include <unit/reading/run_files.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("run folders: folder of replicates -> the runs of its list, with a remark on missing ones") {
  const TemporaryFolder folder;
  static_cast<void>(folder.file("replicates.json", R"({"replicates": [{"folder": "replicate-00"}, {"folder": "replicate-01"},
    {"folder": "replicate-02"}]})"));
  const auto first = write_run(folder.path() / "replicate-00", manifest("aa", 1));
  const auto last = write_run(folder.path() / "replicate-02", manifest("aa", 2));
  write_run(folder.path() / "replicate-02.incomplete-1", manifest("bb", 2));
  std::vector<std::string> remarks;
  CHECK(analysis::run_folders(folder.path(), remarks) == std::vector{first, last});
  CHECK(remarks == std::vector{(folder.path() / "replicate-01").string() + ": is missing, because the replicate was not run"});
  CHECK(analysis::run_folders(first, remarks) == std::vector{first});
}
