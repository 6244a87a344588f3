// SPDX-License-Identifier: MIT
// Definitions of contest_progress.hpp.
#include <tools/analysis/report/contest_progress.hpp>

#include <map>
#include <set>
#include <tools/analysis/statistics/interval.hpp>
#include <trophic/params/params.hpp>

namespace trophic::analysis {

namespace {

/// The matrix of each run, by its name.
using Matrices = std::map<std::string, ContestMatrix>;

struct Link {
  Against against;
  std::string hunter;
  std::string victim;
  auto operator<=>(const Link&) const = default;
};

/// The matrices of a link from the side of the hunters' runs and from that of the victims'.
struct Sides {
  Matrices hunters;
  Matrices victims;
};

std::vector<double> values_of(const Matrices& matrices, bool of_hunters, std::size_t earlier, std::size_t later) {
  std::vector<double> values;
  for (const auto& [run, matrix] : matrices) {
    const auto value = of_hunters ? matrix.hunters_progress(earlier, later) : matrix.victims_progress(earlier, later);
    if (value) values.push_back(*value);
  }
  return values;
}

Difference over_shadow(std::span<const double> ours, std::span<const double> shadow) {
  const auto mean = mean_of(ours);
  const auto of_shadow = mean_of(shadow);
  if (!mean || !of_shadow) return {};
  return difference_of(*mean - *of_shadow, contrast({{1.0, ours}, {-1.0, shadow}}));
}

std::size_t place_of(std::span<const double> epochs_s, double epoch_s) {
  const auto found = std::ranges::find(epochs_s, epoch_s);
  if (found != epochs_s.end()) return static_cast<std::size_t>(found - epochs_s.begin());
  std::string all;
  for (const double one : epochs_s) all += (all.empty() ? "" : ", ") + number_text(one);
  throw std::invalid_argument{"--split " + number_text(epoch_s) + ": must be one of the epochs, " + all + " s"};
}

}  // namespace

void ContestMatrix::add(std::size_t hunter_epoch, std::size_t victim_epoch, double contact_s) {
  const std::size_t cell = hunter_epoch * epochs_ + victim_epoch;
  sums_.at(cell) += contact_s;
  ++counts_.at(cell);
}

std::optional<double> ContestMatrix::at(std::size_t hunter_epoch, std::size_t victim_epoch) const {
  const std::size_t cell = hunter_epoch * epochs_ + victim_epoch;
  if (counts_.at(cell) == 0) return std::nullopt;
  return sums_[cell] / static_cast<double>(counts_[cell]);
}

std::optional<double> ContestMatrix::hunters_progress(std::size_t earlier, std::size_t later) const {
  double sum = 0.0;
  for (std::size_t victims = 0; victims < epochs_; ++victims) {
    const auto before = at(earlier, victims);
    const auto after = at(later, victims);
    if (!before || !after) return std::nullopt;
    sum += *before - *after;
  }
  return sum / static_cast<double>(epochs_);
}

std::optional<double> ContestMatrix::victims_progress(std::size_t earlier, std::size_t later) const {
  double sum = 0.0;
  for (std::size_t hunters = 0; hunters < epochs_; ++hunters) {
    const auto before = at(hunters, earlier);
    const auto after = at(hunters, later);
    if (!before || !after) return std::nullopt;
    sum += *after - *before;
  }
  return sum / static_cast<double>(epochs_);
}

std::vector<double> epochs_of(std::span<const ContestRow> contests) {
  std::set<double> epochs;
  for (const ContestRow& row : contests) {
    epochs.insert(row.hunter_epoch_s);
    epochs.insert(row.victim_epoch_s);
  }
  return {epochs.begin(), epochs.end()};
}

double default_split_s(std::span<const double> epochs_s) {
  if (epochs_s.empty()) throw std::invalid_argument{"contests of no epoch: must be of at least two"};
  return epochs_s[(epochs_s.size() - 1) / 2];
}

std::vector<Progress> progress_of(std::span<const ContestRow> contests, std::optional<double> split_s) {
  const std::vector<double> epochs_s = epochs_of(contests);
  if (epochs_s.size() < 2) {
    throw std::invalid_argument{"contests of " + std::to_string(epochs_s.size()) + " epochs: must be of at least two"};
  }
  const std::size_t last = epochs_s.size() - 1;
  const std::size_t split = place_of(epochs_s, split_s.value_or(default_split_s(epochs_s)));

  std::map<Link, std::pair<Sides, Sides>> links;  // ours, the shadow's
  for (const ContestRow& row : contests) {
    auto& [ours, shadow] = links[{row.against, row.hunter, row.victim}];
    Sides& sides = row.shadow ? shadow : ours;
    const std::size_t hunters = place_of(epochs_s, row.hunter_epoch_s);
    const std::size_t victims = place_of(epochs_s, row.victim_epoch_s);
    sides.hunters.try_emplace(row.hunters_run, epochs_s.size()).first->second.add(hunters, victims, row.contact_s);
    sides.victims.try_emplace(row.victims_run, epochs_s.size()).first->second.add(hunters, victims, row.contact_s);
  }

  std::vector<Progress> all;
  for (const auto& [link, both] : links) {
    const auto& [ours, shadow] = both;
    for (const auto& [period, earlier, later] : {std::tuple{Period::early, std::size_t{0}, split}, {Period::late, split, last}}) {
      if (earlier == later) continue;
      for (const bool of_hunters : {true, false}) {
        const auto ours_values = values_of(of_hunters ? ours.hunters : ours.victims, of_hunters, earlier, later);
        const auto shadow_values = values_of(of_hunters ? shadow.hunters : shadow.victims, of_hunters, earlier, later);
        all.push_back({.against = link.against,
                       .hunter = link.hunter,
                       .victim = link.victim,
                       .of_hunters = of_hunters,
                       .period = period,
                       .from_s = epochs_s[earlier],
                       .to_s = epochs_s[later],
                       .ours = estimate(ours_values),
                       .shadow = estimate(shadow_values),
                       .over_shadow = over_shadow(ours_values, shadow_values)});
      }
      const std::array family{&all[all.size() - 2].over_shadow, &all.back().over_shadow};
      adjust_together(family);
    }
  }
  return all;
}

}  // namespace trophic::analysis
