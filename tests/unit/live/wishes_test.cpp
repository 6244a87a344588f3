// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <tools/live/wishes.hpp>
#include <trophic/support/json.hpp>

using namespace trophic;

namespace {

const command::LiveRun run{.folder = "run",
                           .rule_table = "paper",
                           .rule_tables = {"paper", "released"},
                           .seed = 1,
                           .until_s = 60.0,
                           .numbers = {{"rules.capture.reach_m", 1.0, "a victim closer than this is caught", above(0.0)}}};

std::string refusal(const std::string& message) {
  try {
    static_cast<void>(live::read_wish(message, run));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("live wishes: each kind -> read") {
  using Kind = live::Wish::Kind;
  CHECK(live::read_wish(R"({"do": "play"})", run).kind == Kind::play);
  CHECK(live::read_wish(R"({"do": "pause"})", run).kind == Kind::pause);
  CHECK(live::read_wish(R"({"do": "tick"})", run).kind == Kind::tick);
  CHECK(live::read_wish(R"({"do": "speed", "value": 0})", run).speed == 0.0);
  CHECK(live::read_wish(R"({"do": "speed", "value": 2.5})", run).speed == 2.5);
  const live::Wish set = live::read_wish(R"({"do": "set", "number": "rules.capture.reach_m", "value": "0.5"})", run);
  CHECK(set.kind == Kind::set);
  CHECK(set.number == "rules.capture.reach_m");
  CHECK(set.value == "0.5");
  const live::Wish restart = live::read_wish(R"({"do": "restart", "seed": 7, "rules": "released"})", run);
  CHECK(restart.kind == Kind::restart);
  CHECK(restart.seed == 7);
  CHECK(restart.rule_table == "released");
}

TEST_CASE("live wishes: anything else -> refused with what must be") {
  const std::string json = "message: must be a JSON object with the key do";
  CHECK(refusal("") == json);
  CHECK(refusal("{") == json);
  CHECK(refusal("7") == json);
  CHECK(refusal(R"({"do": null})") == json);
  CHECK(refusal(std::string(1000, '[')) == json);
  CHECK(refusal(R"({"do": "speed"})") == json);
  CHECK(refusal(std::string(5000, ' ')) == "message: must have <= 4096 bytes");
  CHECK(refusal(R"({"do": "x"})") == "do = x: must be play, pause, tick, speed, set or restart");
  CHECK(refusal(R"({"do": "speed", "value": 1e9})") == "speed = 1e+09: must be 0 (as fast as possible), or >= 0.05 and <= 1000");
  CHECK(refusal(R"({"do": "set", "number": "rules.x", "value": "1"})") == "rules.x: is not a rule parameter of this run");
  for (const char* value : {"", "1\n2", "[1]", "1 # 2", "'a'"}) {
    const std::string text = json_text(Json{{"do", "set"}, {"number", "rules.capture.reach_m"}, {"value", value}});
    CHECK(refusal(text).ends_with("must be one number, true or false, or one word"));
  }
  CHECK(refusal(json_text(Json{{"do", std::string(300, 'a')}})) == "do: must have <= 200 bytes");
  CHECK(refusal(R"({"do": "restart", "seed": -1, "rules": "paper"})").starts_with("seed = -1: must be a whole number"));
  CHECK(refusal(R"({"do": "restart", "seed": 1, "rules": "other"})") == "rules = other: must be paper or released");
}
