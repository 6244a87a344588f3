// SPDX-License-Identifier: MIT
// One of two policies of a slot or of a part of one, chosen by a number, for screening designs over many open choices.
#pragma once

#include <trophic/death/starvation/choice/contract.hpp>
#include <trophic/params/params.hpp>
#include <trophic/params/policy.hpp>
#include <trophic/rules/slots.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::readings {

/// The reading of an open sentence in a run.
enum class Reading { first, second };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(Reading) {
  return {"first", "second"};
}

/// A policy that behaves as one of two policies of one slot, neither of which has a State. n open choices as types are 2^n rule
/// tables; as numbers of one table they are a sweep. A rule table for an experiment names its policies.
template <class First, class Second>
struct Either {
  struct Words {
    static constexpr std::array<std::string_view, 3> words{First::name, "_or_", Second::name};
    static constexpr std::string_view separator{};
  };
  static constexpr std::string_view name = JoinedText<Words>::view;

  struct Params {
    Reading reading = Reading::first;
    ParamsOf<First> first{};
    ParamsOf<Second> second{};
    static constexpr auto fields() {
      return std::tuple{field("reading", &Params::reading, "first or second"), field("first", &Params::first),
                        field("second", &Params::second)};
    }
  };
  Params params;

  [[nodiscard]] std::vector<GroundPose> place(std::size_t robots, const Arena& arena, double radius_m,
                                              Rng& rng) const requires initialization::Placement<First> {
    return answer([&](const auto& rule) { return rule.place(robots, arena, radius_m, rng); });
  }
  [[nodiscard]] bool perceives(BodyIndex self, BodyIndex other, const View& view,
                               Rng& rng) const requires perception::Visibility<First> {
    return answer([&](const auto& rule) { return rule.perceives(self, other, view, rng); });
  }
  [[nodiscard]] auto sense(BodyIndex self, const std::optional<Sighting>& sighting, const View& view,
                           Rng& rng) const requires perception::OwnSensor<First> {
    return answer([&](const auto& rule) { return rule.sense(self, sighting, view, rng); });
  }
  [[nodiscard]] auto sense(const View& view) const requires perception::CommonSensor<First> {
    return answer([&](const auto& rule) { return rule.sense(view); });
  }
  [[nodiscard]] int tag(std::optional<int> body_tag, std::span<const int> tags,
                        Rng& rng) const requires perception::NewbornTag<First> {
    return answer([&](const auto& rule) { return rule.tag(body_tag, tags, rng); });
  }
  [[nodiscard]] std::size_t genome_size(std::size_t inputs, std::size_t outputs) const requires control::Brain<First> {
    return answer([&](const auto& rule) { return rule.genome_size(inputs, outputs); });
  }
  [[nodiscard]] std::vector<int> tags() const requires control::Brain<First> {
    return answer([&](const auto& rule) { return rule.tags(); });
  }
  void evaluate(std::span<const double> inputs, std::span<const double> weights,
                std::span<double> outputs) const requires control::Brain<First> {
    answer([&](const auto& rule) { rule.evaluate(inputs, weights, outputs); });
  }
  [[nodiscard]] double target_angle_rad(double output) const requires control::Brain<First> {
    return answer([&](const auto& rule) { return rule.target_angle_rad(output); });
  }
  [[nodiscard]] reproduction::Descent descent(Rng& rng) const requires reproduction::GenomeSource<First> {
    return answer([&](const auto& rule) { return rule.descent(rng); });
  }
  [[nodiscard]] std::optional<Ancestor> parent(const reproduction::Vacancy& vacancy, const View& view,
                                               Rng& rng) const requires reproduction::Parent<First> {
    return answer([&](const auto& rule) { return rule.parent(vacancy, view, rng); });
  }
  [[nodiscard]] death::Activates activates(BodyIndex body, const View& view) const requires death::Activation<First> {
    return answer([&](const auto& rule) { return rule.activates(body, view); });
  }
  [[nodiscard]] bool may_die(Species species, const View& view) const requires death::Floor<First> {
    return answer([&](const auto& rule) { return rule.may_die(species, view); });
  }
  [[nodiscard]] std::vector<BodyIndex> victims(
      const View& view, const death::starvation::IsExempt& is_exempt) const requires death::starvation::Choice<First> {
    return answer([&](const auto& rule) { return rule.victims(view, is_exempt); });
  }

 private:
  template <class Question>
  [[nodiscard]] auto answer(const Question& question) const {
    if (params.reading == Reading::second) return question(make_policy<Second>(params.second));
    return question(make_policy<First>(params.first));
  }
};

/// One of two sensors of the same size.
template <class First, class Second>
struct EitherSensor : Either<First, Second> {
  static constexpr std::size_t size = First::size;
};

}  // namespace trophic::readings
