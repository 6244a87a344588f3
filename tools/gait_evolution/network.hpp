// SPDX-License-Identifier: MIT
// A CPPN ready to be queried.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <tools/gait_evolution/genome.hpp>
#include <vector>

namespace trophic::gait_evolution {

/// The feed-forward network of a genome: each node activates the weighted sum of its enabled links, added up in the order of
/// their innovation numbers. A node without links has the sum 0.
class Network {
 public:
  /// Throws std::invalid_argument where the genome is not valid.
  explicit Network(const Genome& genome);

  /// The output for a pair of modules' grid cells: inputs (1, x1, y1, z1, x2, y2, z2).
  [[nodiscard]] double operator()(const Eigen::Vector3i& first, const Eigen::Vector3i& second) const {
    std::vector<double> value{1.0};
    value.reserve(Genome::inputs + nodes_.size());
    for (const Eigen::Vector3i& cell : {first, second}) {
      for (const int coordinate : cell) value.push_back(coordinate);
    }
    for (const Node& node : nodes_) {
      double sum = 0.0;
      for (const auto& [slot, weight] : node.incoming) sum += weight * value[slot];
      value.push_back(activate(node.activation, sum));
    }
    return value[output_slot_];
  }

 private:
  struct Incoming {
    std::size_t slot;
    double weight;
  };
  struct Node {
    Activation activation;
    std::vector<Incoming> incoming;
  };
  std::vector<Node> nodes_;
  std::size_t output_slot_ = 0;
};

}  // namespace trophic::gait_evolution
