// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <string>
#include <tools/command/words.hpp>
#include <vector>

namespace {

using namespace trophic::command;
const std::vector<std::string> flags{"--replicates", "--resume", "--robot", "--robots", "--rules"};

TEST_CASE("edit distance counts insertions, omissions, replacements and exchanged neighbours") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("abc", "") == 3);
  CHECK(edit_distance("paper", "paper") == 0);
  CHECK(edit_distance("sdd", "sd") == 1);
  CHECK(edit_distance("mutatoin", "mutation") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("ca", "abc") == 3);
  for (const std::string& a : flags) {
    for (const std::string& b : flags) CHECK(edit_distance(a, b) == edit_distance(b, a));
  }
}

TEST_CASE("the nearest word is one that a typist could have meant") {
  CHECK(nearest_word("--replicate", flags) == "--replicates");
  CHECK(nearest_word("--robtos", flags) == "--robots");
  CHECK(nearest_word("--rbot", flags) == "--robot");
  CHECK(nearest_word("--rules", flags) == std::nullopt);
  CHECK(nearest_word("--bogus-thing", flags) == std::nullopt);
  CHECK(nearest_word("", flags) == std::nullopt);
  CHECK(nearest_word("nope", std::vector<std::string>{"paper", "released"}) == std::nullopt);
  CHECK(nearest_word("sd", std::vector<std::string>{"sx"}) == std::nullopt);
  CHECK(nearest_word("ab", std::vector<std::string>{}) == std::nullopt);
}

TEST_CASE("sentences about words") {
  CHECK(one_of(std::vector<std::string>{}).empty());
  CHECK(one_of(std::vector<std::string>{"a"}) == "a");
  CHECK(one_of(std::vector<std::string>{"a", "b"}) == "a or b");
  CHECK(one_of(std::vector<std::string>{"a", "b", "c"}) == "a, b or c");
  CHECK(must_be_one_of("--rules x", std::vector<std::string>{"paper", "released"}) == "--rules x: must be paper or released");
  CHECK(did_you_mean("paper") == "; did you mean paper?");
  CHECK(did_you_mean(std::nullopt).empty());
}

}  // namespace
