// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <support/temporary_folder.hpp>
#include <trophic/params/archive.hpp>
#include <trophic/population/individual.hpp>

namespace {

using namespace trophic;
using test::message_of;

struct Inner {
  int count = 0;
  std::optional<double> maybe;
  bool operator==(const Inner&) const = default;
  static constexpr auto fields() {
    return std::tuple{field("count", &Inner::count, any_number()), field("maybe", &Inner::maybe)};
  }
};

struct Everything {
  bool on = false;
  std::uint64_t large = 0;
  double number = 0.0;
  Origin origin = Origin::random;
  std::string text;
  std::vector<double> numbers;
  std::vector<bool> switches;
  std::vector<Inner> inner;
  std::array<int, 3> three{};
  std::pair<std::string, std::optional<Inner>> pair;
  bool operator==(const Everything&) const = default;
  static constexpr auto saved() {
    return std::tuple{&Everything::on,      &Everything::large,    &Everything::number, &Everything::origin, &Everything::text,
                      &Everything::numbers, &Everything::switches, &Everything::inner,  &Everything::three,  &Everything::pair};
  }
};

/// With private members.
class Counter {
 public:
  explicit Counter(int value = 0) : value_{value} {}
  void persist(Archive& archive) { archive(value_); }
  [[nodiscard]] int value() const { return value_; }

 private:
  int value_;
};

struct Unsavable {
  int* pointer = nullptr;
};
static_assert(Savable<Everything> && Savable<Counter> && Savable<Individual> && Savable<std::vector<std::optional<Ancestor>>>);
static_assert(!Savable<Unsavable> && !Savable<std::vector<Unsavable>> && !Savable<int*>);

Everything full() {
  return {.on = true,
          .large = std::numeric_limits<std::uint64_t>::max(),
          .number = 0.1,
          .origin = Origin::inherited,
          .text = std::string{"a\0b", 3},
          .numbers = {1.5, -0.0, 1e308},
          .switches = {true, false, true},
          .inner = {{1, 2.5}, {2, {}}},
          .three = {7, 8, 9},
          .pair = {"p", Inner{3, -1.0}}};
}

template <class T>
std::string bytes_of(T value) {
  Archive archive;
  archive(value);
  return archive.bytes();
}

template <class T>
T read(std::string_view bytes) {
  T value{};
  Archive archive{bytes};
  archive(value);
  archive.finish();
  return value;
}

}  // namespace

TEST_CASE("archive: every type that can be saved -> the same bits") {
  CHECK(read<Everything>(bytes_of(full())) == full());
  CHECK(read<Everything>(bytes_of(Everything{})) == Everything{});
  CHECK(std::signbit(read<Everything>(bytes_of(full())).numbers[1]));
  CHECK(std::isnan(read<double>(bytes_of(std::nan("")))));
  CHECK(read<Counter>(bytes_of(Counter{12})).value() == 12);
}

TEST_CASE("archive: list of empty elements -> the same length") {
  struct Nothing {};
  CHECK(read<std::vector<Nothing>>(bytes_of(std::vector<Nothing>(5))).size() == 5);
}

TEST_CASE("archive: reading into a filled object -> its old content is replaced") {
  const std::string bytes = bytes_of(Everything{});
  Everything value = full();
  Archive archive{bytes};
  archive(value);
  CHECK(value == Everything{});
}

TEST_CASE("archive: shared pointers to one object -> written once and shared again") {
  const auto genome = std::make_shared<Genome>(Genome{.id = 4, .weights = std::vector<double>(100, 0.5)});
  const std::vector<std::shared_ptr<Genome>> before{genome, nullptr, genome, std::make_shared<Genome>(*genome)};
  const std::string bytes = bytes_of(before);
  CHECK(bytes.size() < 3 * 100 * sizeof(double));
  const auto after = read<std::vector<std::shared_ptr<Genome>>>(bytes);
  REQUIRE(after.size() == 4);
  CHECK(after[0] == after[2]);
  CHECK(after[1] == nullptr);
  CHECK(after[3] != after[0]);
  CHECK(after[3]->weights == genome->weights);
  CHECK(after[3]->id == 4);
}

TEST_CASE("archive: bytes cut at any length -> refused, without allocating the length that they claim") {
  const std::string bytes = bytes_of(full());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    CAPTURE(length);
    CHECK_THROWS_AS(static_cast<void>(read<Everything>(std::string_view{bytes}.substr(0, length))), std::invalid_argument);
  }
  CHECK(message_of<std::invalid_argument>([&] { static_cast<void>(read<Everything>(bytes + "x")); }) == "1 bytes too many");
  const std::string claims = bytes_of(std::uint64_t{1} << 60U);
  CHECK_THROWS_AS(static_cast<void>(read<std::vector<double>>(claims)), std::invalid_argument);
  CHECK_THROWS_AS(static_cast<void>(read<std::vector<Inner>>(claims)), std::invalid_argument);
  CHECK_THROWS_AS(static_cast<void>(read<std::string>(claims)), std::invalid_argument);
}

TEST_CASE("archive: values that do not exist -> refused") {
  CHECK_THROWS_AS(static_cast<void>(read<bool>("\x02")), std::invalid_argument);
  CHECK_THROWS_AS(static_cast<void>(read<Origin>(bytes_of(std::int32_t{2}))), std::invalid_argument);
  CHECK_THROWS_AS(static_cast<void>(read<Origin>(bytes_of(std::int32_t{-1}))), std::invalid_argument);
  CHECK_THROWS_AS(static_cast<void>(read<std::shared_ptr<Genome>>(bytes_of(std::uint64_t{2}))), std::invalid_argument);
}
