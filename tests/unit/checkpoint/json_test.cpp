// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <trophic/support/json.hpp>

using namespace trophic;

TEST_CASE("json: written -> reads back, keys in their order") {
  const std::string text = R"({"until_s":600.0,"seed":18446744073709551615,"food_web":[{"hunter":"predator"}],"error":null})";
  CHECK(json_text(parse_json(text)) == text);
  CHECK(json_text(parse_json(R"({"b":1,"a":2})"), 2) == "{\n  \"b\": 1,\n  \"a\": 2\n}");
}

TEST_CASE("json: text that is not JSON -> throws, or null") {
  for (const char* text : {"", "{", R"({"a":})", "{} {}", "\xff"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(static_cast<void>(parse_json(text)), Json::exception);
    CHECK(parse_json_or_null(text).is_null());
  }
  CHECK(parse_json_or_null("[]").is_array());
}

TEST_CASE("json: nested deeper than trophic writes -> refused, without overflowing the stack") {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  CHECK(parse_json(nested(64)).is_array());
  CHECK_THROWS_WITH_AS(static_cast<void>(parse_json(nested(65))), "is JSON nested more than 64 levels deep, which is refused",
                       Json::exception);
  CHECK(parse_json_or_null(nested(1'000'000)).is_null());
  CHECK(parse_json_or_null("{\"a\":" + nested(1'000'000) + "}").is_null());
  const std::string brackets = "\"" + std::string(100, '[') + "\\\"" + std::string(100, '{') + "\"";
  CHECK(parse_json(brackets).get<std::string>().size() == 201);
  std::string wide = "[[]";
  for (int i = 0; i < 1000; ++i) wide += ",[]";
  CHECK(parse_json(wide + "]").size() == 1001);
}

TEST_CASE("json: more keys in one object than trophic writes -> refused, without comparing each with each") {
  const auto keys = [](int count) {
    std::string text = "{";
    for (int i = 0; i < count; ++i) text.append(i > 0 ? "," : "").append("\"k").append(std::to_string(i)).append("\":{}");
    return text + "}";
  };
  CHECK(parse_json(keys(10'000)).size() == 10'000);
  CHECK_THROWS_AS(static_cast<void>(parse_json(keys(10'001))), Json::exception);
  CHECK(parse_json_or_null(keys(1'000'000)).is_null());
  CHECK(parse_json("[" + keys(6'000) + "," + keys(6'000) + ",\"" + std::string(20'000, ':') + "\"]").size() == 3);
}

TEST_CASE("json: whole number within its bounds -> the number, and any other value -> an error that names the field") {
  const Json json = parse_json(R"({"seed":18446744073709551615,"low":-3,"half":0.5,"huge":1e300,"text":"7"})");
  CHECK(whole_number<std::uint64_t>(json, "seed") == 18446744073709551615u);
  CHECK(whole_number<int>(json, "low") == -3);
  CHECK_THROWS_AS(static_cast<void>(whole_number<int>(json, "none")), Json::exception);
  const auto refusal = [&](const char* key) {
    return test::message_of<std::invalid_argument>([&] { static_cast<void>(whole_number<std::uint32_t>(json, key, 1, 9)); });
  };
  CHECK(refusal("seed") == "seed = 18446744073709551615: must be a whole number from 1 to 9");
  CHECK(refusal("low") == "low = -3: must be a whole number from 1 to 9");
  CHECK(refusal("half") == "half = 0.5: must be a whole number from 1 to 9");
  CHECK(refusal("huge") == "huge = 1e+300: must be a whole number from 1 to 9");
  CHECK(refusal("text") == "text = \"7\": must be a whole number from 1 to 9");
}
