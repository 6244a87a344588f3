// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstddef>
#include <support/temporary_folder.hpp>
#include <tools/reading/read_run.hpp>
#include <unit/reading/rows.hpp>
#include <unit/reading/run_files.hpp>
#include <vector>

namespace {

using namespace trophic;
using test::message_of;
using test::TemporaryFolder;

using test::agent_header;
using test::event_header;
const std::string plain_manifest = test::manifest("00ff", 12);

std::string error_of_events(const std::string& text) {
  const TemporaryFolder folder;
  const std::string path = folder.file("events.csv", text);
  std::vector<std::string> remarks;
  const std::string message =
      message_of<std::runtime_error>([&] { static_cast<void>(analysis::read_events(path, test::prey_and_predators, remarks)); });
  return message.starts_with(path) ? message.substr(path.size()) : message;
}

}  // namespace

TEST_CASE("events and agents are read by column name, empty cells as none") {
  const TemporaryFolder folder;
  std::vector<std::string> remarks;
  const auto events =
      analysis::read_events(folder.file("events.csv", event_header + "4,2,catch,3,predator,1,-1,1,inherited,0,7,,,5,1.5,-2.25\n" +
                                                          "4,2,death,5,prey,0,1,1,random,,5,caught,3,,1,2\n"),
                            test::prey_and_predators, remarks);
  REQUIRE(events.size() == 2);
  CHECK(events[0].kind == observe::EventKind::capture);
  CHECK(events[0].species == test::predator);
  CHECK(events[0].origin == Origin::inherited);
  CHECK(*events[0].victim == 5);
  CHECK_FALSE(events[0].cause);
  CHECK(events[0].y_m == -2.25);
  CHECK(*events[1].cause == Cause::caught);
  const auto agents =
      analysis::read_agents(folder.file("agents.csv", agent_header + "2,1,0,9,prey,random,0,-1,0.5,1.5,0,0.7,,,\n" +
                                                          "2,1,1,3,predator,inherited,1,1,0,0,0,-0.7,9,1.58,12\n"),
                            test::prey_and_predators, remarks);
  REQUIRE(agents.size() == 2);
  CHECK_FALSE(agents[0].adversary);
  CHECK_FALSE(agents[0].hunger_ticks);
  CHECK(agents[0].tag == -1);
  CHECK(*agents[1].adversary == 9);
  CHECK(*agents[1].hunger_ticks == 12);
  CHECK(remarks.empty());
}

TEST_CASE("read run: fault in a file -> an error with line and column") {
  const std::string good = "0,0,birth,0,prey,0,1,1,random,,0,,,,1,2\n";
  CHECK(error_of_events(event_header + good).empty());
  CHECK(error_of_events(event_header + good + "0,0,birth,0,prey,0,1,1,random,,0,,,,1\n") == ":3: 15 cells, the header has 16");
  CHECK(error_of_events(event_header + "0,0,birth,x,prey,0,1,1,random,,0,,,,1,2\n") ==
        ":2: id = \"x\": must be a whole number in range");
  CHECK(error_of_events(event_header + "0,0,birth,,prey,0,1,1,random,,0,,,,1,2\n") ==
        ":2: id = \"\": must be a whole number in range");
  CHECK(error_of_events(event_header + "nan,0,birth,0,prey,0,1,1,random,,0,,,,1,2\n") == ":2: time_s = \"nan\": must be finite");
  for (const std::string time_s : {"-1", "1e9", "1e300"}) {
    CHECK(error_of_events(event_header + time_s + ",0,birth,0,prey,0,1,1,random,,0,,,,1,2\n") ==
          ":2: time_s = \"" + time_s + "\": must be >= 0 and <= 1e+08");
  }
  CHECK(error_of_events(event_header + "0,0,birth,0,wolf,0,1,1,random,,0,,,,1,2\n") ==
        ":2: species = \"wolf\": must be a species of the run's manifest");
  CHECK(error_of_events(event_header + "0,0,birth,0,prey,0,1,2,random,,0,,,,1,2\n") == ":2: active = \"2\": must be 0 or 1");
  CHECK(error_of_events("generation,fitness\n1,2\n") == ":1: no column \"time_s\"; another kind of file?");
  CHECK(error_of_events("") == ": has no header");
}

TEST_CASE("agents out of order are refused") {
  const TemporaryFolder folder;
  std::vector<std::string> remarks;
  const std::string path =
      folder.file("agents.csv", agent_header + "4,2,0,9,prey,random,0,-1,0,0,0,0,,,\n" + "2,1,0,9,prey,random,0,-1,0,0,0,0,,,\n");
  CHECK(message_of<std::runtime_error>([&] {
          static_cast<void>(analysis::read_agents(path, test::prey_and_predators, remarks));
        }) == path + ":3: tick = \"1\": must be >= that of the row before");
}

TEST_CASE("read run: last line incomplete -> reported and dropped, with the whole last tick of agents.csv") {
  const TemporaryFolder folder;
  static_cast<void>(folder.file("manifest.json", plain_manifest));
  static_cast<void>(folder.file("events.csv", event_header + "0,0,birth,0,prey,0,1,1,random,,0,,,,1,2\n0,0,birth,1,pre"));
  static_cast<void>(folder.file("agents.csv", agent_header + "0,0,0,0,prey,random,1,1,0,0,0,0,,,\n" +
                                                  "0,0,1,1,prey,random,1,1,0,0,0,0,,,\n" +
                                                  "2,1,0,0,prey,random,1,1,0,0,0,0,,,\n2,1,1,1,prey,ran"));
  const auto run = analysis::read_run(folder.path());
  CHECK(run.events->size() == 1);
  CHECK(run.agents->size() == 2);
  REQUIRE(run.remarks.size() == 2);
  CHECK(run.remarks[0].find("events.csv:3: truncated in the middle of a line") != std::string::npos);
  CHECK(run.remarks[1].find("agents.csv:5: truncated in the middle of a line") != std::string::npos);
}

TEST_CASE("read run: missing table, missing or foreign manifest -> error") {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "manifest.json").string();
  const auto read = [&] { static_cast<void>(analysis::read_run(folder.path())); };
  CHECK(message_of<std::runtime_error>(read).starts_with(path + ": cannot be read: "));
  static_cast<void>(folder.file("manifest.json", R"({"fingerprint": "00ff"})"));
  CHECK(message_of<std::runtime_error>(read).find("'rule_table' not found") != std::string::npos);
  static_cast<void>(folder.file("manifest.json", plain_manifest));
  const auto manifest = analysis::read_manifest(folder.path());
  CHECK(manifest.seed == 12);
  CHECK(manifest.web.eats(1, 0));
  CHECK(manifest.half_side_m == 10.0);
  CHECK(message_of<std::invalid_argument>(read).starts_with((folder.path() / "events.csv").string() + ": cannot be read: "));
  static_cast<void>(folder.file("events.csv", "\xEF\xBB\xBF" + event_header));
  CHECK(message_of<std::invalid_argument>(read) ==
        (folder.path() / "events.csv").string() + ":1: no column \"time_s\"; another kind of file?");
  static_cast<void>(folder.file("events.csv", event_header));
  CHECK(message_of<std::invalid_argument>(read).starts_with((folder.path() / "agents.csv").string() + ": cannot be read: "));
}

TEST_CASE("read_run: genomes, phylogeny or recording damaged or missing -> error, by the manifest's checksums") {
  const TemporaryFolder folder;
  const std::filesystem::path run = test::write_run(folder.path() / "run", plain_manifest);
  std::string text = plain_manifest;
  text.insert(1,
              R"("tables": {"genomes.csv": {"rows": 1, "crc32": 3445352719}, "phylogeny.csv": {"rows": 1, "crc32": 3445352719}},
                    "recording": {"frames": 1, "crc32": 3445352719}, )");
  std::ofstream{run / "manifest.json"} << text;
  const auto put = [&](const char* name, const std::string& content) { std::ofstream{run / name} << content; };
  const auto refusal = [&] { return message_of<std::invalid_argument>([&] { static_cast<void>(analysis::read_run(run)); }); };
  for (const char* name : {"genomes.csv", "phylogeny.csv", "replay.trp"}) {
    CHECK(refusal() == (run / name).string() + ": cannot be read: No such file or directory");
    put(name, "id\n1\n");
  }
  CHECK(refusal().empty());
  for (const char* name : {"genomes.csv", "phylogeny.csv", "replay.trp"}) {
    put(name, "id\n2\n");
    CHECK(refusal().starts_with((run / name).string() + ": has "));
    CHECK(refusal().find(": must be ") != std::string::npos);
    put(name, "id\n1\n");
  }
  text.replace(text.find("genomes.csv"), 11, "../x.csv");
  std::ofstream{run / "manifest.json"} << text;
  CHECK(refusal().ends_with("tables: ../x.csv: must be the name of a file"));
}

TEST_CASE("read run: cut to its first seconds -> the rows up to there, refused if the run is shorter") {
  const TemporaryFolder folder;
  auto run = analysis::read_run(test::write_run(folder.path() / "run", plain_manifest));
  analysis::cut_to(run, 1.0);
  CHECK(run.manifest.until_s == 1.0);
  CHECK(run.events->size() == 2);
  CHECK(run.agents->size() == 2);
  CHECK(message_of<std::invalid_argument>([&] { analysis::cut_to(run, 3000.0); }) ==
        (folder.path() / "run").string() + ": reached 0 s (status complete): must be >= 3000 s, as --until asks");
  run.manifest.reached_s = 6500.0;
  CHECK_NOTHROW(analysis::cut_to(run, 6500.0));
}

TEST_CASE("read run: table cut at a line's end, or rows doubled, reversed or missing -> refused") {
  const TemporaryFolder folder;
  const std::filesystem::path run = test::write_run(folder.path() / "run", plain_manifest);
  const auto sum = analysis::CsvReader{run / "events.csv", {}}.sum();
  CHECK(sum.rows == 5);
  std::string text = plain_manifest;
  text.insert(1, R"("tables": {"events.csv": {"rows": 5, "crc32": )" + std::to_string(sum.crc32) + "}}, ");
  std::ofstream{run / "manifest.json"} << text;
  CHECK(analysis::read_run(run).events->size() == 5);

  std::vector<std::string> lines;
  std::ifstream whole{run / "events.csv"};
  for (std::string line; std::getline(whole, line);) lines.push_back(line);
  const auto refusal = [&](const std::vector<std::size_t>& kept) {
    std::ofstream file{run / "events.csv"};
    for (const std::size_t i : kept) file << lines[i] << "\n";
    file.close();
    return message_of<std::invalid_argument>([&] { static_cast<void>(analysis::read_run(run)); });
  };
  const std::string path = (run / "events.csv").string();
  CHECK(refusal({0, 1, 2, 3, 4, 5}).empty());
  CHECK(refusal({0, 1, 2, 3, 4}).starts_with(path + ": has 4 rows and checksum "));
  CHECK(refusal({0, 1, 2, 3, 4, 4, 5}).starts_with(path + ": has 6 rows and checksum "));
  CHECK(refusal({0, 5, 4, 3, 2, 1}).starts_with(path + ": has 5 rows and checksum "));
  CHECK(refusal({0}).starts_with(path + ": has 0 rows and checksum "));
}

TEST_CASE("read run: thinned table -> must have the ticks of its manifest, and no others") {
  const TemporaryFolder folder;
  const auto thinned = [&](const std::string& name, const std::string& every) {
    const std::string text = plain_manifest.substr(0, plain_manifest.size() - 1) + ", \"agents_every_ticks\": " + every + "}";
    return test::write_run(folder.path() / name, text);
  };
  CHECK(analysis::read_manifest(thinned("two", "2")).agents_every_ticks == 2);
  CHECK(analysis::read_manifest(test::write_run(folder.path() / "all", plain_manifest)).agents_every_ticks == 1);
  CHECK(message_of<std::invalid_argument>([&] { static_cast<void>(analysis::read_run(folder.path() / "two")); }) ==
        (folder.path() / "two/agents.csv").string() + ":4: tick = \"1\": must be a multiple of 2, as its manifest says");
  const auto broken = thinned("none", "0");
  CHECK(message_of<std::runtime_error>([&] { static_cast<void>(analysis::read_manifest(broken)); }) ==
        (broken / "manifest.json").string() + ": agents_every_ticks = 0: must be a whole number from 1 to 9223372036854775807");
}

TEST_CASE("read run: seed or checksum that is not a whole number -> refused, not rounded") {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& what, const std::string& by) {
    std::string text = plain_manifest;
    REQUIRE(text.find(what) != std::string::npos);
    text.replace(text.find(what), what.size(), by);
    return message_of<std::runtime_error>([&] { static_cast<void>(analysis::manifest_of(text, "manifest.json")); });
  };
  const std::string bound = ": must be a whole number from 0 to ";
  CHECK(refusal("\"seed\": 12", "\"seed\": -1") == "manifest.json: seed = -1" + bound + "18446744073709551615");
  CHECK(refusal("\"seed\": 12", "\"seed\": 1e300") == "manifest.json: seed = 1e+300" + bound + "18446744073709551615");
  CHECK(refusal("\"seed\": 12", R"("tables": {"a.csv": {"rows": 1, "crc32": 4294967296}}, "seed": 12)") ==
        "manifest.json: crc32 = 4294967296" + bound + "4294967295");
}
