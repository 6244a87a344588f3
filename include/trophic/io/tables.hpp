// SPDX-License-Identifier: MIT
// The tables of a run: the rows of each of its CSV files.
#pragma once

#include <trophic/io/column.hpp>
#include <trophic/observe/event.hpp>
#include <trophic/population/individual.hpp>

namespace trophic::io {

/// The parents of an individual as the ALife data standard writes them: "[none]", "[7]" or "[7,9]".
[[nodiscard]] inline std::string ancestor_list_of(const Individual& individual) {
  if (individual.parents.empty()) return "[none]";
  std::string list;
  for (const IndividualId parent : individual.parents) list += (list.empty() ? '[' : ',') + std::to_string(parent);
  return list + ']';
}

/// events.csv: one row per event, in chronological order.
struct EventRow {
  double time_s = 0.0;
  std::int64_t tick = 0;
  observe::EventKind kind = observe::EventKind::birth;
  IndividualId id = 0;
  Species species = 0;
  BodyIndex body = 0;
  int tag = 1;
  bool active = true;
  Origin origin = Origin::random;
  std::optional<IndividualId> parent = {};
  std::uint64_t genome = 0;
  std::optional<Cause> cause = {};
  std::optional<IndividualId> killer = {};
  std::optional<IndividualId> victim = {};
  double x_m = 0.0;
  double y_m = 0.0;
  std::optional<std::string> ancestor_list = {};

  static constexpr auto columns() {
    return std::tuple{
        column("time_s", &EventRow::time_s, "s", "time by the ecology's clock", seconds),
        column("tick", &EventRow::tick, "", "index of the decision step; 0 at the start"),
        column("event", &EventRow::kind, "", "what happened"),
        column("id", &EventRow::id, "", "the individual concerned; for a catch, the hunter"),
        species_column("species", &EventRow::species, "species of the individual"),
        column("body", &EventRow::body, "", "the robot body in which the individual lives"),
        column("tag", &EventRow::tag, "", "the tag that the individual shows; after a switch, the new one"),
        column("active", &EventRow::active, "",
               "0 if hunters cannot perceive or catch the individual yet, although it perceives and walks; else 1"),
        column("origin", &EventRow::origin, "", "label of the individual's genome: random or inherited"),
        column("parent_id", &EventRow::parent, "", "the (first) parent; empty if there is none"),
        column("genome_id", &EventRow::genome, "",
               "the genome; several individuals have the same one if the rules share genomes"),
        column("cause", &EventRow::cause, "", "cause of a death"),
        column("killer_id", &EventRow::killer, "", "the hunter, if the individual was caught"),
        column("victim_id", &EventRow::victim, "", "the caught individual, for a catch"),
        column("x_m", &EventRow::x_m, "m", "position of the body", micro),
        column("y_m", &EventRow::y_m, "m", "position of the body", micro),
        column("ancestor_list", &EventRow::ancestor_list, "",
               "all parents, such as [none], [7] or [7,9]; the column exists only if the rule Recruitment may name several",
               {.if_any = true})};
  }
};

/// agents.csv: one row per robot and tick, after that tick's rules.
struct AgentRow {
  double time_s = 0.0;
  std::int64_t tick = 0;
  BodyIndex body = 0;
  IndividualId id = 0;
  Species species = 0;
  Origin origin = Origin::random;
  bool active = true;
  int tag = 1;
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_rad = 0.0;
  double target_angle_rad = 0.0;
  std::optional<IndividualId> adversary = {};
  std::optional<double> adversary_distance_m = {};
  std::optional<std::int64_t> hunger_ticks = {};
  std::optional<double> energy_J = {};
  NamedNumbers own = {};

  static constexpr auto columns() {
    return std::tuple{
        column("time_s", &AgentRow::time_s, "s", "time by the ecology's clock", seconds),
        column("tick", &AgentRow::tick, "", "index of the decision step; 0 at the start"),
        column("body", &AgentRow::body, "", "the robot body"),
        column("id", &AgentRow::id, "", "the individual that lives in the body"),
        species_column("species", &AgentRow::species, "species of the individual"),
        column("origin", &AgentRow::origin, "", "label of the individual's genome: random or inherited"),
        column("active", &AgentRow::active, "",
               "0 if hunters cannot perceive or catch the individual yet, although it perceives and walks; else 1"),
        column("tag", &AgentRow::tag, "", "the tag that the individual shows"),
        column("x_m", &AgentRow::x_m, "m", "position of the body", micro),
        column("y_m", &AgentRow::y_m, "m", "position of the body", micro),
        column("heading_rad", &AgentRow::heading_rad, "rad", "heading, counter-clockwise from the x axis, in (-pi, pi]", micro),
        column("target_angle_rad", &AgentRow::target_angle_rad, "rad",
               "target angle that the brain chose last, positive to the right", micro),
        column("adversary_id", &AgentRow::adversary, "", "the closest perceived member of an opposing species"),
        column("adversary_distance_m", &AgentRow::adversary_distance_m, "m", "distance to that adversary", micro),
        column("hunger_ticks", &AgentRow::hunger_ticks, "ticks",
               "ticks since birth or the last catch; empty for a species without prey"),
        column("energy_J", &AgentRow::energy_J, "J", "energy of the individual; only with a rule Metabolism",
               {.decimals = 6, .if_any = true}),
        named_columns("", &AgentRow::own,
                      "a heritable trait by its name, such as sight_m, or an act of the last decision other than turn and tag, "
                      "such as rest")};
  }
};

/// Outcome of the tag that a brain chose: the robot showed it already, shows it from now on, or the rules denied it.
enum class TagOutcome { kept, switched, denied };
[[nodiscard]] constexpr std::array<std::string_view, 3> enum_names(TagOutcome) {
  return {"kept", "switched", "denied"};
}

/// senses.csv: one row per robot and tick of agents.csv: contacts, and inputs and outputs of the brain.
struct SenseRow {
  double time_s = 0.0;
  std::int64_t tick = 0;
  BodyIndex body = 0;
  IndividualId id = 0;
  Species species = 0;
  std::optional<double> height_m = {};
  std::optional<double> tilt_rad = {};
  std::optional<bool> touches_wall = {};
  std::optional<std::int64_t> robots_touched = {};
  std::optional<bool> exempt = {};
  std::optional<int> chosen_tag = {};
  std::optional<TagOutcome> tag_outcome = {};
  std::optional<double> angle_output = {};
  std::optional<double> tag_output = {};
  NamedNumbers outputs = {};
  std::vector<double> inputs = {};

  static constexpr auto columns() {
    return std::tuple{
        column("time_s", &SenseRow::time_s, "s", "time by the ecology's clock", seconds),
        column("tick", &SenseRow::tick, "", "index of the decision step; 0 at the start"),
        column("body", &SenseRow::body, "", "the robot body"),
        column("id", &SenseRow::id, "", "the individual that lives in the body"),
        species_column("species", &SenseRow::species, "species of the individual"),
        column("height_m", &SenseRow::height_m, "m", "height of the root frame above z = 0; empty on a backend without joints",
               micro),
        column("tilt_rad", &SenseRow::tilt_rad, "rad",
               "angle between the root's z axis and the vertical: 0 upright, pi upside down; empty on a backend without joints",
               micro),
        column("touches_wall", &SenseRow::touches_wall, "",
               "whether the robot touches a wall or the foot of a slope; empty on a backend without joints"),
        column("robots_touched", &SenseRow::robots_touched, "",
               "number of other robots that it touches; empty on a backend without joints"),
        column("exempt", &SenseRow::exempt, "",
               "1 if the rule Starvation exempted the individual from starving at this tick; empty for a species without prey"),
        column("chosen_tag", &SenseRow::chosen_tag, "", "tag that the brain chose; empty if the brain made no decision"),
        column("tag_outcome", &SenseRow::tag_outcome, "",
               "outcome of that choice: kept (already shown), switched, or denied by the rule TagSwitch"),
        column("angle_output", &SenseRow::angle_output, "",
               "the brain's output for the act Turn; empty for a brain without output neurons and in a table without the act"),
        column("tag_output", &SenseRow::tag_output, "", "the brain's output for the act Tag"),
        named_columns("_output", &SenseRow::outputs,
                      "the brain's output for another act, such as effort_output; only for the acts of the table"),
        list_columns("input", &SenseRow::inputs, "",
                     "the brain's inputs, named by senses.inputs in the manifest; empty if the brain made no decision")};
  }
};

/// phylogeny.csv: one row per individual (taxon) in the ALife data standard, written when it dies; those alive at the end follow.
struct TaxonRow {
  IndividualId id = 0;
  std::string ancestor_list = {};
  std::optional<IndividualId> ancestor = {};
  double origin_time = 0.0;
  std::optional<double> destruction_time = {};
  Species species = 0;
  Origin origin = Origin::random;
  BodyIndex body = 0;
  std::uint64_t genome = 0;
  double mutation_distance = 0.0;
  int tag_at_birth = 1;
  std::optional<int> tag_at_death = {};
  std::optional<Cause> cause_of_death = {};
  std::optional<IndividualId> killer = {};
  std::optional<std::string> modules_text = {};

  static constexpr auto columns() {
    return std::tuple{
        column("id", &TaxonRow::id, "", "the individual"),
        column("ancestor_list", &TaxonRow::ancestor_list, "", "all parents, such as [none], [7] or [7,9]"),
        column("ancestor_id", &TaxonRow::ancestor, "",
               "the parent as a plain number, or its own id for a root; the column exists only if no individual can have several "
               "parents",
               {.if_any = true}),
        column("origin_time", &TaxonRow::origin_time, "s", "time of birth by the ecology's clock", seconds),
        column("destruction_time", &TaxonRow::destruction_time, "s", "time of death; inf if the individual lives at the end",
               {.none = "inf", .plain = true}),
        species_column("species", &TaxonRow::species, "species of the individual"),
        column("origin", &TaxonRow::origin, "", "label of the individual's genome: random or inherited"),
        column("body", &TaxonRow::body, "", "the robot body in which the individual lived"),
        column("genome_id", &TaxonRow::genome, "",
               "the genome; several individuals have the same one if the rules share genomes"),
        column("mutation_distance", &TaxonRow::mutation_distance, "",
               "Euclidean distance by which mutation moved the inherited weights; 0 if the weights were drawn at random"),
        column("tag_at_birth", &TaxonRow::tag_at_birth, "", "the tag at birth"),
        column("tag_at_death", &TaxonRow::tag_at_death, "", "the last tag shown; empty if the individual lives at the end"),
        column("cause_of_death", &TaxonRow::cause_of_death, "", "cause of death; empty if the individual lives at the end"),
        column("killer_id", &TaxonRow::killer, "", "the hunter, if the individual was caught"),
        column("modules_text", &TaxonRow::modules_text, "",
               "the body plan, as in bodies.csv; the column exists only if bodies differ", {.if_any = true})};
  }
};

/// genomes.csv: one row per birth. If genomes are shared, a later row with the same genome_id has the new weights of all its
/// individuals.
struct GenomeRow {
  IndividualId id = 0;
  std::uint64_t genome = 0;
  double time_s = 0.0;
  std::vector<double> weights = {};
  NamedNumbers traits = {};

  static constexpr auto columns() {
    return std::tuple{column("id", &GenomeRow::id, "", "the newborn individual"),
                      column("genome_id", &GenomeRow::genome, "", "the individual's genome"),
                      column("time_s", &GenomeRow::time_s, "s", "time by the ecology's clock", seconds),
                      list_columns("w", &GenomeRow::weights, "", "the weights at birth; none if brains grow"),
                      named_columns("", &GenomeRow::traits, "a heritable trait by its name, such as sight_m")};
  }
};

/// The parts of a genome.
enum class GenomePart { brain, gait, body };
[[nodiscard]] constexpr std::array<std::string_view, 3> enum_names(GenomePart) {
  return {"brain", "gait", "body"};
}

/// genes.csv: one row per gene of every newborn, for the parts that are not in genomes.csv.
struct GeneRow {
  IndividualId id = 0;
  GenomePart part = GenomePart::brain;
  std::size_t index = 0;
  double value = 0.0;

  static constexpr auto columns() {
    return std::tuple{column("id", &GeneRow::id, "", "the newborn individual"),
                      column("part", &GeneRow::part, "", "the part of the genome"),
                      column("index", &GeneRow::index, "", "index of the gene in that part, from 0"),
                      column("value", &GeneRow::value, "", "value of the gene at birth")};
  }
};

}  // namespace trophic::io
