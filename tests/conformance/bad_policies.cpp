// SPDX-License-Identifier: MIT
// Rules that fit their contract and break what it means: each must fail its suite. CMakeLists.txt runs them one by one.
#include <conformance/control_suite.hpp>
#include <conformance/death_suite.hpp>
#include <conformance/perception_suite.hpp>
#include <conformance/reproduction_suite.hpp>
#include <random>

namespace {

using namespace trophic;

/// Its number changes nothing.
struct ForgetsItsNumber {
  static constexpr std::string_view name = "forgets_its_number";
  struct Params {
    double max_age_s = 100.0;
    static constexpr auto fields() { return std::tuple{field("max_age_s", &Params::max_age_s, above(0.0), "age at death")}; }
  };
  Params params;
  [[nodiscard]] bool dies(const Individual& individual, const View& view, Rng&) const { return view.age_s(individual) > 100.0; }
};

/// Counts how often it was asked.
struct CountsSecretly {
  static constexpr std::string_view name = "counts_secretly";
  [[nodiscard]] bool dies(const Individual&, const View&, Rng&) const {
    static int asked = 0;
    return ++asked % 2 == 0;
  }
};

/// Draws from an engine of its own.
struct DrawsElsewhere {
  static constexpr std::string_view name = "draws_elsewhere";
  [[nodiscard]] bool dies(const Individual&, const View&, Rng&) const {
    static std::mt19937 engine{1};
    return engine() % 3 == 0;
  }
};

/// The east of the world is deadly: its rule changes when the world is turned.
struct FearsTheEast {
  static constexpr std::string_view name = "fears_the_east";
  [[nodiscard]] death::Activates activates(BodyIndex body, const View& view) const {
    return view.poses[body].x_m > 0.0 ? death::Activates::yes : death::Activates::no;
  }
};

/// The north is, which a quarter turn and a mirror show.
struct LikesOneHand {
  static constexpr std::string_view name = "likes_one_hand";
  [[nodiscard]] bool is_exempt(BodyIndex hunter, const View& view, const perception::Perceives&) const {
    return view.poses[hunter].heading_rad > 0.0;
  }
};

/// Favours individuals in odd bodies: changes when robots change places.
struct FavoursOddBodies {
  static constexpr std::string_view name = "favours_odd_bodies";
  [[nodiscard]] death::Activates activates(BodyIndex body, const View&) const {
    return body % 2 == 1 ? death::Activates::yes : death::Activates::no;
  }
};

/// Reads a meaning into an id.
struct FavoursOddIds {
  static constexpr std::string_view name = "favours_odd_ids";
  [[nodiscard]] bool dies(const Individual& individual, const View&, Rng&) const { return individual.id % 2 == 1; }
};

/// Distinguishes left from right by the world, not by the robot.
struct SensesTheWorld {
  static constexpr std::string_view name = "senses_the_world";
  static constexpr std::size_t size = 1;
  [[nodiscard]] std::array<double, size> sense(BodyIndex self, const std::optional<Sighting>&, const View& view, Rng&) const {
    return {view.poses[self].y_m / 20.0};
  }
};

/// The parent is the individual in the first body.
struct FirstBodyIsParent {
  static constexpr std::string_view name = "first_body_is_parent";
  [[nodiscard]] std::optional<Ancestor> parent(const reproduction::Vacancy&, const View& view, Rng&) const {
    if (view.robots.empty()) return std::nullopt;
    const Individual& first = view.robots.front();
    return Ancestor{.id = first.id, .species = first.species, .genome = first.genome};
  }
};

/// Catches the individual in the first body that can be caught.
struct CatchesTheFirstBody {
  static constexpr std::string_view name = "catches_the_first_body";
  [[nodiscard]] std::vector<death::Capture> captures(const View& view, Rng&) const {
    for (BodyIndex victim = 0; victim < view.robots.size(); ++victim) {
      for (BodyIndex hunter = 0; hunter < view.robots.size(); ++hunter) {
        const bool eats = view.web.eats(view.robots[hunter].species, view.robots[victim].species);
        if (eats && view.robots[victim].active) return {{hunter, victim}};
      }
    }
    return {};
  }
};

/// Draws whom it gives up, but never from the second half of the bodies.
struct SacrificesTheFirstHalf {
  static constexpr std::string_view name = "sacrifices_the_first_half";
  [[nodiscard]] std::vector<death::Sacrifice> sacrifices(const View& view, Rng& rng) const {
    if (view.robots.empty()) return {};
    const BodyIndex victim = rng.index((view.robots.size() + 1) / 2);
    for (Species successor = 0; successor < view.web.size(); ++successor) {
      if (view.web.eats(successor, view.robots[victim].species)) return {{victim, successor}};
    }
    return {};
  }
};

/// Lets one individual starve twice.
struct StarvesTwice {
  static constexpr std::string_view name = "starves_twice";
  [[nodiscard]] death::Starving starving(const View& view, const perception::Perceives&) const {
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      if (view.web.hunts(view.robots[body].species)) return {.victims = {body, body}, .exempt = {}};
    }
    return {};
  }
};

/// Every other time it says otherwise.
struct ChoosesNowAndThen {
  static constexpr std::string_view name = "chooses_now_and_then";
  [[nodiscard]] reproduction::Descent descent(Rng&) const {
    static bool random = false;
    random = !random;
    return random ? reproduction::Descent::random : reproduction::Descent::of_parent;
  }
};

}  // namespace

TEST_CASE_TEMPLATE_INVOKE(trophic_senescence_suite, ForgetsItsNumber, CountsSecretly, DrawsElsewhere, FavoursOddIds);
TEST_CASE_TEMPLATE_INVOKE(trophic_activation_suite, FearsTheEast, FavoursOddBodies);
TEST_CASE_TEMPLATE_INVOKE(trophic_capture_suite, CatchesTheFirstBody);
TEST_CASE_TEMPLATE_INVOKE(trophic_minimum_predators_suite, SacrificesTheFirstHalf);
TEST_CASE_TEMPLATE_INVOKE(trophic_starvation_exemption_suite, LikesOneHand);
TEST_CASE_TEMPLATE_INVOKE(trophic_starvation_suite, StarvesTwice);
TEST_CASE_TEMPLATE_INVOKE(trophic_sensor_suite, SensesTheWorld);
TEST_CASE_TEMPLATE_INVOKE(trophic_parent_suite, FirstBodyIsParent);
TEST_CASE_TEMPLATE_INVOKE(trophic_genome_source_suite, ChoosesNowAndThen);
