// SPDX-License-Identifier: MIT
// Definitions of wishes.hpp.
#include <algorithm>
#include <tools/command/words.hpp>
#include <tools/live/wishes.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/json.hpp>
#include <vector>

namespace trophic::live {

namespace {

constexpr std::array<std::string_view, 6> kinds{"play", "pause", "tick", "speed", "set", "restart"};

std::string text_at(const Json& json, const std::string& key) {
  std::string text = json.at(key).get<std::string>();
  if (text.size() > changes::longest_value)
    throw std::invalid_argument{key + ": must have <= " + std::to_string(changes::longest_value) + " bytes"};
  return text;
}

double speed_at(const Json& json) {
  const double speed = json.at("value").get<double>();
  if (speed == 0.0 || (speed >= least_speed && speed <= most_speed)) return speed;
  throw std::invalid_argument{"speed = " + number_text(speed) + ": must be 0 (as fast as possible), or >= " +
                              number_text(least_speed) + " and <= " + number_text(most_speed)};
}

}  // namespace

Wish read_wish(std::string_view message, const command::LiveRun& run) {
  if (message.size() > most_wish_bytes) {
    throw std::invalid_argument{"message: must have <= " + std::to_string(most_wish_bytes) + " bytes"};
  }
  try {
    const Json json = parse_json(message);
    const std::string what = text_at(json, "do");
    const auto kind = std::ranges::find(kinds, what);
    if (kind == kinds.end()) {
      throw std::invalid_argument{command::must_be_one_of("do = " + what, std::vector<std::string>{kinds.begin(), kinds.end()})};
    }
    Wish wish;
    wish.kind = static_cast<Wish::Kind>(kind - kinds.begin());
    if (wish.kind == Wish::Kind::speed) wish.speed = speed_at(json);
    if (wish.kind == Wish::Kind::set) {
      wish.number = text_at(json, "number");
      wish.value = text_at(json, "value");
      if (std::ranges::find(run.numbers, wish.number, &NamedParam::path) == run.numbers.end()) {
        throw std::invalid_argument{wish.number + ": is not a rule parameter of this run"};
      }
      if (wish.value.empty() || wish.value.find_first_of("\n\r\"'[]{}#=") != std::string::npos) {
        throw std::invalid_argument{wish.number + ": must be one number, true or false, or one word"};
      }
    }
    if (wish.kind == Wish::Kind::restart) {
      wish.seed = whole_number<std::uint64_t>(json, "seed", 0, static_cast<std::uint64_t>(any_seed().upper));
      wish.rule_table = text_at(json, "rules");
      if (std::ranges::find(run.rule_tables, wish.rule_table) == run.rule_tables.end()) {
        throw std::invalid_argument{command::must_be_one_of("rules = " + wish.rule_table, run.rule_tables)};
      }
    }
    return wish;
  } catch (const Json::exception&) {
    throw std::invalid_argument{"message: must be a JSON object with the key do"};
  }
}

}  // namespace trophic::live
