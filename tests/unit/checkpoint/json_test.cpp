// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <string>
#include <trophic/support/json.hpp>

using namespace trophic;

TEST_CASE("JSON comes back as it was written, keys in their order") {
  const std::string text = R"({"until_s":600.0,"seed":18446744073709551615,"food_web":[{"hunter":"predator"}],"error":null})";
  CHECK(json_text(parse_json(text)) == text);
  CHECK(json_text(parse_json(R"({"b":1,"a":2})"), 2) == "{\n  \"b\": 1,\n  \"a\": 2\n}");
}

TEST_CASE("what is no JSON throws, or is null") {
  for (const char* text : {"", "{", R"({"a":})", "{} {}", "\xff"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(static_cast<void>(parse_json(text)), Json::exception);
    CHECK(parse_json_or_null(text).is_null());
  }
  CHECK(parse_json_or_null("[]").is_array());
}
