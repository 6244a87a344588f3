// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/replicates/rewind.hpp>
#include <trophic/support/version.hpp>

namespace {

using namespace trophic;
using test::TemporaryFolder;

void write_moment(const std::filesystem::path& folder, double time_s, std::string_view by = version) {
  checkpoint::write(folder, {.fingerprint = "0123456789abcdef",
                             .program_version = std::string{by},
                             .seed = 7,
                             .tick = 0,
                             .time_s = time_s,
                             .sections = {}});
}

void write_manifest(const std::filesystem::path& folder, const std::string& status, int until_s) {
  std::ofstream{folder / "manifest.json"} << R"({"status": ")" << status << R"(", "clock": {"until_s": )" << until_s << "}}";
}

}  // namespace

TEST_CASE("rewind: run that begins from a snapshot -> needs it until it has a checkpoint of its own") {
  const TemporaryFolder folder;
  CHECK(checkpoint::needs_snapshot(folder.path() / "none", 100.0));
  CHECK(checkpoint::needs_snapshot(folder.path(), 100.0));

  write_manifest(folder.path(), "running", 100);
  CHECK(checkpoint::needs_snapshot(folder.path(), 100.0));
  write_manifest(folder.path(), "complete", 100);
  CHECK_FALSE(checkpoint::needs_snapshot(folder.path(), 100.0));
  CHECK(checkpoint::needs_snapshot(folder.path(), 200.0));

  write_moment(folder.path(), 100.0, "0.0.0");
  CHECK(checkpoint::needs_snapshot(folder.path(), 200.0));
  write_moment(folder.path(), 100.0);
  CHECK_FALSE(checkpoint::needs_snapshot(folder.path(), 200.0));

  std::filesystem::remove(folder.path() / checkpoint::predecessor_name);
  std::filesystem::resize_file(folder.path() / checkpoint::file_name, 30);
  CHECK(checkpoint::needs_snapshot(folder.path(), 200.0));
  CHECK(checkpoint::exists(folder.path()));  // unusable folders are not changed
}

TEST_CASE("rewind: snapshot -> copied up to the latest checkpoint of this version that is not too late") {
  const TemporaryFolder folder;
  const std::filesystem::path run = folder.path() / "run";
  std::filesystem::create_directory(run);
  std::ofstream{run / "events.csv"} << "time_s\n";
  write_manifest(run, "complete", 100);
  write_moment(run, 50.0);
  write_moment(run, 100.0);

  checkpoint::copy_until(run, 49.0, folder.path() / "before");
  CHECK_FALSE(std::filesystem::exists(folder.path() / "before"));
  checkpoint::copy_until(run, 99.0, folder.path() / "between");
  CHECK(checkpoint::read_last(folder.path() / "between").time_s == 50.0);
  CHECK(std::filesystem::exists(folder.path() / "between/events.csv"));
  CHECK_FALSE(std::filesystem::exists(folder.path() / "between/manifest.json"));
  checkpoint::copy_until(run, 100.0, folder.path() / "after");
  CHECK(checkpoint::read_last(folder.path() / "after").time_s == 100.0);

  write_moment(run, 100.0, "0.0.0");
  write_moment(run, 100.0, "0.0.0");
  checkpoint::copy_until(run, 100.0, folder.path() / "foreign");
  CHECK_FALSE(std::filesystem::exists(folder.path() / "foreign"));
}
