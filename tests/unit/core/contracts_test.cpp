// SPDX-License-Identifier: MIT
// Each contract takes what keeps it, and refuses a function that is missing, not const, of another result or of one argument
// more.
#include <doctest/doctest.h>

#include <trophic/death/starvation/choice/contract.hpp>
#include <trophic/death/starvation/exemption/contract.hpp>
#include <trophic/death/starvation/interval/contract.hpp>
#include <trophic/perception/sensors/contract.hpp>
#include <trophic/rules/slots.hpp>

// The functions are never defined, so they must not be anybody's own.
namespace trophic::refused_by_contracts {

struct Nonsense {};

struct Nothing {};

#define TROPHIC_REFUSES(label, Contract, rest, Result, function, ...)     \
  namespace label {                                                       \
  struct Keeps {                                                          \
    rest Result function(__VA_ARGS__) const;                              \
  };                                                                      \
  struct Changes {                                                        \
    rest Result function(__VA_ARGS__);                                    \
  };                                                                      \
  struct SaysOtherwise {                                                  \
    rest Nonsense function(__VA_ARGS__) const;                            \
  };                                                                      \
  struct WantsMore {                                                      \
    rest Result function(__VA_ARGS__ __VA_OPT__(, ) Nonsense more) const; \
  };                                                                      \
  struct Lacks {                                                          \
    rest                                                                  \
  };                                                                      \
  static_assert(Contract<Keeps>);                                         \
  static_assert(!Contract<Changes>);                                      \
  static_assert(!Contract<SaysOtherwise>);                                \
  static_assert(!Contract<WantsMore>);                                    \
  static_assert(!Contract<Lacks>);                                        \
  static_assert(!Contract<Nothing> && !Contract<int>);                    \
  }

// what else the contract asks for, kept as it is
#define TROPHIC_AND(...) __VA_ARGS__;
#define TROPHIC_ALONE

TROPHIC_REFUSES(community_web, initialization::Community, TROPHIC_AND(std::vector<Species> founders(std::size_t) const), FoodWeb,
                web)
TROPHIC_REFUSES(community_founders, initialization::Community, TROPHIC_AND(FoodWeb web() const), std::vector<Species>, founders,
                std::size_t)
TROPHIC_REFUSES(placement, initialization::Placement, TROPHIC_ALONE, std::vector<GroundPose>, place, std::size_t, const Arena&,
                double, Rng&)

TROPHIC_REFUSES(heading, perception::Heading, TROPHIC_ALONE, double, heading_rad, const Pose&, double)
TROPHIC_REFUSES(visibility, perception::Visibility, TROPHIC_ALONE, bool, perceives, BodyIndex, BodyIndex, const View&, Rng&)
using Two = std::array<double, 2>;
TROPHIC_REFUSES(own_sensor, perception::OwnSensor, TROPHIC_AND(static constexpr std::size_t size = 2), Two, sense, BodyIndex,
                const std::optional<Sighting>&, const View&, Rng&)
TROPHIC_REFUSES(common_sensor, perception::CommonSensor, TROPHIC_AND(static constexpr std::size_t size = 2), Two, sense,
                const View&)
TROPHIC_REFUSES(newborn_tag, perception::NewbornTag, TROPHIC_ALONE, int, tag, std::optional<int>, std::span<const int>, Rng&)
TROPHIC_REFUSES(tag_switch, perception::TagSwitch, TROPHIC_ALONE, perception::MaySwitch, may_switch, const Individual&,
                const View&)

TROPHIC_REFUSES(brain, control::Brain,
                TROPHIC_AND(std::size_t genome_size(std::size_t, std::size_t) const; std::vector<int> tags() const),
                control::Decision, decide, std::span<const double>, std::span<const double>)
TROPHIC_REFUSES(brain_with_outputs, control::Brain,
                TROPHIC_AND(std::size_t genome_size(std::size_t, std::size_t) const; std::vector<int> tags() const), void,
                evaluate, std::span<const double>, std::span<const double>, std::span<double>)
TROPHIC_REFUSES(pace, control::Pace, TROPHIC_ALONE, double, pace, BodyIndex, const View&)
TROPHIC_REFUSES(steering, control::Steering, TROPHIC_ALONE, void, steer, double, std::span<const HingePlace>, std::span<double>)

TROPHIC_REFUSES(initial_genome, reproduction::InitialGenome, TROPHIC_ALONE, void, draw, std::span<double>, Rng&)
TROPHIC_REFUSES(mutation, reproduction::Mutation, TROPHIC_ALONE, void, mutate, std::span<double>, const Individual&, Rng&)
TROPHIC_REFUSES(genome_source, reproduction::GenomeSource, TROPHIC_ALONE, reproduction::Descent, descent, Rng&)
TROPHIC_REFUSES(heredity, reproduction::Heredity, TROPHIC_ALONE, std::shared_ptr<Genome>, inherit, const std::shared_ptr<Genome>&)
TROPHIC_REFUSES(parent, reproduction::Parent, TROPHIC_ALONE, std::optional<Ancestor>, parent, const reproduction::Vacancy&,
                const View&, Rng&)

TROPHIC_REFUSES(gait, control::GaitRule, TROPHIC_ALONE, Gait, express, std::span<const double>, const RobotModel&, const Habitat&)
TROPHIC_REFUSES(body_plan, reproduction::BodyPlan, TROPHIC_ALONE, body::Design, grow, std::span<const double>, Species,
                const Habitat&)
TROPHIC_REFUSES(viability, reproduction::Viability, TROPHIC_AND(std::size_t attempts() const), std::optional<std::string>,
                refusal, const body::Design&, const RobotModel&)
TROPHIC_REFUSES(embodiment, initialization::Embodiment, TROPHIC_ALONE, Pose, set_down, const GroundPose&, const RobotModel&,
                const Arena&, std::span<const PlacedBox>)
TROPHIC_REFUSES(recruitment, reproduction::Recruitment,
                TROPHIC_AND(std::size_t spare_bodies() const; bool leaves_spare(const Vacancy&, const View&) const),
                std::vector<reproduction::Recruit>, recruits, const View&, Rng&)

TROPHIC_REFUSES(activation, death::Activation, TROPHIC_ALONE, death::Activates, activates, BodyIndex, const View&)
TROPHIC_REFUSES(capture, death::CaptureRule, TROPHIC_ALONE, std::vector<death::Capture>, captures, const View&, Rng&)
TROPHIC_REFUSES(floor, death::Floor, TROPHIC_ALONE, bool, may_die, Species, const View&)
TROPHIC_REFUSES(starvation, death::Starvation, TROPHIC_ALONE, death::Starving, starving, const View&,
                const perception::Perceives&)
struct Clock {};
TROPHIC_REFUSES(starvation_by_clock, death::Starvation,
                TROPHIC_AND(using Clock = refused_by_contracts::Clock; Clock start(const View&) const), death::Starving, starving,
                const View&, const perception::Perceives&, const Clock&)
TROPHIC_REFUSES(starvation_start, death::Starvation,
                TROPHIC_AND(using Clock = refused_by_contracts::Clock;
                            death::Starving starving(const View&, const perception::Perceives&, const Clock&) const),
                Clock, start, const View&)
TROPHIC_REFUSES(interval, death::starvation::Interval,
                TROPHIC_AND(bool due(const death::starvation::StarvationClock&, const View&) const), std::int64_t, interval_ticks,
                const View&)
TROPHIC_REFUSES(interval_due, death::starvation::Interval, TROPHIC_AND(std::int64_t interval_ticks(const View&) const), bool, due,
                const death::starvation::StarvationClock&, const View&)
TROPHIC_REFUSES(exemption, death::starvation::Exemption, TROPHIC_ALONE, bool, is_exempt, BodyIndex, const View&,
                const perception::Perceives&)
TROPHIC_REFUSES(choice, death::starvation::Choice, TROPHIC_ALONE, std::vector<BodyIndex>, victims, const View&,
                const death::starvation::IsExempt&)
TROPHIC_REFUSES(minimum_predators, death::MinimumPredators, TROPHIC_ALONE, std::vector<death::Sacrifice>, sacrifices, const View&,
                Rng&)
TROPHIC_REFUSES(senescence, death::Senescence, TROPHIC_ALONE, bool, dies, const Individual&, const View&, Rng&)

TEST_CASE("contracts: invalid policies -> rejected at compile time") {
  // a policy of one slot fits no other
  CHECK_FALSE(death::Floor<senescence::Keeps>);
  CHECK_FALSE(death::starvation::Choice<exemption::Keeps>);
}

}  // namespace trophic::refused_by_contracts
