// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>
#include <variant>

using namespace trophic;
using trophic::detail::member_count;

namespace {

enum class Colour { red, green };
struct None {};
struct One {
  double a = 1.0;
};
struct Plain {
  double a = 1.0;
  bool b = false;
  std::int64_t c = 3;
  Colour d = Colour::red;
  float e = 0.5F;
  unsigned char f = 0;
};
struct Nested {
  One a;
  Plain b;
  One c = {2.0};
};
struct Arrays {
  double a[4] = {};
  int b = 1;
  One c[2] = {};
  double d[2][3] = {};
  std::array<double, 5> e{};
};
struct OnlyArray {
  double a[3] = {};
};
struct Library {
  std::string a = "x";
  std::optional<double> b;
  std::optional<std::string> c;
  std::optional<Nested> d;
  std::vector<std::string> e;
  std::variant<int, double> f;
  std::function<int()> g;
  None h;
  None i;
};
struct Computed {
  std::uint64_t a = 1;
  One b = [] { return One{3.0}; }();
};
struct Derived : One {
  int b = 1;
};

template <class P>
bool lists_all() {
  return detail::members_of<P> == detail::fields_of<P> && detail::listed_once<P>();
}

struct TwiceByName {
  double a = 1.0;
  double b = 1.0;
  static constexpr auto fields() { return std::tuple{field("a", &TwiceByName::a), field("a", &TwiceByName::b)}; }
};
struct TwiceByMember {
  double a = 1.0;
  double b = 1.0;
  int c = 1;
  static constexpr auto fields() {
    return std::tuple{field("a", &TwiceByMember::a), field("c", &TwiceByMember::c), field("b", &TwiceByMember::a)};
  }
};
struct Forgotten {
  double a = 1.0;
  std::string b;
  static constexpr auto fields() { return std::tuple{field("a", &Forgotten::a)}; }
};

}  // namespace

TEST_CASE("member count: numbers, switches and enumerations -> counted") {
  CHECK(member_count<None>() == 0);
  CHECK(member_count<One>() == 1);
  CHECK(member_count<Plain>() == 6);
}

TEST_CASE("member count: nested aggregate or array of any rank -> one member") {
  CHECK(member_count<Nested>() == 3);
  CHECK(member_count<Arrays>() == 5);
  CHECK(member_count<OnlyArray>() == 1);
}

TEST_CASE("member count: library types, empty and computed members, bases -> counted") {
  CHECK(member_count<Library>() == 9);
  CHECK(member_count<Computed>() == 2);
  CHECK(member_count<Derived>() == 2);
}

TEST_CASE("member count: number missing or twice in fields() -> found") {
  CHECK(detail::members_of<Forgotten> == 2);
  CHECK(detail::fields_of<Forgotten> == 1);
  CHECK_FALSE(lists_all<Forgotten>());
  CHECK_FALSE(lists_all<TwiceByName>());
  CHECK_FALSE(lists_all<TwiceByMember>());
}

TEST_CASE("member count: all Params in manifests -> every number listed") {
  CHECK(lists_all<EcologyParams>());
  CHECK(lists_all<Physics>());
  CHECK(lists_all<backend::Kinematic::Params>());
  CHECK(lists_all<RuleParams<rules::Paper>>());
  CHECK(lists_all<RuleParams<rules::Released>>());
  CHECK(lists_all<Experiment<rules::Paper>>());
}
