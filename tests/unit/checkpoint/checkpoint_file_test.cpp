// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <sys/resource.h>

#include <cstddef>
#include <exception>
#include <support/temporary_folder.hpp>
#include <trophic/run/checkpoint/checkpoint_file.hpp>
#include <trophic/run/checkpoint/resume.hpp>
#include <trophic/support/unreadable_file.hpp>
#include <trophic/support/whole_file.hpp>
#include <vector>

namespace {

using namespace trophic;
using test::message_of;
using test::TemporaryFolder;

checkpoint::Checkpoint moment(std::int64_t tick) {
  return {.fingerprint = "0123456789abcdef",
          .program_version = "0.1.0",
          .seed = 7,
          .tick = tick,
          .time_s = 2.0 * static_cast<double>(tick),
          .sections = {{"ecology", std::string(50, '\0')}, {"files", "abc"}}};
}

std::string bytes_of(const checkpoint::Checkpoint& moment, const checkpoint::Parts& parts = {}) {
  const TemporaryFolder folder;
  checkpoint::write(folder.path(), moment, parts);
  return read_whole_file(folder.path() / checkpoint::file_name);
}

}  // namespace

TEST_CASE("checkpoint file: written -> reads back, and cut or changed in any byte -> refused") {
  const std::string bytes = bytes_of(moment(5));
  const auto back = checkpoint::from_bytes(bytes, "it");
  CHECK(back.tick == 5);
  CHECK(back.time_s == 10.0);
  CHECK(back.seed == 7);
  CHECK(back.section("files") == "abc");
  CHECK(message_of<std::invalid_argument>([&] {
          static_cast<void>(back.section("replay"));
        }).starts_with("the checkpoint has no section \"replay\""));
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    CAPTURE(i);
    CHECK_THROWS_AS(static_cast<void>(checkpoint::from_bytes(std::string_view{bytes}.substr(0, i), "it")), std::invalid_argument);
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    CHECK_THROWS_AS(static_cast<void>(checkpoint::from_bytes(changed, "it")), std::invalid_argument);
  }
}

TEST_CASE("checkpoint file: sections written in pieces -> the bytes of whole ones") {
  std::vector<double> numbers(20'000, 0.1);
  std::vector<std::string> texts(20'000, "more than a piece");
  const checkpoint::Parts parts{{"ecology", [&](Archive& archive) { archive(texts, numbers, texts); }},
                                {"nothing", [](Archive&) {}},
                                {"files", [&](Archive& archive) { archive(numbers); }}};
  checkpoint::Checkpoint whole = moment(5);
  for (const checkpoint::Part& part : parts) {
    Archive archive;
    part.persist(archive);
    whole.sections.push_back({std::string{part.section}, archive.bytes()});
  }
  CHECK(bytes_of(moment(5), parts) == bytes_of(whole));
}

TEST_CASE("checkpoint file: missing, of another format or version -> errors name the file and its fault") {
  const auto refusal = [](const std::string& bytes) {
    return message_of<std::invalid_argument>([&] { static_cast<void>(checkpoint::from_bytes(bytes, "x.bin")); });
  };
  const std::string bytes = bytes_of(moment(5));
  CHECK(refusal("") == "x.bin: is not a checkpoint of trophic");
  CHECK(refusal("trophic checkpoint\n12") == "x.bin: is cut short");
  CHECK(refusal(bytes + "x") == "x.bin: is cut short or damaged: its checksum is another");
  std::string newer = bytes;
  newer[19] = 8;
  CHECK(refusal(newer) == "x.bin: has format 8, of a newer version of trophic: must be 7, as this program writes");
}

TEST_CASE("checkpoint file: missing or damaged -> its predecessor is read") {
  const TemporaryFolder folder;
  CHECK_FALSE(checkpoint::exists(folder.path()));
  CHECK_THROWS_AS(static_cast<void>(checkpoint::read_last(folder.path())), std::invalid_argument);
  checkpoint::write(folder.path(), moment(1));
  CHECK(checkpoint::read_last(folder.path()).tick == 1);
  checkpoint::write(folder.path(), moment(2));
  checkpoint::write(folder.path(), moment(3));
  CHECK(checkpoint::read_last(folder.path()).tick == 3);
  CHECK(checkpoint::read_all(folder.path()).size() == 2);
  CHECK(checkpoint::read_all(folder.path())[1].tick == 2);

  std::filesystem::resize_file(folder.path() / checkpoint::file_name, 30);
  CHECK(checkpoint::read_last(folder.path()).tick == 2);
  // The damaged one must not take the whole one's place when the next is written.
  checkpoint::write(folder.path(), moment(4));
  CHECK(checkpoint::read_all(folder.path()).size() == 2);
  CHECK(checkpoint::read_all(folder.path())[1].tick == 2);

  std::filesystem::remove(folder.path() / checkpoint::file_name);
  CHECK(checkpoint::exists(folder.path()));
  CHECK(checkpoint::read_last(folder.path()).tick == 2);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "checkpoint.bin.part"));
}

TEST_CASE("checkpoint file: the system refuses to read it -> error with its reason, and nothing is removed") {
  const TemporaryFolder folder;
  checkpoint::write(folder.path(), moment(1));
  checkpoint::write(folder.path(), moment(2));
  rlimit before{};
  REQUIRE(::getrlimit(RLIMIT_NOFILE, &before) == 0);
  const rlimit none{.rlim_cur = 0, .rlim_max = before.rlim_max};
  // Read after the limit is lifted: the sanitizer of types opens a pipe before it looks at an exception.
  std::vector<std::exception_ptr> errors;
  const auto refused = [&](auto&& read) {
    try {
      read();
    } catch (...) {
      errors.push_back(std::current_exception());
    }
  };
  REQUIRE(::setrlimit(RLIMIT_NOFILE, &none) == 0);
  refused([&] { static_cast<void>(checkpoint::read_last(folder.path())); });
  refused([&] { static_cast<void>(checkpoint::read_all(folder.path())); });
  refused([&] { static_cast<void>(checkpoint::status_of(folder.path())); });
  REQUIRE(::setrlimit(RLIMIT_NOFILE, &before) == 0);
  CHECK(errors.size() == 3);
  for (const std::exception_ptr& error : errors)
    CHECK(message_of<UnreadableFile>([&] { std::rethrow_exception(error); }).ends_with(": cannot be read: Too many open files"));
  CHECK(checkpoint::read_last(folder.path()).tick == 2);
  CHECK(checkpoint::read_all(folder.path()).size() == 2);
}
