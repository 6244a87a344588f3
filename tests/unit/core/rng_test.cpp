// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <Random123/philox.h>

#include <support/statistics.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

using namespace trophic;

namespace {

using Block = std::array<std::uint64_t, 4>;

Block next_block(Rng& rng) {
  Block block{};
  for (std::uint64_t& word : block) word = rng.bits();
  return block;
}

}  // namespace

TEST_CASE("rng: philox4x64 with 10 rounds -> known answers") {
  const auto answer = [](const Block& counter, const std::array<std::uint64_t, 2>& key) {
    r123::Philox4x64::ctr_type c = {{counter[0], counter[1], counter[2], counter[3]}};
    r123::Philox4x64::key_type k = {{key[0], key[1]}};
    const auto out = r123::Philox4x64{}(c, k);
    return Block{out[0], out[1], out[2], out[3]};
  };
  constexpr std::uint64_t ones = ~std::uint64_t{0};
  CHECK(answer({0, 0, 0, 0}, {0, 0}) == Block{0x16554d9eca36314c, 0xdb20fe9d672d0fdc, 0xd7e772cee186176b, 0x7e68b68aec7ba23b});
  CHECK(answer({ones, ones, ones, ones}, {ones, ones}) ==
        Block{0x87b092c3013fe90b, 0x438c3c67be8d0224, 0x9cc7d7c69cd777b6, 0xa09caebf594f0ba0});
  CHECK(answer({0x243f6a8885a308d3, 0x13198a2e03707344, 0xa4093822299f31d0, 0x082efa98ec4e6c89},
               {0x452821e638d01377, 0xbe5466cf34e90c6c}) ==
        Block{0xa528f45403e61d95, 0x38c72dbd566e9788, 0xa5a1610e72fd18b5, 0x57bd43b5e52b7fe6});
}

TEST_CASE("rng: seed and purpose -> key, block, individual and event -> counter") {
  Rng zero{0, Stream::placement};
  CHECK(next_block(zero) == Block{0x16554d9eca36314c, 0xdb20fe9d672d0fdc, 0xd7e772cee186176b, 0x7e68b68aec7ba23b});
  Rng rng{0x452821e638d01377, Stream::mutation, 17, 23};
  for (std::uint64_t block = 0; block < 3; ++block) {
    const r123::Philox4x64::ctr_type counter = {{block, 17, 23, 0}};
    const r123::Philox4x64::key_type key = {{0x452821e638d01377, static_cast<std::uint64_t>(Stream::mutation)}};
    const auto out = r123::Philox4x64{}(counter, key);
    CHECK(next_block(rng) == Block{out[0], out[1], out[2], out[3]});
  }
}

TEST_CASE("rng: another seed, purpose, individual or event -> another stream") {
  const auto first = [](std::uint64_t seed, Stream purpose, std::uint64_t individual, std::uint64_t event) {
    return Rng{seed, purpose, individual, event}.bits();
  };
  const std::uint64_t bits = first(1, Stream::parent, 2, 3);
  CHECK(first(1, Stream::parent, 2, 3) == bits);
  CHECK(first(2, Stream::parent, 2, 3) != bits);
  CHECK(first(1, Stream::mutation, 2, 3) != bits);
  CHECK(first(1, Stream::parent, 3, 3) != bits);
  CHECK(first(1, Stream::parent, 2, 4) != bits);
  CHECK(first(1, Stream::parent, 3, 2) != bits);
}

TEST_CASE("rng: extra draw in one stream -> others unchanged, copies -> independent") {
  Rng undisturbed{5, Stream::captures};
  Rng disturbed{5, Stream::captures};
  Rng other{5, Stream::sacrifice};
  for (int i = 0; i < 50; ++i) {
    for (int extra = 0; extra < i; ++extra) other.normal(0.0, 1.0);
    CHECK(disturbed.bits() == undisturbed.bits());
  }
  Rng copy = undisturbed;
  CHECK(copy.bits() == undisturbed.bits());
  copy.bits();
  Rng again{5, Stream::captures};
  for (int i = 0; i < 51; ++i) again.bits();
  CHECK(undisturbed.bits() == again.bits());
}

TEST_CASE("rng: uniform numbers -> multiples of 2^-53 in at least 0, below 1") {
  Rng rng{6, Stream::user};
  Rng bits{6, Stream::user};
  std::vector<double> drawn(500'000);
  for (double& x : drawn) {
    x = rng.uniform();
    REQUIRE(x == static_cast<double>(bits.bits() >> 11) * 0x1.0p-53);
  }
  const test::Moments moments = test::moments(drawn);
  const double sd = 1.0 / std::sqrt(12.0);
  CHECK(std::abs(moments.mean - 0.5) < 4.0 * sd / std::sqrt(500'000.0));
  CHECK(std::abs(moments.sd / sd - 1.0) < 4.0 * std::sqrt(0.8 / 2'000'000.0));
  CHECK(moments.smallest >= 0.0);
  CHECK(moments.largest < 1.0);
  CHECK(test::chi_square(test::histogram(drawn, 0.0, 1.0, 100)) < 158.0);  // 99 degrees of freedom: p = 1e-4
  double serial = 0.0;
  for (std::size_t i = 1; i < drawn.size(); ++i) serial += (drawn[i] - 0.5) * (drawn[i - 1] - 0.5) * 12.0 / 500'000.0;
  CHECK(std::abs(serial) < 4.0 / std::sqrt(500'000.0));
}

TEST_CASE("rng: normal numbers -> moments and tails of a normal distribution") {
  Rng rng{7, Stream::user};
  std::vector<double> drawn(500'000);
  std::size_t beyond_two = 0;
  for (double& x : drawn) {
    x = rng.normal(3.0, 2.0);
    if (std::abs(x - 3.0) > 4.0) ++beyond_two;
  }
  const test::Moments moments = test::moments(drawn);
  CHECK(std::abs(moments.mean - 3.0) < 4.0 * 2.0 / std::sqrt(500'000.0));
  CHECK(std::abs(moments.sd / 2.0 - 1.0) < 4.0 / std::sqrt(1'000'000.0));
  CHECK(std::abs(moments.skewness) < 4.0 * std::sqrt(6.0 / 500'000.0));
  CHECK(std::abs(moments.kurtosis - 3.0) < 4.0 * std::sqrt(24.0 / 500'000.0));
  CHECK(static_cast<double>(beyond_two) / 500'000.0 == doctest::Approx(0.0455003).epsilon(0.03));
}

TEST_CASE("rng: index -> uniform below its size, chance -> given probability") {
  Rng rng{8, Stream::user};
  std::vector<std::size_t> counts(7, 0);
  for (int i = 0; i < 70'000; ++i) ++counts.at(rng.index(7));
  CHECK(test::chi_square(counts) < 27.9);  // 6 degrees of freedom: p = 1e-4
  CHECK(rng.index(1) == 0);
  int hits = 0;
  for (int i = 0; i < 100'000; ++i) hits += rng.chance(0.3) ? 1 : 0;
  CHECK(hits == doctest::Approx(30'000).epsilon(4.0 * std::sqrt(0.7 / 30'000.0)));
  for (int i = 0; i < 1000; ++i) {
    CHECK_FALSE(rng.chance(0.0));
    CHECK(rng.chance(1.0));
  }
}

TEST_CASE("rng: shuffles of four items -> uniform over 24 orders") {
  Rng rng{9, Stream::user};
  std::vector<std::size_t> counts(256, 0);
  for (int i = 0; i < 48'000; ++i) {
    std::array<std::size_t, 4> items{0, 1, 2, 3};
    rng.shuffle(std::span<std::size_t>{items});
    ++counts.at(items[0] * 64 + items[1] * 16 + items[2] * 4 + items[3]);
  }
  std::erase(counts, std::size_t{0});
  REQUIRE(counts.size() == 24);
  CHECK(test::chi_square(counts) < 56.0);  // 23 degrees of freedom: p = 1e-4
}

TEST_CASE("rng: shuffle of n items -> n - 1 draws, of none or one -> none") {
  Rng rng{10, Stream::user};
  Rng reference = rng;
  std::vector<int> none;
  std::vector<int> one{7};
  rng.shuffle(std::span{none});
  rng.shuffle(std::span{one});
  CHECK(one.front() == 7);
  std::vector<int> five{1, 2, 3, 4, 5};
  rng.shuffle(std::span{five});
  for (int i = 0; i < 4; ++i) reference.bits();
  CHECK(rng.bits() == reference.bits());
}
