// SPDX-License-Identifier: MIT
// Own tables: observers that a program adds to its experiments, so that every run also writes their tables.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <trophic/io/csv_file.hpp>
#include <trophic/observe/audience.hpp>
#include <trophic/observe/hooks.hpp>

namespace trophic {
class Simulation;
}

namespace trophic::io {

/// The tables that runs write themselves, in the folder that own tables share with them.
inline constexpr std::array<std::string_view, 12> run_tables{"events.csv", "agents.csv",   "phylogeny.csv", "genomes.csv",
                                                             "senses.csv", "states.csv",   "genes.csv",     "bodies.csv",
                                                             "energy.csv", "resource.csv", "field.csv",     "changes.csv"};
[[nodiscard]] constexpr bool is_run_table(std::string_view file_name) {
  return std::ranges::find(run_tables, file_name) != run_tables.end();
}

/// An observer (trophic/observe/hooks.hpp) that writes one table into the folder of a run:
///
///   static constexpr std::string_view file_name = "distances.csv";  its own: ends in .csv and is none of run_tables
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

/// Whether tables of these names can be in one folder with those of a run.
template <class... Observers>
[[nodiscard]] consteval bool have_own_names() {
  const std::array<std::string_view, sizeof...(Observers)> names{Observers::file_name...};
  return std::ranges::all_of(names, [&](std::string_view name) {
    const bool is_plain = name.ends_with(".csv") && name.find('/') == std::string_view::npos;
    return is_plain && !is_run_table(name) && std::ranges::count(names, name) == 1;
  });
}

}  // namespace detail

/// The tables of these observers, for `trophic::experiment`.
template <class... Observers>
[[nodiscard]] OwnTables own_tables() {
  static_assert((OwnTable<Observers> && ...),
                "an own table is an observer with file_name, a constructor from (const std::filesystem::path&, Opening), "
                "persist(Archive&) and TableSum sum() const, and without on_frame, between_ticks, "
                "keep_running and cancels_tick; see trophic/io/own_table.hpp");
  if constexpr ((OwnTable<Observers> && ...)) {
    static_assert(detail::have_own_names<Observers...>(),
                  "the file_name of an own table must end in .csv, without a folder, and be neither that of another own table "
                  "nor that of a table of every run, such as events.csv; see run_tables in trophic/io/own_table.hpp");
  }
  return {[](const std::filesystem::path& folder, Opening opening) -> std::unique_ptr<AnyOwnTable> {
    return std::make_unique<detail::OwnTableOf<Observers>>(folder / std::string{Observers::file_name}, opening);
  }...};
}

}  // namespace trophic::io
