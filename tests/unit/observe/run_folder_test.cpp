// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <set>
#include <trophic/io/csv_file.hpp>
#include <trophic/io/run_folder.hpp>
#include <unit/observe/scene.hpp>

namespace {

/// Names of the files in the order in which they were put on the disk.
std::vector<std::string> synced;

}  // namespace

/// Stands in for the C library's.
extern "C" int fsync(int file) {
  synced.push_back(std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(file)).filename());
  return static_cast<int>(::syscall(SYS_fsync, file));
}

using namespace trophic;
using observe::EventKind;

namespace {

/// A table of the program's own without on_end.
class Ticks {
 public:
  static constexpr std::string_view file_name = "ticks.csv";
  Ticks(const std::filesystem::path& path, Opening opening) : file_{path, "tick\n", opening} {}
  void on_tick(const View& view) {
    file_.buffer() += std::to_string(view.tick) + "\n";
    file_.flush();
  }
  void persist(Archive& archive) { archive(file_); }
  [[nodiscard]] io::TableSum sum() const { return file_.sum(); }

 private:
  io::LineFile file_;
};

}  // namespace

TEST_CASE("run folder: run -> all files, never overwritten") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "deep" / "run";
  test::HandPopulation robots = test::three_robots();
  {
    io::RunFolder run{path};
    CHECK(run.path() == path);
    run.on_start(test::short_run(), robots.view());
    for (BodyIndex body = 0; body < 3; ++body) {
      run.on_event({.kind = EventKind::birth, .body = body, .individual = robots.individuals[body], .cause = {}, .other = {}},
                   robots.view());
    }
    run.on_tick(robots.view());
    // past events are written before the run ends
    CHECK(test::content(path / "events.csv").find("birth,9,") != std::string::npos);
    run.on_end(robots.at_tick(5).view());
  }
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator{path}) files.insert(entry.path().filename());
  for (const char* file : {"events.csv", "agents.csv", "phylogeny.csv", "genomes.csv", "manifest.json"})
    CHECK(files.contains(file));
  CHECK(test::message_of<std::invalid_argument>([&] { io::RunFolder{path}; }) ==
        "output folder " + path.string() + ": exists already; runs are never overwritten");
}

TEST_CASE("run folder: end of a run with every table -> each file on the disk before the manifest says so") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "run";
  test::HandPopulation robots = test::three_robots();
  const io::OutputOptions output{.senses = true, .states = true};
  io::RunFolder run{path, {}, output, Opening::created, {}, io::own_tables<Ticks>()};
  observe::RunDescription all = test::short_run();
  all.has_more_genes = true;
  run.on_start(all, robots.view());
  run.on_event({.kind = EventKind::birth, .body = 0, .individual = robots.individuals[0], .cause = {}, .other = {}},
               robots.view());
  all.bodies_differ = true;
  run.on_start(all, View{robots.view()});
  synced.clear();
  run.on_tick(robots.view());
  View end = robots.at_tick(5).view();
  end.robots = {};
  run.on_end(end);
  std::set<std::string> waiting;
  for (const auto& entry : std::filesystem::directory_iterator{path}) waiting.insert(entry.path().filename());
  for (const char* name : {"senses.csv", "states.csv", "genes.csv", "bodies.csv", "ticks.csv"}) CHECK(waiting.contains(name));
  for (const std::string& name : synced) {
    if (name.starts_with("manifest.json")) break;
    waiting.erase(name);
  }
  waiting.erase("manifest.json");
  CHECK(waiting == std::set<std::string>{});
}
