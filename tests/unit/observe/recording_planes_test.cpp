// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>
#include <trophic/io/recording_planes.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

using namespace trophic;
using io::recording::Effort;
using io::recording::packed;
using io::recording::unpacked;

TEST_CASE("recording planes: any frames -> read back column by column") {
  Rng rng{3, Stream::user};
  for (const std::size_t columns : {1U, 7U, 42U}) {
    for (const std::size_t frames : {1U, 2U, 100U}) {
      std::vector<std::int16_t> values(columns * frames);
      for (std::int16_t& value : values) value = static_cast<std::int16_t>(rng.bits());
      const std::vector<std::int16_t> back = unpacked(packed(values, columns), columns, frames);
      REQUIRE(back.size() == values.size());
      CHECK(unpacked(packed(values, columns, Effort::fast), columns, frames) == back);
      for (std::size_t frame = 0; frame < frames; ++frame) {
        for (std::size_t column = 0; column < columns; ++column) {
          REQUIRE(back[column * frames + frame] == values[frame * columns + column]);
        }
      }
    }
  }
}

TEST_CASE("recording planes: bytes of other frames, or cut -> error") {
  const std::string bytes = packed(std::vector<std::int16_t>(60, 5), 6);
  CHECK_THROWS_AS(static_cast<void>(unpacked(bytes, 6, 11)), std::invalid_argument);
  CHECK_THROWS_AS(static_cast<void>(unpacked(bytes, 6, 9)), std::invalid_argument);
  CHECK_THROWS_AS(static_cast<void>(unpacked(bytes.substr(0, bytes.size() - 3), 6, 10)), std::invalid_argument);
  CHECK_THROWS_AS(static_cast<void>(unpacked("", 6, 10)), std::invalid_argument);
}
