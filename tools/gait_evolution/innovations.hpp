// SPDX-License-Identifier: MIT
// Numbers of new links and nodes: the same innovation has the same number in every genome of a run.
#pragma once

#include <cstdint>
#include <map>
#include <tools/gait_evolution/genome.hpp>
#include <utility>
#include <vector>

namespace trophic::gait_evolution {

/// The record of all innovations of a run. The links from each input to the output are the numbers 0 to 6.
class Innovations {
 public:
  using Ends = std::pair<std::uint32_t, std::uint32_t>;  ///< from, to
  struct Split {
    std::uint32_t link = 0;
    std::uint32_t node = 0;
    friend bool operator==(const Split&, const Split&) = default;
  };

  Innovations();

  /// Continues a stored record: `links` in the order of their numbers, `splits` in the order in which they happened.
  Innovations(const std::vector<Ends>& links, std::vector<Split> splits);

  /// The number of the link between two nodes; a new one where no genome has had it.
  std::uint32_t link(std::uint32_t from, std::uint32_t to);

  /// The id of the node that splits a link of `genome`: the first one ever made there that the genome lacks, or a new one.
  std::uint32_t node(std::uint32_t split_link, const Genome& genome);

  friend bool operator==(const Innovations&, const Innovations&) = default;

  [[nodiscard]] const std::vector<Ends>& links() const { return links_; }
  [[nodiscard]] const std::vector<Split>& splits() const { return splits_; }

 private:
  std::vector<Ends> links_;
  std::vector<Split> splits_;
  std::map<Ends, std::uint32_t> number_of_link_;
};

}  // namespace trophic::gait_evolution
