// SPDX-License-Identifier: MIT
// Newborns improve an inherited gait by trials in a nursery, before birth.
#pragma once

#include <trophic/control/gait/contract.hpp>
#include <trophic/params/policy.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::control::gait {

/// Rule: gaits are drawn and mutated by `Rule`; then each newborn learns. It walks `trials` times for `trial_s` in a nursery,
/// first with its inherited gait, then each time with a mutation (by Rule) of the best gait so far, which replaces it if the
/// robot walks farther. In life the robot uses the best gait. Its offspring inherit that with probability `lamarckian` and
/// otherwise the gait that it inherited itself: 1 is Lamarckian, 0 Darwinian. The genes are the number of inherited genes, the
/// inherited genes, and the learnt ones. Reads: the body.   Random draws: Rule's in each trial but the first; 1 at a mutation.
template <class Rule>
struct Learnt {
  static_assert(InheritedGait<Rule>, "gait::Learnt takes an inherited gait; see trophic/control/gait/contract.hpp");
  static constexpr std::string_view name = prefixed_name<"learnt", Rule>;
  static constexpr std::string_view source = "not in the paper";
  static constexpr bool fits_one_body = requires { requires Rule::fits_one_body; };

  struct Params {
    ParamsOf<Rule> inherited = {};
    std::size_t trials = 10;
    double trial_s = 10.0;
    double lamarckian = 0.0;
    static constexpr auto fields() {
      return std::tuple{field("inherited", &Params::inherited),
                        field("trials", &Params::trials, between(1.0, 10000.0),
                              "number of trial walks before birth, the first with the inherited gait"),
                        field("trial_s", &Params::trial_s, between(0.01, 600.0), "duration of each walk, simulated seconds"),
                        field("lamarckian", &Params::lamarckian, between(0.0, 1.0),
                              "probability that offspring inherit the learnt gait: 0 is Darwinian, 1 Lamarckian")};
    }
  };
  Params params;

  /// The models to load before the run.
  [[nodiscard]] std::vector<std::string> gaits() const {
    if constexpr (requires(const Rule rule) { rule.gaits(); }) return rule().gaits();
    return {};
  }

  [[nodiscard]] std::vector<double> draw(const RobotModel& robot, const Habitat& habitat, Rng& rng) const {
    const std::vector<double> drawn = rule().draw(robot, habitat, rng);
    return joined(drawn, drawn);
  }

  void mutate(std::vector<double>& genes, const Individual& offspring, Rng& rng) const {
    const std::span<const double> passed = rng.chance(params.lamarckian) ? learnt_in(genes) : inherited_in(genes);
    std::vector<double> own{passed.begin(), passed.end()};
    rule().mutate(own, offspring, rng);
    genes = joined(own, own);
  }

  void learn(std::vector<double>& genes, const RobotModel& robot, const Habitat& habitat, const Individual& newborn,
             const Nursery& nursery, Rng& rng) const {
    const auto walk = [&](std::span<const double> own) {
      const auto walked_m = nursery.walked_m(robot, rule().express(own, robot, habitat), params.trial_s);
      return walked_m.value_or(-std::numeric_limits<double>::infinity());
    };
    const std::vector<double> inherited{inherited_in(genes).begin(), inherited_in(genes).end()};
    std::vector<double> best = inherited;
    double farthest_m = params.trials > 1 ? walk(best) : 0.0;
    for (std::size_t trial = 1; trial < params.trials; ++trial) {
      std::vector<double> tried = best;
      rule().mutate(tried, newborn, rng);
      const double walked_m = walk(tried);
      if (walked_m <= farthest_m) continue;
      farthest_m = walked_m;
      best = std::move(tried);
    }
    genes = joined(inherited, best);
  }

  /// The number of inherited genes, and the structure of both gaits.
  [[nodiscard]] std::vector<std::size_t> structure(std::span<const double> genes) const {
    std::vector<std::size_t> indices{0};
    for (const std::span<const double> part : {inherited_in(genes), learnt_in(genes)}) {
      const auto first = static_cast<std::size_t>(part.data() - genes.data());
      for (const std::size_t gene : ask::gait_structure(rule(), part)) indices.push_back(first + gene);
    }
    return indices;
  }

  [[nodiscard]] Gait express(std::span<const double> genes, const RobotModel& robot, const Habitat& habitat) const {
    return rule().express(learnt_in(genes), robot, habitat);
  }

 private:
  [[nodiscard]] Rule rule() const { return make_policy<Rule>(params.inherited); }

  [[nodiscard]] static std::vector<double> joined(std::span<const double> inherited, std::span<const double> learnt) {
    std::vector<double> genes{static_cast<double>(inherited.size())};
    genes.insert(genes.end(), inherited.begin(), inherited.end());
    genes.insert(genes.end(), learnt.begin(), learnt.end());
    return genes;
  }
  [[nodiscard]] static std::span<const double> inherited_in(std::span<const double> genes) {
    return genes.subspan(1, inherited_count(genes));
  }
  [[nodiscard]] static std::span<const double> learnt_in(std::span<const double> genes) {
    return genes.subspan(1 + inherited_count(genes));
  }
  [[nodiscard]] static std::size_t inherited_count(std::span<const double> genes) {
    for (std::size_t count = 1; count < genes.size(); ++count) {
      if (genes[0] == static_cast<double>(count)) return count;
    }
    throw std::invalid_argument{"genes of a learnt gait: must begin with the number of inherited genes"};
  }
};

}  // namespace trophic::control::gait
