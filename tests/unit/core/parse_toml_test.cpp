// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <support/temporary_folder.hpp>
#include <trophic/params/parse_toml.hpp>

namespace {

using namespace trophic;
using test::message_of;
using test::TemporaryFolder;

std::string refusal(const std::string& text) {
  try {
    static_cast<void>(parse_toml(text));
  } catch (const TomlError& error) {
    return std::to_string(error.line()) + ":" + std::to_string(error.column()) + ": " + error.what();
  }
  return "";
}

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

}  // namespace

TEST_CASE("parse toml: valid TOML -> table") {
  const auto table = parse_toml(
      "\xEF\xBB\xBF# a \xCD\x8B comment\na.b = \"\xCD\x8B # no [comment\"\nc = [[1.5, 2.5], [3, 4]]\n'd.\"' = '''x\n[[[['''\n");
  CHECK(table["a"]["b"].value<std::string>() == "\xCD\x8B # no [comment");
  CHECK(table["c"][1][0].value<int>() == 3);
  CHECK(table["d.\""].value<std::string>() == "x\n[[[[");
}

TEST_CASE("parse toml: key of a million dots -> error without stack overflow") {
  CHECK(refusal("a" + repeated(".a", 1'000'000) + " = 1") == "1:64: a key of more than 32 parts");
  CHECK(refusal("[a" + repeated(" . a", 1'000'000) + "]") == "1:128: a key of more than 32 parts");
  CHECK(refusal("a" + repeated(".a", 30) + " = 1").empty());
}

TEST_CASE("parse toml: brackets nested a thousand deep -> error") {
  CHECK(refusal("a = " + repeated("[", 1000) + repeated("]", 1000)) == "1:69: brackets nested more than 64 levels deep");
  CHECK(
      refusal("a = " + repeated("{a=", 1000) + "1" + repeated("}", 1000)).ends_with("brackets nested more than 64 levels deep"));
  CHECK(refusal("a = " + repeated("[", 20) + repeated("]", 20)).empty());
}

TEST_CASE("parse toml: texts that crash or confuse toml++ 3.3.0 -> error") {
  CHECK_FALSE(refusal("[# a]").empty());
  CHECK_FALSE(refusal("[[# a]]").empty());
  CHECK(refusal("\n\xCD\x8B = 1") == "2:1: a non-ASCII character outside quotes");
  CHECK(refusal("a = \xCD\x8B") == "1:5: a non-ASCII character outside quotes");
  CHECK(refusal("a = \"\"\"x\"\"\"\" \xCD\x8B") == "1:14: a non-ASCII character outside quotes");
  CHECK(refusal("a = [\n+1=\"\xCD\x8B\"]") == "2:4: a quote in a word that begins with a digit or a sign");
  CHECK(refusal("a = 1979-05-27 0#\xCD\x8B") == "1:15: two numbers separated only by a space");
  CHECK(refusal("a = \"\"\"\\ \n \xCD\x8B\"\"\"") == "2:2: a non-ASCII character after a backslash");
  CHECK(refusal("a = \"\\\xCD\x8B\"") == "1:7: a non-ASCII character after a backslash");
}

TEST_CASE("parse toml: valid texts close to those -> table") {
  const auto table = parse_toml(
      "1 = \"\xCD\x8B\"\na.2.'\xCD\x8B' = [+1, 'b']\nc = \"\"\"\\\n d\xCD\x8B\\\\\xCD\x8B\"\"\"\"\"\ne = '''\xCD\x8B''''\n");
  CHECK(table["1"].value<std::string>() == "\xCD\x8B");
  CHECK(table["a"]["2"]["\xCD\x8B"][1].value<std::string>() == "b");
  CHECK(table["c"].value<std::string>() == "d\xCD\x8B\\\xCD\x8B\"\"");
  CHECK(table["e"].value<std::string>() == "\xCD\x8B'");
}

TEST_CASE("parse toml: text, line or key too long -> error") {
  CHECK(refusal("a = \"" + std::string(2'000'000, 'x') + "\"").ends_with("a line of more than 1 MiB"));
  CHECK(refusal(std::string(17'000'000, '\n')).ends_with("has 17000000 bytes: must be <= 16 MiB"));
}

TEST_CASE("parse toml: bad file -> error with name, line and column, pipe -> error without waiting") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.toml", "a = 1\nb = \n");
  CHECK(message_of<std::invalid_argument>([&] { static_cast<void>(parse_toml_file(path)); }).starts_with(path + ":2:"));
  const std::string pipe = (folder.path() / "pipe").string();
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(message_of<std::invalid_argument>([&] { static_cast<void>(parse_toml_file(pipe)); }) == pipe + ": is not a regular file");
}
