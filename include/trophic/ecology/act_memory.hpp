// SPDX-License-Identifier: MIT
// Stores the values of the acts of each body.
#pragma once

#include <trophic/params/archive.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/rule_error.hpp>

namespace trophic {

/// The values of a table's acts at the last decision of each body.
template <class Rules, bool = PolicyIn<Rules, RuleSlot::acts>::keeps_values>
class ActMemory {
 public:
  using Acts = PolicyIn<Rules, RuleSlot::acts>;
  using Outputs = std::array<double, Acts::outputs>;

  [[nodiscard]] ActValues values() const { return {.acts = Acts::keys, .names = Acts::kept_names, .values = values_}; }

  /// Resets the acts of a body to their values before the first decision of a life; adds new bodies.
  void rest(BodyIndex body) {
    values_.resize(std::max(values_.size(), (body + 1) * Acts::count));
    Acts::each(Outputs{}, [&]<class One>(std::size_t place, std::span<const double, One::outputs>) {
      values_[body * Acts::count + place] = static_cast<double>(One::by_default);
    });
  }

  /// Stores the values of a decision's outputs. Throws RuleError for a value outside its bounds.
  void act(BodyIndex body, const Outputs& outputs) {
    Acts::each(outputs, [&]<class One>(std::size_t place, std::span<const double, One::outputs> out) {
      const auto value = static_cast<double>(One::value(out));
      if (!is_in_bounds<One>(value)) throw RuleError{"acts", must_be<One>(value)};
      values_[body * Acts::count + place] = value;
    });
  }

  /// A sentence about the first value of these outputs that is out of its bounds.
  [[nodiscard]] static std::optional<std::string> out_of_bounds(std::span<const double, Acts::outputs> outputs) {
    std::optional<std::string> wrong;
    Acts::each(outputs, [&]<class One>(std::size_t, std::span<const double, One::outputs> out) {
      const auto value = static_cast<double>(One::value(out));
      if (!wrong && !is_in_bounds<One>(value)) wrong = must_be<One>(value);
    });
    return wrong;
  }

  void persist(Archive& archive) {
    const std::size_t size = values_.size();
    archive(values_);
    Archive::require(values_.size() == size, "a different number of acts");
  }

 private:
  template <class One>
  [[nodiscard]] static bool is_in_bounds(double value) {
    return value >= One::least && value <= One::most;
  }
  template <class One>
  [[nodiscard]] static std::string must_be(double value) {
    return std::string{One::name} + " = " + number_text(value) + ": must be >= " + number_text(One::least) +
           " and <= " + number_text(One::most);
  }

  std::vector<double> values_;  ///< one per body and act
};

/// With the paper's acts nothing is stored here, because individuals hold their values.
template <class Rules>
class ActMemory<Rules, false> {
 public:
  using Acts = PolicyIn<Rules, RuleSlot::acts>;
  using Outputs = std::array<double, Acts::outputs>;
  [[nodiscard]] ActValues values() const { return {}; }
  void rest(BodyIndex) {}
  void act(BodyIndex, const Outputs&) {}
  [[nodiscard]] static std::optional<std::string> out_of_bounds(std::span<const double, Acts::outputs>) { return std::nullopt; }
  void persist(Archive&) {}
};

}  // namespace trophic
