// SPDX-License-Identifier: MIT
// Each rule draws from its own stream: what one draws never shifts what another gets.
#include <doctest/doctest.h>

#include <support/recorder.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/perception/newborn_tag/random_tag.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

using namespace trophic;

namespace {

void draw_three(Rng& rng) {
  for (int i = 0; i < 3; ++i) rng.bits();
}

/// The policy, which then draws three numbers more than it needs.
struct WastefulPlacement : initialization::placement::UniformSquare {
  [[nodiscard]] std::vector<GroundPose> place(std::size_t robots, const Arena& arena, double radius_m, Rng& rng) const {
    auto placed = UniformSquare::place(robots, arena, radius_m, rng);
    draw_three(rng);
    return placed;
  }
};
struct WastefulTag : perception::newborn_tag::RandomTag {
  [[nodiscard]] int tag(std::optional<int> body_tag, std::span<const int> tags, Rng& rng) const {
    const int drawn = RandomTag::tag(body_tag, tags, rng);
    draw_three(rng);
    return drawn;
  }
};
struct WastefulWeights : reproduction::initial_genome::UniformWeights {
  void draw(std::span<double> weights, Rng& rng) const {
    UniformWeights::draw(weights, rng);
    draw_three(rng);
  }
};
struct WastefulSource : reproduction::genome_source::RandomOrInherited {
  [[nodiscard]] reproduction::Descent descent(Rng& rng) const {
    const reproduction::Descent drawn = RandomOrInherited::descent(rng);
    draw_three(rng);
    return drawn;
  }
};
struct WastefulMutation : reproduction::mutation::NormalMutation {
  void mutate(std::span<double> weights, const Individual& offspring, Rng& rng) const {
    NormalMutation::mutate(weights, offspring, rng);
    draw_three(rng);
  }
};
struct WastefulCapture : death::capture::CatchClosest {
  [[nodiscard]] std::vector<death::Capture> captures(const View& view, Rng& rng) const {
    auto drawn = CatchClosest::captures(view, rng);
    draw_three(rng);
    return drawn;
  }
};
struct WastefulMinimum : death::minimum_predators::SacrificeRandomVictim {
  [[nodiscard]] std::vector<death::Sacrifice> sacrifices(const View& view, Rng& rng) const {
    auto drawn = SacrificeRandomVictim::sacrifices(view, rng);
    draw_three(rng);
    return drawn;
  }
};
struct WastefulParent : reproduction::parent::NearestActiveVictim {
  [[nodiscard]] std::optional<Ancestor> parent(const reproduction::Vacancy& vacancy, const View& view, Rng& rng) const {
    draw_three(rng);
    return NearestActiveVictim::parent(vacancy, view, rng);
  }
};
/// Draws three numbers first, so that its own mutations are others.
struct OtherMutation : reproduction::mutation::NormalMutation {
  void mutate(std::span<double> weights, const Individual& offspring, Rng& rng) const {
    draw_three(rng);
    NormalMutation::mutate(weights, offspring, rng);
  }
};

/// Sees seven of ten of its tag.
struct Haze : perception::visibility::SameTag {
  static constexpr std::string_view name = "haze";
  [[nodiscard]] bool perceives(BodyIndex self, BodyIndex other, const View& view, Rng& rng) const {
    return rng.chance(0.7) && SameTag::perceives(self, other, view, rng);
  }
};
struct WastefulHaze : Haze {
  [[nodiscard]] bool perceives(BodyIndex self, BodyIndex other, const View& view, Rng& rng) const {
    const bool seen = Haze::perceives(self, other, view, rng);
    draw_three(rng);
    return seen;
  }
};

/// Paper with every rule that draws random numbers doing so at each chance.
using Frugal = with_visibility<
    with_placement<with_newborn_tag<with_capture<rules::Paper, death::capture::CatchClosest>, perception::newborn_tag::RandomTag>,
                   initialization::placement::UniformSquare>,
    Haze>;

using WastefulLife = with_visibility<
    with_placement<
        with_newborn_tag<with_capture<with_minimum_predators<rules::Paper, WastefulMinimum>, WastefulCapture>, WastefulTag>,
        WastefulPlacement>,
    WastefulHaze>;
using Wasteful = with_initial_genome<
    with_genome_source<with_parent_after<with_mutation<WastefulLife, WastefulMutation>, Cause::starved, WastefulParent>,
                       WastefulSource>,
    WastefulWeights>;
using Other = with_mutation<Frugal, OtherMutation>;

template <class Rules>
test::Recorder record(double until_s) {
  typename Ecology<Rules>::Params params{.seed = 21};
  params.rules.minimum_predators.below = 12;  // many sacrifices
  params.rules.capture.min_age_s = 4.0;
  Ecology<Rules> ecology{std::move(params), backend::Kinematic::Params{}};
  test::Recorder recorder;
  ecology.run_until(until_s, recorder);
  return recorder;
}

}  // namespace

TEST_CASE("random streams: rules with extra draws -> same bits") {
  const test::Recorder frugal = record<Frugal>(2000.0);
  CHECK(frugal.all == record<Wasteful>(2000.0).all);
  int sacrificed = 0;
  int caught = 0;
  for (const std::string& line : frugal.events) {
    sacrificed += line.find("sacrificed") != std::string::npos ? 1 : 0;
    caught += line.find("caught") != std::string::npos ? 1 : 0;
  }
  CHECK(sacrificed > 10);
  CHECK(caught > 10);
}

TEST_CASE("random streams: another mutation -> same draws up to the first inherited birth") {
  const test::Recorder frugal = record<Frugal>(2000.0);
  const test::Recorder other = record<Other>(2000.0);
  CHECK(frugal.all != other.all);
  std::size_t first = 0;
  while (frugal.all[first].find(" inherited ") == std::string::npos) ++first;
  REQUIRE(first > 30);
  for (std::size_t line = 0; line < first; ++line) CHECK(frugal.all[line] == other.all[line]);
  // the birth itself: same tick, body, number, tag, genome and parent, and only the weights that follow differ
  const auto head = [](const std::string& line) { return line.substr(0, line.find(" ", line.find("parent ") + 7)); };
  CHECK(head(frugal.all[first]) == head(other.all[first]));
  CHECK(frugal.all[first] != other.all[first]);
}

TEST_CASE("random streams: noisy visibility -> depends on the pair and the tick, not on the search order") {
  using Rules = with_visibility<rules::Paper, Haze>;
  struct Check {
    void on_tick(const View& view) {
      for (BodyIndex self = 0; self < view.robots.size(); ++self) {
        std::optional<BodyIndex> closest;
        for (BodyIndex other = 0; other < view.robots.size(); ++other) {
          Rng rng{12, Stream::visibility, view.robots[self].id, static_cast<std::uint64_t>(view.tick), view.robots[other].id};
          if (!view.web.opponents(view.robots[self].species, view.robots[other].species)) continue;
          if (!Haze{}.perceives(self, other, view, rng)) continue;
          if (!closest || view.distance_m(self, other) < view.distance_m(self, *closest)) closest = other;
        }
        CHECK(view.robots[self].adversary == closest);
        if (closest) ++seen;
      }
    }
    std::size_t seen = 0;
  } check;
  Ecology<Rules>::Params params{.seed = 12};
  params.ecology.robots = 80;  // so many are searched on a grid
  params.rules.tag_switch.cool_down_s = 1e6;
  Ecology<Rules> ecology{params, backend::Kinematic::Params{}};
  ecology.run_until(60.0, check);
  CHECK(check.seen > 1000);
}
