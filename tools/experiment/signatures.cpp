// SPDX-License-Identifier: MIT
// Definitions of signatures.hpp.
#include <fstream>
#include <set>
#include <tools/command/output.hpp>
#include <tools/contest/play_contests.hpp>
#include <tools/experiment/signatures.hpp>
#include <trophic/support/json.hpp>

namespace trophic::command {

Signatures::Signatures(Decide decide, std::vector<std::vector<Inputs>> inputs)
    : decide_{std::move(decide)}, inputs_{std::move(inputs)} {
  for (const std::vector<Inputs>& met : inputs_) {
    std::vector<Inputs> ends;
    for (const Inputs& one : met) {
      if (ends.empty()) ends.assign(2, one);
      for (std::size_t i = 0; i < one.size(); ++i) {
        ends[0][i] = std::min(ends[0][i], one[i]);
        ends[1][i] = std::max(ends[1][i], one[i]);
      }
    }
    extremes_.push_back(std::move(ends));
  }
}

Type Signatures::type_of(Species species, std::span<const double> weights) {
  std::string decisions = std::to_string(species) + ":";
  for (const Inputs& inputs : inputs_.at(species)) {
    for (const int choice : decide_(species, inputs, weights)) decisions += std::to_string(choice) + ',';
  }
  return types_.try_emplace(std::move(decisions), static_cast<Type>(types_.size())).first->second;
}

std::size_t Signatures::complexity(Species species, std::span<const double> weights) const {
  const std::vector<Inputs>& met = inputs_.at(species);
  if (met.empty()) return 0;
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (const Inputs& inputs : met) {
    const std::vector<int> before = decide_(species, inputs, weights);
    Inputs changed = inputs;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      for (const Inputs& end : extremes_.at(species)) {
        changed[i] = end[i];
        const std::vector<int> after = decide_(species, changed, weights);
        for (std::size_t act = 0; act < before.size(); ++act) {
          if (before[act] != after[act]) pairs.emplace(i, act);
        }
      }
      changed[i] = inputs[i];
    }
  }
  return pairs.size();
}

int print_signatures(const std::filesystem::path& file, const Offer& offer) {
  std::ifstream in{file, std::ios::binary};
  std::string head;
  if (!std::filesystem::is_regular_file(file) || !std::getline(in, head))
    throw std::invalid_argument{"--signatures " + file.string() + ": cannot be read"};
  try {
    const Json json = parse_json(head);
    const contest::Plan plan{.rule_table = json.at("rule_table").get<std::string>(),
                             .engine = json.at("engine").get<std::string>(),
                             .fingerprint = json.at("fingerprint").get<std::string>(),
                             .params = json.at("params")};
    if (const std::string why = why_not_played(plan, offer); !why.empty()) throw std::invalid_argument{why};
    Signatures signatures{experiment_of(plan, offer)->brain(), json.at("inputs").get<std::vector<std::vector<Inputs>>>()};
    const auto sizes = json.at("sizes").get<std::vector<std::size_t>>();
    std::string text;
    std::vector<double> weights;
    auto size = sizes.begin();
    for (const Json& one : json.at("species")) {
      const auto species = one.get<Species>();
      if (size == sizes.end()) throw std::invalid_argument{"--signatures " + file.string() + ": has fewer sizes than genomes"};
      weights.resize(*size++);
      if (!in.read(reinterpret_cast<char*>(weights.data()), static_cast<std::streamsize>(sizeof(double) * weights.size()))) {
        throw std::invalid_argument{"--signatures " + file.string() + ": has fewer weights than genomes"};
      }
      text += std::to_string(signatures.type_of(species, weights)) + " " +
              std::to_string(signatures.complexity(species, weights)) + "\n";
    }
    return print_text(text);
  } catch (const Json::exception& error) {
    throw std::invalid_argument{"--signatures " + file.string() + ": " + reason_of(error)};
  } catch (const std::out_of_range&) {
    throw std::invalid_argument{"--signatures " + file.string() + ": has a genome of an unknown species"};
  }
}

}  // namespace trophic::command
