// SPDX-License-Identifier: MIT
// A misspelt number would be the policy's default.
// expect: 'flor'
#include <trophic/rules/paper.hpp>

struct Table final {
  static constexpr std::string_view name = "table";
#define TROPHIC_SAME(Slot, member, ...) using Slot = trophic::PolicyIn<trophic::rules::Paper, trophic::RuleSlot::member>;
  TROPHIC_RULE_SLOTS(TROPHIC_SAME)
  static trophic::TableParams<Table> params() {
#ifdef VALID
    return trophic::TableParams<Table>{.floor = {.floor = 5}};
#else
    return trophic::TableParams<Table>{.floor = {.flor = 5}};
#endif
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
