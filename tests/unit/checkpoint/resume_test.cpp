// SPDX-License-Identifier: MIT
// An interrupted run resumes to the same bytes: kinematic backend, every rule table, any moment.
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/io/program_code.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/rng.hpp>
#include <trophic/worlds/mating_zones.hpp>
#include <unit/checkpoint/resumed.hpp>

namespace {

using namespace trophic;
using namespace trophic::test;
namespace fs = std::filesystem;

constexpr auto unchanged = [](std::size_t, auto&) {};

template <class Rules>
Experiment<Rules> brief(std::uint64_t seed, double duration_s = 600.0) {
  Experiment<Rules> experiment;
  experiment.seed = seed;
  experiment.ecology.duration_s = duration_s;
  return experiment;
}

/// Stops the run after a tick.
struct StopAt {
  std::int64_t tick = 0;
  bool reached = false;
  void on_tick(const View& view) { reached = view.tick >= tick; }
  [[nodiscard]] bool keep_running() const { return !reached; }
};

/// Fewer under clang++'s AddressSanitizer, with which all of them took half a minute for each table instead of two seconds.
#ifdef __has_feature
constexpr std::size_t moments = __has_feature(address_sanitizer) ? 3 : 12;
#else
constexpr std::size_t moments = 12;
#endif

template <class Rules>
void check_random_moments() {
  for (std::size_t i = 0; i < moments; ++i) {
    Rng rng{i, Stream::user};
    const TemporaryFolder folder;
    const auto experiment = brief<Rules>(rng.index(1000));
    const auto ticks = static_cast<std::size_t>(experiment.ecology.duration_s / experiment.ecology.tick_s);
    const std::vector<std::int64_t> cuts{static_cast<std::int64_t>(rng.index(ticks + 1))};
    CAPTURE(experiment.seed);
    CAPTURE(cuts[0]);
    check_resumed(experiment, backend::Kinematic::Params{}, folder.path(), cuts, 10.0 + 200.0 * rng.uniform(), unchanged);
  }
}

}  // namespace

TEST_CASE("resume: run of paper interrupted at any moment -> the same bytes") {
  check_random_moments<rules::Paper>();
}

TEST_CASE("resume: run of released interrupted at any moment -> the same bytes") {
  check_random_moments<rules::Released>();
}

TEST_CASE("resume: run of mating_zones, whose zones move, interrupted at any moment -> the same bytes") {
  check_random_moments<worlds::MatingZones>();
}

TEST_CASE("resume: run interrupted ten times -> the same bytes") {
  const TemporaryFolder folder;
  std::vector<std::int64_t> cuts;
  Rng rng{1, Stream::user};
  for (int i = 0; i < 10; ++i) cuts.push_back(1 + static_cast<std::int64_t>(rng.index(300)));
  std::ranges::sort(cuts);
  check_resumed(brief<rules::Released>(5), backend::Kinematic::Params{}, folder.path(), cuts, 30.0, unchanged);
  const auto manifest = parse_json(content(folder.path() / "parts/manifest.json"));
  CHECK(manifest["status"] == Json("complete"));
  CHECK(manifest["continued"].size() >= 5);
}

TEST_CASE("resume: run that was stopped or is extended -> the same bytes") {
  const TemporaryFolder folder;
  run_in_parts(brief<rules::Paper>(3), backend::Kinematic::Params{}, folder.path() / "whole", {}, 100.0, unchanged);
  const auto part = [&](double until_s, std::int64_t stop_tick) {
    Ecology<rules::Paper> ecology{brief<rules::Paper>(3, until_s), backend::Kinematic::Params{}};
    const auto run_state = checkpoint::run_state_in(folder.path() / "parts", ecology.describe(until_s));
    io::RunFolder files{folder.path() / "parts", {}, {}, run_state.opening()};
    StopAt stop{.tick = stop_tick};
    checkpoint::run_with_checkpoints(ecology, until_s, folder.path() / "parts", {.every_s = 0.0}, run_state.from, files, stop);
    return run_state;
  };
  CHECK(part(400.0, 37).remark.empty());
  CHECK(checkpoint::status_of(folder.path() / "parts") == "stopped");
  CHECK(part(400.0, 1000).from->tick == 37);
  CHECK(checkpoint::status_of(folder.path() / "parts") == "complete");
  CHECK_FALSE(fs::exists(folder.path() / "parts" / checkpoint::predecessor_name));
  CHECK(part(600.0, 1000).from->tick == 200);
  CHECK(results_in(folder.path() / "whole") == results_in(folder.path() / "parts"));
}

TEST_CASE("resume: run with a thinned agents.csv, resumed with another interval -> the same bytes") {
  const TemporaryFolder folder;
  const fs::path whole = folder.path() / "whole";
  const fs::path parts = folder.path() / "parts";
  run_part(brief<rules::Released>(5), backend::Kinematic::Params{}, whole, never, 50.0, {.agents_every_ticks = 7});
  run_part(brief<rules::Released>(5), backend::Kinematic::Params{}, parts, 101, 50.0, {.agents_every_ticks = 7});
  run_part(brief<rules::Released>(5), backend::Kinematic::Params{}, parts, 209, 50.0, {.agents_every_ticks = 1});
  run_part(brief<rules::Released>(5), backend::Kinematic::Params{}, parts, never, 50.0, {.agents_every_ticks = 5});
  CHECK(results_in(whole) == results_in(parts));
  const auto manifest = parse_json(content(parts / "manifest.json"));
  CHECK(manifest["agents_every_ticks"] == Json(7));
  CHECK(manifest["tables"]["agents.csv"]["rows"] == Json(30 * (300 / 7 + 1)));

  run_part(brief<rules::Released>(5), backend::Kinematic::Params{}, folder.path() / "all", never, 50.0);
  for (const char* file : {"events.csv", "phylogeny.csv", "genomes.csv", "replay.trp"}) {
    CAPTURE(file);
    CHECK(content(whole / file) == content(folder.path() / "all" / file));
  }
  CHECK_FALSE(parse_json(content(folder.path() / "all/manifest.json")).contains("agents_every_ticks"));
}

TEST_CASE("resume: run with states.csv, with and without senses.csv -> the same bytes") {
  for (const bool senses : {false, true}) {
    const TemporaryFolder folder;
    const fs::path whole = folder.path() / "whole";
    const fs::path parts = folder.path() / "parts";
    run_part(brief<rules::Released>(5), backend::Kinematic::Params{}, whole, never, 50.0,
             {.agents_every_ticks = 2, .senses = senses, .states = true});
    run_part(brief<rules::Released>(5), backend::Kinematic::Params{}, parts, 101, 50.0,
             {.agents_every_ticks = 2, .senses = senses, .states = true});
    run_part(brief<rules::Released>(5), backend::Kinematic::Params{}, parts, 209, 50.0, {.senses = !senses});
    run_part(brief<rules::Released>(5), backend::Kinematic::Params{}, parts, never, 50.0);
    CHECK(results_in(whole) == results_in(parts));
    CHECK(fs::exists(parts / "senses.csv") == senses);
    const auto manifest = parse_json(content(parts / "manifest.json"));
    CHECK(manifest["tables"]["states.csv"] == parse_json(content(whole / "manifest.json"))["tables"]["states.csv"]);
    CHECK(manifest["tables"]["states.csv"]["rows"] == manifest["tables"]["agents.csv"]["rows"]);
  }
}

TEST_CASE("resume: run with senses.csv -> the same bytes, and no other file differs") {
  const TemporaryFolder folder;
  const fs::path whole = folder.path() / "whole";
  const fs::path parts = folder.path() / "parts";
  const fs::path without = folder.path() / "without";
  run_part(brief<rules::Paper>(5), backend::Kinematic::Params{}, whole, never, 50.0, {.agents_every_ticks = 2, .senses = true});
  run_part(brief<rules::Paper>(5), backend::Kinematic::Params{}, parts, 101, 50.0, {.agents_every_ticks = 2, .senses = true});
  run_part(brief<rules::Paper>(5), backend::Kinematic::Params{}, parts, 209, 50.0, {.agents_every_ticks = 1, .senses = false});
  run_part(brief<rules::Paper>(5), backend::Kinematic::Params{}, parts, never, 50.0, {.agents_every_ticks = 5, .senses = true});
  CHECK(results_in(whole) == results_in(parts));
  auto manifest = parse_json(content(whole / "manifest.json"));
  CHECK(manifest["tables"]["senses.csv"]["rows"] == Json(30 * (300 / 2 + 1)));
  CHECK(manifest["senses"]["inputs"].size() == 3);

  // a table that it began without stays absent
  run_part(brief<rules::Paper>(5), backend::Kinematic::Params{}, without, 101, 50.0, {.agents_every_ticks = 2, .senses = false});
  run_part(brief<rules::Paper>(5), backend::Kinematic::Params{}, without, never, 50.0, {.agents_every_ticks = 2, .senses = true});
  CHECK_FALSE(fs::exists(without / "senses.csv"));
  fs::remove(whole / "senses.csv");
  manifest.erase("senses");
  manifest["tables"].erase("senses.csv");
  std::ofstream{whole / "manifest.json"} << json_text(manifest);
  CHECK(results_in(whole) == results_in(without));
}

TEST_CASE("resume: checkpoint of 30 robots -> small") {
  const TemporaryFolder folder;
  run_in_parts(brief<rules::Released>(3), backend::Kinematic::Params{}, folder.path() / "run", {}, 100.0, unchanged);
  CHECK(fs::file_size(folder.path() / "run" / checkpoint::file_name) < 50'000);
}

TEST_CASE("resume: checkpoint of another run, seed or number -> refused, and nothing is changed") {
  const TemporaryFolder folder;
  const fs::path run = folder.path() / "run";
  run_part(brief<rules::Paper>(3), backend::Kinematic::Params{}, run, 150, 100.0);
  const std::string before = content(run / "agents.csv");
  const auto refusal = [&]<class Rules>(const Experiment<Rules>& experiment) {
    return message_of<std::invalid_argument>([&] {
      const Ecology<Rules> ecology{experiment, backend::Kinematic::Params{}};
      static_cast<void>(checkpoint::run_state_in(run, ecology.describe(experiment.ecology.duration_s)));
    });
  };
  CHECK(refusal(brief<rules::Paper>(4)).find("seed = 3: must be 4") != std::string::npos);
  auto fewer = brief<rules::Paper>(3);
  fewer.ecology.robots = 20;
  CHECK(refusal(fewer).find("fingerprint") != std::string::npos);
  CHECK(refusal(brief<rules::Released>(3)).find("fingerprint") != std::string::npos);
  CHECK(refusal(brief<rules::Paper>(3, 100.0)).find("until_s = 100: must be > 198") != std::string::npos);
  CHECK(content(run / "agents.csv") == before);
}

TEST_CASE("resume: a checkpoint of another build -> refused, or accepted and recorded in the manifest for ever") {
  const TemporaryFolder folder;
  const fs::path run = folder.path() / "run";
  const auto made_by_another = [&](std::int64_t until_tick) {
    run_part(brief<rules::Paper>(3), backend::Kinematic::Params{}, run, until_tick, 50.0);
    checkpoint::Checkpoint last = checkpoint::read_last(run);
    CHECK(last.code == program_code());
    last.code = "another";
    checkpoint::write(run, last);
    auto manifest = parse_json(content(run / "manifest.json"));
    manifest["code"] = "another";
    manifest.erase("crc32");
    std::ofstream{run / "manifest.json"} << sealed_text(manifest);
  };
  made_by_another(150);
  Ecology<rules::Paper> ecology{brief<rules::Paper>(3), backend::Kinematic::Params{}};
  const auto description = ecology.describe(600.0);
  CHECK(message_of<std::invalid_argument>([&] {
          static_cast<void>(checkpoint::run_state_in(run, description));
        }).find("the checkpoint's code = another: must be " + program_code()) != std::string::npos);
  CHECK_THROWS_AS(checkpoint::check_build(run), std::invalid_argument);

  const auto run_state = checkpoint::run_state_in(run, description, {.other_build = checkpoint::OtherBuild::accepted});
  CHECK(run_state.remark.ends_with(", which another build of this program wrote"));
  {
    io::RunFolder files{run, {}, {}, run_state.opening()};
    checkpoint::run_with_checkpoints(ecology, 600.0, run, {.every_s = 50.0}, run_state.from, files);
  }
  const auto manifest = parse_json(content(run / "manifest.json"));
  CHECK(manifest["continued"][0]["code"] == Json(program_code()));
  // The section that it was read from names this program, as this test wrote it: only a run by two programs has both.
  CHECK(checkpoint::builds_of(run) == std::vector{program_code()});
}

TEST_CASE("manifest: resumed by another build -> says so") {
  const TemporaryFolder folder;
  Archive archive;
  const auto text_of = [&](io::Manifest& manifest) {
    const Ecology<rules::Paper> ecology{brief<rules::Paper>(3), backend::Kinematic::Params{}};
    manifest.on_start(ecology.describe(1.0), ecology.view());
    return parse_json(content(folder.path() / "manifest.json"));
  };
  {
    io::Manifest manifest{folder.path() / "manifest.json", {}};
    manifest.persist(archive);
    CHECK(text_of(manifest)["code"] == Json(program_code()));
  }
  const auto resumed_from = [&](const std::string& bytes) {
    io::Manifest manifest{folder.path() / "manifest.json", {}};
    Archive back{bytes};
    manifest.persist(back);
    return text_of(manifest);
  };
  CHECK_FALSE(resumed_from(archive.bytes())["continued"][0].contains("other_build"));
  std::string other = archive.bytes();
  other.replace(other.find(program_code()), 16, "0123456789abcdef");
  const Json mixed = resumed_from(other);
  CHECK(mixed["code"] == Json("0123456789abcdef"));
  CHECK(mixed["continued"][0]["code"] == Json(program_code()));
  CHECK(mixed["continued"][0]["other_build"] == Json("accepted"));
  CHECK(checkpoint::builds_of(folder.path()).size() == 2);
}

TEST_CASE("resume: links among a run's files -> refused, and what they lead to is left as it is") {
  const TemporaryFolder folder;
  const fs::path run = folder.path() / "run";
  const std::string precious = folder.file("precious", "a PhD's worth");
  run_part(brief<rules::Paper>(3), backend::Kinematic::Params{}, run, 150, 50.0);
  const Ecology<rules::Paper> ecology{brief<rules::Paper>(3), backend::Kinematic::Params{}};
  const auto refusal = [&] {
    return message_of<std::invalid_argument>([&] { static_cast<void>(checkpoint::run_state_in(run, ecology.describe(600.0))); });
  };
  CHECK(refusal().empty());
  for (const char* name : {"manifest.json.part", "checkpoint.bin.part", "agents.csv", "replay.trp"}) {
    CAPTURE(name);
    const bool was_there = fs::exists(run / name);
    if (was_there) fs::rename(run / name, folder.path() / "moved");
    fs::create_symlink(precious, run / name);
    CHECK(refusal().starts_with((run / name).string() + ": is a symbolic link"));
    fs::remove(run / name);
    fs::create_hard_link(precious, run / name);
    CHECK(refusal().starts_with((run / name).string() + ": has a second name"));
    fs::remove(run / name);
    if (was_there) fs::rename(folder.path() / "moved", run / name);
  }
  CHECK(refusal().empty());
  CHECK(content(precious) == "a PhD's worth");
}

TEST_CASE("resume: a damaged complete run -> set aside with the reason, and made anew, unless it is not to be verified") {
  const TemporaryFolder folder;
  const fs::path run = folder.path() / "run";
  const Ecology<rules::Paper> ecology{brief<rules::Paper>(3), backend::Kinematic::Params{}};
  const auto state = [&](bool verifies) {
    return checkpoint::run_state_in(run, ecology.describe(100.0), {.verifies = verifies});
  };
  for (const char* name : {"genomes.csv", "agents.csv", "replay.trp", "checkpoint.bin"}) {
    CAPTURE(name);
    fs::remove_all(run);
    run_part(brief<rules::Paper>(3, 100.0), backend::Kinematic::Params{}, run, never, 50.0);
    CHECK(checkpoint::damage_in(run) == "");
    CHECK(state(true).complete);
    std::fstream file{run / name, std::ios::in | std::ios::out | std::ios::binary};
    file.seekp(200);
    file.put('\x7f');
    file.close();
    CHECK(checkpoint::damage_in(run).starts_with((run / name).string() + ": "));
    CHECK(state(false).complete);
    const auto anew = state(true);
    CHECK_FALSE((anew.complete || anew.from));
    CHECK(anew.remark.find("was complete, but damaged (" + (run / name).string()) == 0);
    CHECK_FALSE(fs::exists(run));
  }
}

TEST_CASE("resume: a changed manifest of a complete run -> continued from its checkpoint, and written again") {
  const TemporaryFolder folder;
  const fs::path run = folder.path() / "run";
  run_part(brief<rules::Paper>(3, 100.0), backend::Kinematic::Params{}, run, never, 50.0);
  std::string text = content(run / "manifest.json");
  text.replace(text.find("\"rule_table\": \"paper\""), 21, "\"rule_table\": \"other\"");
  std::ofstream{run / "manifest.json"} << text;
  CHECK(checkpoint::status_of(run) == "unreadable");
  CHECK(checkpoint::damage_in(run).starts_with((run / "manifest.json").string() + ": "));
  run_part(brief<rules::Paper>(3, 100.0), backend::Kinematic::Params{}, run, never, 50.0);
  CHECK(checkpoint::damage_in(run) == "");
}

TEST_CASE("resume: nothing to resume -> folder renamed, folder of a working program -> left alone") {
  const TemporaryFolder folder;
  const fs::path run = folder.path() / "run";
  const Ecology<rules::Paper> ecology{brief<rules::Paper>(3), backend::Kinematic::Params{}};
  const auto run_state = [&] { return checkpoint::run_state_in(run, ecology.describe(600.0)); };
  CHECK(run_state().remark.empty());
  {
    const io::RunFolder files{run};
    CHECK(message_of<std::runtime_error>([&] { static_cast<void>(run_state()); }) ==
          run.string() + ": another program is running in it");
  }
  CHECK(run_state().remark == "was incomplete (status \"unreadable\"; it has no checkpoint): kept as run.incomplete-1, run anew");
  CHECK_FALSE(fs::exists(run));
  CHECK(fs::exists(folder.path() / "run.incomplete-1/events.csv"));
}

TEST_CASE("resume: a folder that is not a run's -> refused, nothing moved") {
  const TemporaryFolder folder;
  const fs::path thesis = folder.path() / "thesis";
  fs::create_directory(thesis);
  std::ofstream{thesis / "chapter.tex"} << "text";
  const Ecology<rules::Paper> ecology{brief<rules::Paper>(3), backend::Kinematic::Params{}};
  CHECK(message_of<std::invalid_argument>([&] {
          static_cast<void>(checkpoint::run_state_in(thesis, ecology.describe(600.0)));
        }) == thesis.string() + ": is not the folder of a run: it has files, but no events.csv");
  CHECK(fs::exists(thesis / "chapter.tex"));
}

TEST_CASE("resume: damaged checkpoint -> its predecessor is used") {
  const TemporaryFolder folder;
  run_in_parts(brief<rules::Paper>(3), backend::Kinematic::Params{}, folder.path() / "whole", {}, 50.0, unchanged);
  const fs::path run = folder.path() / "parts";
  run_in_parts(brief<rules::Paper>(3), backend::Kinematic::Params{}, run, {150, 151}, 50.0, [&](std::size_t part, auto&) {
    if (part == 1 || part == 2) fs::resize_file(run / checkpoint::file_name, 1000);
  });
  CHECK(results_in(folder.path() / "whole") == results_in(run));
}

TEST_CASE("resume: files shorter than at the checkpoint -> refused") {
  const TemporaryFolder folder;
  const fs::path run = folder.path() / "run";
  run_part(brief<rules::Paper>(3), backend::Kinematic::Params{}, run, 150, 50.0);
  fs::resize_file(run / "agents.csv", 1000);
  Ecology<rules::Paper> ecology{brief<rules::Paper>(3), backend::Kinematic::Params{}};
  const auto run_state = checkpoint::run_state_in(run, ecology.describe(600.0));
  io::RunFolder files{run, {}, {}, run_state.opening()};
  CHECK(message_of<std::runtime_error>([&] {
          checkpoint::restore(*run_state.from, ecology, checkpoint::parts_of(files));
        }).find("agents.csv: it has 1000 bytes: must be >= ") != std::string::npos);
}
