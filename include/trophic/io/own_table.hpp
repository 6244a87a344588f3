// SPDX-License-Identifier: MIT
// Own tables: observers that a program adds to its experiments, so that every run also writes their tables.
#pragma once

#include <functional>
#include <trophic/io/csv_file.hpp>
#include <trophic/observe/audience.hpp>
#include <trophic/observe/hooks.hpp>

namespace trophic {
class Simulation;
}

namespace trophic::io {

/// An observer (trophic/observe/hooks.hpp) that writes one table into the folder of a run:
///
///   static constexpr std::string_view file_name = "distances.csv";
///   Distances(const std::filesystem::path& path, Opening opening)   `path` ends in file_name; a resumed run continues the file
///   void persist(Archive& archive)                                  its state, and its CsvFile
///   TableSum sum() const                                            its CsvFile's
///
/// The run writes the file to the disk when it ends. Such an observer neither requests frames nor ends a run; observers that do
/// are passed to run_until.
template <class O>
concept OwnTable = observe::Observer<O> && Persists<O> && std::constructible_from<O, const std::filesystem::path&, Opening> &&
    requires(const O& table) {
  { O::file_name } -> std::convertible_to<std::string_view>;
  { table.sum() } -> std::same_as<TableSum>;
} && !observe::detail::Names_on_frame<O> && !observe::detail::Names_between_ticks<O> && !observe::detail::Names_keep_running<O> &&
    !observe::detail::Names_cancels_tick<O>;

/// A type-erased table of a run.
class AnyOwnTable {
 public:
  AnyOwnTable() = default;
  AnyOwnTable(const AnyOwnTable&) = delete;
  AnyOwnTable& operator=(const AnyOwnTable&) = delete;
  virtual ~AnyOwnTable() = default;
  [[nodiscard]] virtual std::string file_name() const = 0;
  [[nodiscard]] virtual observe::Audience& observer() = 0;
  [[nodiscard]] virtual TableSum sum() const = 0;
  virtual void persist(Archive& archive) = 0;
};

/// Makes one table in the folder of a run.
using MakeOwnTable = std::function<std::unique_ptr<AnyOwnTable>(const std::filesystem::path& folder, Opening opening)>;
using OwnTables = std::vector<MakeOwnTable>;
/// The tables that a run of an ecology writes in addition to its own; null if there are none.
using OwnTablesOf = std::function<OwnTables(const Simulation& ecology)>;

namespace detail {

template <class O>
class OwnTableOf final : public AnyOwnTable {
 public:
  template <class... Args>
  explicit OwnTableOf(Args&&... args) : table_(std::forward<Args>(args)...), observer_{table_} {}
  [[nodiscard]] std::string file_name() const override { return std::string{O::file_name}; }
  [[nodiscard]] observe::Audience& observer() override { return observer_; }
  [[nodiscard]] TableSum sum() const override { return table_.sum(); }
  void persist(Archive& archive) override { archive(table_); }
  [[nodiscard]] O& table() { return table_; }

 private:
  O table_;
  observe::AudienceOf<O> observer_;
};

}  // namespace detail

/// The tables of these observers, for `trophic::experiment`.
template <class... Observers>
[[nodiscard]] OwnTables own_tables() {
  static_assert((OwnTable<Observers> && ...),
                "an own table is an observer with file_name, a constructor from (const std::filesystem::path&, Opening), "
                "persist(Archive&) and TableSum sum() const, and without on_frame, between_ticks, "
                "keep_running and cancels_tick; see trophic/io/own_table.hpp");
  return {[](const std::filesystem::path& folder, Opening opening) -> std::unique_ptr<AnyOwnTable> {
    return std::make_unique<detail::OwnTableOf<Observers>>(folder / std::string{Observers::file_name}, opening);
  }...};
}

}  // namespace trophic::io
