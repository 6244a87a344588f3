// SPDX-License-Identifier: MIT
// bodies.csv: the body of every individual, if bodies differ.
#pragma once

#include <trophic/habitat/body/build.hpp>
#include <trophic/habitat/body/descriptors.hpp>
#include <trophic/habitat/body/distance.hpp>
#include <trophic/habitat/body/plan.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/io/csv_file.hpp>
#include <trophic/observe/event.hpp>
#include <trophic/population/view.hpp>

namespace trophic::io {

/// Writes a row per birth. A plan is a tree of modules; plans are numbered from 0 in the order of their first births.
class BodyLog {
 public:
  static constexpr std::string_view file_name = "bodies.csv";

  BodyLog(const std::filesystem::path& path, Opening opening) : file_{path, header_of(columns()), opening} {}

  void on_event(const observe::Event& event, const View& view) {
    if (event.kind != observe::EventKind::birth) return;
    const Phenotype& own = view.phenotypes[event.body];
    const body::ModuleTree& tree = own.design->modules;
    const std::string text = body::text_of(tree);
    const auto found = std::ranges::find(plans_, text);
    const auto plan = static_cast<std::uint64_t>(found - plans_.begin());
    if (found == plans_.end()) plans_.push_back(text);
    const IndividualId id = event.individual.id;
    if (plan_of_.size() <= id) plan_of_.resize(id + 1);
    plan_of_[id] = plan;
    std::string& row = file_.buffer();
    const auto add = [&](const auto& cell) {
      detail::append_cell(row, cell);
      row.push_back(',');
    };
    add(id);
    detail::append_cell(row, view.time_s, seconds);
    row.push_back(',');
    add(view.web.name(event.individual.species));
    add(plan);
    const auto parent = event.individual.parent();
    const bool has_parent = parent && *parent < plan_of_.size();
    add(has_parent ? std::optional{plan_of_[*parent]} : std::nullopt);
    add(has_parent ? std::optional{distance(plan_of_[*parent], plan, tree)} : std::nullopt);
    add(text);
    add(tree.modules().size());
    add(body::count(tree, body::ModuleType::hinge));
    add(body::count(tree, body::ModuleType::brick));
    add(own.robot->mass_kg());
    add(own.robot->bounding_radius_m);
    const body::Descriptors shape = body::descriptors_of(tree, full_size);
    for_each_field(shape, [&](const auto&, const double& value) { add(value); });
    row.back() = '\n';
  }
  void on_tick(const View&) { file_.flush(); }

  void persist(Archive& archive) { archive(file_, plans_, plan_of_); }
  [[nodiscard]] TableSum sum() const { return file_.sum(columns()); }

  /// The number of modules to which the descriptor `size` refers.
  static constexpr std::size_t full_size = 20;

 private:
  [[nodiscard]] static std::vector<TypedColumn> columns() {
    std::vector<TypedColumn> all{
        {"id", "int64"},          {"time_s", "double"},       {"species", "string"},      {"plan", "int64"},
        {"parent_plan", "int64"}, {"edit_distance", "int64"}, {"modules_text", "string"}, {"modules", "int64"},
        {"hinges", "int64"},      {"bricks", "int64"},        {"mass_kg", "double"},      {"reach_m", "double"}};
    const body::Descriptors shape;
    for_each_field(shape, [&](const auto& field, const double&) { all.emplace_back(field.name, "double"); });
    return all;
  }

  [[nodiscard]] std::size_t distance(std::uint64_t parents, std::uint64_t own, const body::ModuleTree& tree) const {
    return parents == own ? 0 : body::edit_distance(body::read_plan(plans_[parents]), tree);
  }

  LineFile file_;
  std::vector<std::string> plans_;
  std::vector<std::uint64_t> plan_of_;  ///< one per individual
};

}  // namespace trophic::io
