// SPDX-License-Identifier: MIT
// A table that does not state its numbers.
// expect: the rule table must state its numbers: static TableParams<TABLE> params()
#include <trophic/rules/paper.hpp>

struct Table final {
  static constexpr std::string_view name = "table";
#define TROPHIC_SAME(Slot, member, ...) using Slot = trophic::PolicyIn<trophic::rules::Paper, trophic::RuleSlot::member>;
  TROPHIC_RULE_SLOTS(TROPHIC_SAME)
#ifdef VALID
  static trophic::TableParams<Table> params() {
    return trophic::TableParams<Table>{.floor = {.floor = 5}};
  }
#endif
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
