// SPDX-License-Identifier: MIT
// What a run may change halfway.
#pragma once

#include <array>
#include <string_view>
#include <trophic/observe/run_description.hpp>

namespace trophic::changes {

/// "; read at the start", of a parameter that is not read at any tick.
[[nodiscard]] constexpr std::string_view when_read(Read read) {
  constexpr std::array<std::string_view, 4> words{"; read at the start", "; read at the start and at births without a parent",
                                                  "; read at births", ""};
  return words.at(static_cast<std::size_t>(read));
}

/// Throws std::invalid_argument for a parameter whose change to a value during a run would have no effect.
void check_acts_later(const NamedParam& param, const std::string& value);

/// Throws std::invalid_argument naming the first parameter that differs between two runs and cannot change during a run: all
/// except rules, seed, duration and threads. `branches`: the run starts there, so changed rule parameters must act later.
void check_may_follow(const observe::RunDescription& origin, const observe::RunDescription& run, bool branches = true);

}  // namespace trophic::changes
