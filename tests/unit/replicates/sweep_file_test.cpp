// SPDX-License-Identifier: MIT
// Sweep files: the cells that they make, and the files that are refused.
#include <doctest/doctest.h>

#include <fstream>
#include <stdexcept>
#include <string>
#include <tools/sweep/sweep_file.hpp>
#include <vector>

#include "../../support/temporary_folder.hpp"

using namespace trophic;
using sweep::SweepFile;
using test::TemporaryFolder;

namespace {

SweepFile read(const std::string& text) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "sweep.toml";
  std::ofstream{path} << text;
  return sweep::read_sweep(path);
}

/// The error about a text, without the file's name.
std::string refusal_of(const std::string& text) {
  try {
    static_cast<void>(read(text));
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    return what.substr(what.find("sweep.toml") + std::string{"sweep.toml"}.size());
  }
  return "accepted";
}

std::vector<std::string> texts_of(const std::string& text) {
  const SweepFile file = read(text);
  std::vector<std::string> texts;
  for (const auto& cell : sweep::cells_of(file)) texts.push_back(sweep::text_of(cell, file));
  return texts;
}

}  // namespace

TEST_CASE("sweep file: grid -> every combination, the last key fastest, in the order of the file") {
  CHECK(texts_of("[grid]\nrules.b.x = [1, 2]\nrules.a.y = [0.5, 0.25, 1.0]\n") ==
        std::vector<std::string>{"rules.b.x=1 rules.a.y=0.5", "rules.b.x=1 rules.a.y=0.25", "rules.b.x=1 rules.a.y=1.0",
                                 "rules.b.x=2 rules.a.y=0.5", "rules.b.x=2 rules.a.y=0.25", "rules.b.x=2 rules.a.y=1.0"});
}

TEST_CASE("sweep file: zip -> its lists advance together, for each cell of a grid") {
  CHECK(texts_of("[zip]\na = [1, 2]\nb = [3, 4]\n[grid]\nc = [true, false]\n") ==
        std::vector<std::string>{"a=1 b=3 c=true", "a=1 b=3 c=false", "a=2 b=4 c=true", "a=2 b=4 c=false"});
}

TEST_CASE("sweep file: listed runs -> unchanged, with the common settings in all of them") {
  const SweepFile file =
      read("rule_table = \"paper\"\n[set]\necology.duration_s = 60.0\n[[runs]]\nrules.a = 1\n[[runs]]\nrules.b = \"x\"\n");
  const auto cells = sweep::cells_of(file);
  REQUIRE(cells.size() == 2);
  CHECK(json_text(cells[0]) == R"({"ecology.duration_s":60.0,"rule_table":"paper","rules.a":1})");
  CHECK(json_text(cells[1]) == R"({"ecology.duration_s":60.0,"rule_table":"paper","rules.b":"x"})");
}

TEST_CASE("sweep file: omitted keys -> defaults") {
  const SweepFile file = read("[grid]\na = [1]\n");
  CHECK(file.params.replicates == 10);
  CHECK(file.params.seed == 1);
  CHECK(file.params.paired);
  CHECK_FALSE(file.params.shadow);
  CHECK(file.params.replay_hz == 0.0);
  CHECK(file.params.agents_every == 1);
  CHECK_FALSE(file.params.senses);
  CHECK(read("senses = true\n[grid]\na = [1]\n").params.senses);
  CHECK_FALSE(file.params.states);
  CHECK(read("states = true\n[grid]\na = [1]\n").params.output() == io::OutputOptions{.replay_hz = 0.0, .states = true});
}

TEST_CASE("sweep file: not a sweep -> refused in one line") {
  CHECK(refusal_of("") == ": has neither [grid] nor [zip] nor [[runs]]: nothing varies");
  CHECK(refusal_of("[grid]\n") == ": [grid]: is empty");
  CHECK(refusal_of("[grid]\na = []\n") == ": [grid] a = []: must have a value");
  CHECK(refusal_of("[grid]\na = 1\n").starts_with(": [grid] a = 1: must be a list of values"));
  CHECK(refusal_of("[grid]\na = [[1]]\n").ends_with("must be a finite number, a text, true or false"));
  CHECK(refusal_of("[grid]\na = [nan]\n").ends_with("must be a finite number, a text, true or false"));
  CHECK(refusal_of("[zip]\na = [1, 2]\nb = [1]\n") == ": [zip] b: has 1 values: must have 2, as a");
  CHECK(refusal_of("[set]\na = 1\n[grid]\na = [1]\n") == ": a: is in [set] and in [grid]");
  CHECK(refusal_of("[zip]\na = [1]\n[grid]\na = [1]\n") == ": a: is in [grid] and in [zip]");
  CHECK(refusal_of("engine = \"ode\"\n[grid]\nengine = [\"ode\"]\n") == ": engine: is in [set] and in [grid]");
  CHECK(refusal_of("[grid]\nseed = [1, 2]\n") == ": [grid] seed: is not a setting of a sweep");
  CHECK(refusal_of("replicates = 0\n[grid]\na = [1]\n") == ": replicates = 0: must be >= 1 and <= 1e+06");
  CHECK(refusal_of("replicate = 3\n[grid]\na = [1]\n") == ": replicate: unknown key; did you mean replicates?");
  CHECK(refusal_of("[gird]\na = [1]\n") == ": [gird]: unknown key; did you mean grid?");
  CHECK(refusal_of("color = 3\n[grid]\na = [1]\n").starts_with(": color: unknown key; known here: "));
  CHECK(refusal_of("replay_hz = 7\n[grid]\na = [1]\n") == ": replay_hz = 7: must be 0, 5, 10 or 30");
  CHECK(refusal_of("agents_every = 0\n[grid]\na = [1]\n") == ": agents_every = 0: must be >= 1 and <= 1e+06");
  CHECK(refusal_of("senses = 3\n[grid]\na = [1]\n").starts_with(": senses = 3: must be"));
  CHECK(refusal_of("grid = 3\n") == ": grid: must be a section, [grid]");
  CHECK(refusal_of("runs = 3\n") == ": runs: must be sections, [[runs]]");
  CHECK(refusal_of("[grid\n").starts_with(":1: "));
}

TEST_CASE("sweep file: a million runs by accident -> refused before they are made") {
  std::string list = "[0";
  for (int i = 1; i < 100; ++i) list += ", " + std::to_string(i);
  list += "]\n";
  const std::string grid = "[grid]\na = " + list + "b = " + list + "c = " + list + "d = " + list + "e = " + list;
  CHECK(refusal_of(grid) == ": makes more than 1000000 runs (cells x replicates): must be fewer");
}
