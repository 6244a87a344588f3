// SPDX-License-Identifier: MIT
// From a table that is not final others could be derived, in which a misspelt slot would run this one's rule.
// expect: the rule table must be final
#include <trophic/rules/paper.hpp>

#ifdef VALID
struct Table final {
#else
struct Table {
#endif
  static constexpr std::string_view name = "table";
#define TROPHIC_SAME(Slot, member, ...) using Slot = trophic::PolicyIn<trophic::rules::Paper, trophic::RuleSlot::member>;
  TROPHIC_RULE_SLOTS(TROPHIC_SAME)
  static trophic::TableParams<Table> params() {
    return trophic::TableParams<Table>{.floor = {.floor = 5}};
  }
  static trophic::EcologyParams ecology() {
    return {};
  }
  static trophic::Physics physics() {
    return {};
  }
};

int main() {
  return trophic::RuleParams<Table>{}.floor.floor == 5 ? 0 : 1;
}
