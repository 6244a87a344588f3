// SPDX-License-Identifier: MIT
// The events of a run, for a run that repeats them.
#pragma once

#include <trophic/observe/event.hpp>
#include <trophic/params/archive.hpp>

namespace trophic {

/// An event of a run, as in a row of events.csv. Tag switches are not included, because brains decide on them.
struct Happening {
  std::int64_t tick = 0;
  observe::EventKind kind = observe::EventKind::birth;
  BodyIndex body = 0;
  IndividualId id = 0;
  Species species = 0;
  Origin origin = Origin::random;          ///< label, for a birth
  std::vector<IndividualId> parents = {};  ///< parents, for a birth
  std::optional<Cause> cause = {};         ///< cause, for a death
  std::optional<IndividualId> killer_or_victim = {};
};

/// The events of a run in order. The neutral null repeats them, whatever its robots do: births, deaths, parents, activations and
/// catches are those of the run, but genomes are independent. Behaviour has no effect on life spans and offspring numbers, so
/// there is neither viability nor fecundity selection: genomes change only by mutation and drift. Tags are not repeated, because
/// brains choose them.
using History = std::vector<Happening>;
using SharedHistory = std::shared_ptr<const History>;

/// The progress of a history through a run that repeats it.
class RepeatedHistory {
 public:
  explicit RepeatedHistory(SharedHistory history) : history_{std::move(history)} {}

  [[nodiscard]] explicit operator bool() const { return history_ != nullptr; }

  /// Notes a founder as a possible parent. Throws std::invalid_argument if it differs from the history's.
  void found(const Individual& founder) {
    const Happening* birth = at_ < history_->size() ? &(*history_)[at_++] : nullptr;
    const bool fits = birth && birth->kind == observe::EventKind::birth && birth->id == founder.id &&
                      birth->species == founder.species && founder.id >= born_.size();
    if (!fits) throw std::invalid_argument{"a history with different founders"};
    note_birth(founder);
  }
  /// Individuals are born in the order of their ids; spare bodies at the start leave gaps.
  void note_birth(const Individual& newborn) {
    born_.resize(newborn.id);
    born_.push_back(newborn.as_ancestor());
  }

  /// The next event up to a tick; null if there are no more.
  [[nodiscard]] const Happening* next(std::int64_t tick) {
    return at_ < history_->size() && (*history_)[at_].tick <= tick ? &(*history_)[at_++] : nullptr;
  }
  /// Whether the event after the last returned one is a birth in this body, which then stays in the world.
  [[nodiscard]] bool goes_on_in(BodyIndex body) const {
    return at_ < history_->size() && (*history_)[at_].kind == observe::EventKind::birth && (*history_)[at_].body == body;
  }
  [[nodiscard]] std::vector<Ancestor> parents_of(const Happening& birth) const {
    std::vector<Ancestor> parents;
    for (const IndividualId parent : birth.parents) parents.push_back(born_.at(parent));
    return parents;
  }

  void persist(Archive& archive) {
    if (history_) archive(at_, born_);
  }

 private:
  SharedHistory history_;
  std::size_t at_ = 0;               ///< the next event
  std::vector<Ancestor> born_ = {};  ///< all individuals so far, by id
};

/// Reads the history that the neutral null of a seed repeats.
using HistoryOf = std::function<SharedHistory(std::uint64_t seed)>;

}  // namespace trophic
