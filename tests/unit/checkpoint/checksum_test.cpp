// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <boost/crc.hpp>
#include <string>
#include <string_view>
#include <trophic/support/checksum.hpp>
#include <trophic/support/rng.hpp>

using namespace trophic;

TEST_CASE("checksum: the digits 1 to 9 -> the check value of CRC-32, and no bytes -> 0") {
  CHECK(checksum("123456789") == 0xCBF43926U);
  CHECK(checksum("") == 0);
}

TEST_CASE("checksum: random bytes, in one piece or in two -> zlib's sum") {
  Rng rng{1, Stream::user};
  std::string bytes(1000, '\0');
  for (char& byte : bytes) byte = static_cast<char>(static_cast<unsigned char>(rng.uniform(0.0, 256.0)));
  boost::crc_32_type other;
  other.process_bytes(bytes.data(), bytes.size());
  CHECK(checksum(bytes) == other.checksum());
  for (const std::size_t cut : {std::size_t{0}, std::size_t{1}, std::size_t{500}, bytes.size()}) {
    CAPTURE(cut);
    CHECK(checksum(std::string_view{bytes}.substr(cut), checksum(std::string_view{bytes}.substr(0, cut))) == other.checksum());
  }
}
