// SPDX-License-Identifier: MIT
// The quick part of fuzzing: the corpus, and random changes of it, through every reader.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <fuzz/readers.hpp>
#include <iterator>
#include <string>
#include <trophic/io/recording.hpp>
#include <trophic/run/checkpoint/checkpoint_writer.hpp>
#include <trophic/support/rng.hpp>
#include <trophic/support/whole_file.hpp>
#include <vector>

namespace {

using namespace trophic;
using namespace trophic::test;

std::vector<std::string> corpus_of(const Reader& reader) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator{std::filesystem::path{CORPUS} / reader.name})
    files.push_back(entry);
  std::ranges::sort(files);
  std::vector<std::string> texts;
  for (const auto& path : files) {
    std::ifstream file{path, std::ios::binary};
    texts.emplace_back(std::istreambuf_iterator<char>{file}, std::istreambuf_iterator<char>{});
  }
  return texts;
}

/// Bytes flipped, removed, doubled or inserted from another place.
std::string changed(std::string text, const std::vector<std::string>& corpus, Rng& rng) {
  for (std::size_t changes = 1 + rng.index(4); changes > 0; --changes) {
    const std::size_t at = rng.index(text.size() + 1);
    const std::size_t length = rng.index(std::min<std::size_t>(64, text.size() - at) + 1);
    const std::string& other = corpus[rng.index(corpus.size())];
    const std::size_t from = rng.index(other.size() + 1);
    switch (rng.index(5)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(rng.index(256));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(at, length));
        break;
      case 3:
        text.insert(at, other.substr(from, rng.index(64)));
        break;
      default:
        text.insert(at, 1 + rng.index(3), "[]{}.,=\"'#\n\0-"[rng.index(13)]);
    }
  }
  return text;
}

}  // namespace

TEST_CASE("readers: any bytes -> read, or an error of one sentence") {
  constexpr std::size_t tries = 400;
  for (const Reader& reader : readers) {
    const auto corpus = corpus_of(reader);
    REQUIRE(!corpus.empty());
    CAPTURE(reader.name);
    for (std::size_t i = 0; i < corpus.size(); ++i) {
      CAPTURE(i);
      CHECK_NOTHROW(try_reader(reader, corpus[i]));
    }
    for (std::size_t i = 0; i < tries; ++i) {
      Rng rng{i, Stream::user};
      const std::string text = changed(corpus[rng.index(corpus.size())], corpus, rng);
      CAPTURE(i);
      CHECK_NOTHROW(try_reader(reader, text));
    }
  }
}

// fuzz_readers --no-skip -tc="write*" writes them again after a change of format.
TEST_CASE("write the corpus's binary files" * doctest::skip()) {
  auto ecology = fuzzed_ecology<rules::Released>();
  const auto place = [](std::string_view folder) { return std::filesystem::path{CORPUS} / folder / "released-200-s.bin"; };
  std::filesystem::remove(place("recording"));
  io::Recording recording{place("recording"), io::default_replay_hz};
  ecology.run_until(40.0, recording);
  ecology.run_until(200.0);
  const TemporaryFolder run;
  const auto moment_of = [&](Simulation& any) {
    checkpoint::write(run.path(), any, any.describe(200.0));
    return checkpoint::read_last(run.path());
  };
  const std::string ecology_bytes = moment_of(ecology).section(checkpoint::ecology_section);
  const auto write = [&](std::string_view folder, const std::string& bytes) {
    std::ofstream{place(folder), std::ios::binary} << bytes;
  };
  write("checkpoint", read_whole_file(run.path() / checkpoint::file_name));
  write("ecology", ecology_bytes);
  auto recruited = recruited_ecology();
  recruited.run_until(200.0);
  write("recruited", moment_of(recruited).section(checkpoint::ecology_section));
}

TEST_CASE("readers: each corpus -> at least one file is read to its end") {
  for (const Reader& reader : readers) {
    CAPTURE(reader.name);
    std::size_t read = 0;
    for (const std::string& text : corpus_of(reader)) {
      try {
        reader.read(text);
        ++read;
      } catch (const std::exception&) {  // counted below
      }
    }
    CHECK(read > 0);
  }
}
