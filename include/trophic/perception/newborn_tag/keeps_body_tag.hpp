// SPDX-License-Identifier: MIT
// A newborn shows the tag that its body showed.
#pragma once

#include <trophic/params/params.hpp>
#include <trophic/perception/newborn_tag/contract.hpp>

namespace trophic::perception::newborn_tag {

/// Rule: a newborn keeps the tag of the body's previous occupant; founders start with founder_tag. The paper is silent; this is
/// the released code's rule, in which all founders show +1.   Reads: the body's tag.   Random draws: 0.
struct KeepsBodyTag {
  static constexpr std::string_view name = "keeps_body_tag";
  static constexpr std::string_view source = "paper: silent; released code";

  struct Params {
    int founder_tag = 1;
    static constexpr auto fields() {
      return std::tuple{
          field("founder_tag", &Params::founder_tag, any_number(), "tag of founders, one of the brain's tags").read_at_start()};
    }
  };
  Params params;

  [[nodiscard]] int tag(std::optional<int> body_tag, std::span<const int>, Rng&) const {
    return body_tag.value_or(params.founder_tag);
  }
};
static_assert(NewbornTag<KeepsBodyTag>);

}  // namespace trophic::perception::newborn_tag
