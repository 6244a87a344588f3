// SPDX-License-Identifier: MIT
// The question that each slot of a rule table answers, in an ecologist's words.
#pragma once

#include <array>
#include <string_view>
#include <trophic/rules/slots.hpp>

namespace trophic::command {

struct SlotText {
  std::string_view slot;
  std::string_view question;
  std::string_view policies;  ///< those that are shipped
};

/// In the order of a rule table.
inline constexpr std::array slot_texts{
    SlotText{"community", "Which species are there, how many of each, and who eats whom?", "food_chain predator_prey"},
    SlotText{"placement", "Where do robots stand at the start?", "scattered uniform_square"},
    SlotText{"embodiment", "How does a newborn's body take the place of the old one?", "keeps_body stands_up"},
    SlotText{"heading", "Which way does a body face?", "forward_axis_heading root_yaw_heading"},
    SlotText{"visibility", "Who perceives whom?", "all_active same_tag same_tag_if_active within_range"},
    SlotText{"sensors", "What does a brain get as inputs?",
             "list of: distance_over_diagonal distance_over_scale distance_over_terrain side_away_from_hunter side_of_adversary "
             "tag_ratio_of_active tag_ratio_of_all"},
    SlotText{"newborn_tag", "Which tag does a newborn show?", "keeps_body_tag random_tag"},
    SlotText{"tag_switch", "When may an individual change its tag?", "first_switch_free free_tags tag_cool_down tag_sampling"},
    SlotText{"brain", "How do inputs become a direction and a tag; is there learning in a lifetime?",
             "cognitive_brain cognitive_brain_with_biases cognitive_brain_zero_right cognitive_network feed_forward_brain "
             "growing_brain hebbian hebbian_brain recurrent_brain tanh_network"},
    SlotText{"steering", "How does a body turn towards a direction?", "no_steering targeted_steering"},
    SlotText{"gait", "By which gait does an individual walk?", "inherited_cpg inherited_cppn learnt named_gait robots_gait"},
    SlotText{"initial_genome", "Which genome does a founder or a random newcomer have?", "normal_weights uniform_weights"},
    SlotText{"genome_source", "Does a vacancy go to an offspring or to a random newcomer (immigration)?",
             "always_inherited random_or_inherited random_or_inherited_in_name"},
    SlotText{
        "parent", "Who becomes a parent?",
        "at_random by_cause fastest_escape killer last_escapee last_killer last_seen_victim most_escapes nearest_active_victim "
        "nearest_conspecific nearest_victim no_parent"},
    SlotText{"heredity", "What does an offspring inherit?", "all_but nothing_inherited own_copy shared_copy"},
    SlotText{"mutation", "How do genomes change between generations?", "no_mutation normal_mutation uniform_mutation"},
    SlotText{"body_plan", "With which body is an individual born?", "inherited_modules named_body one_body"},
    SlotText{"viability", "Which bodies may be born?", "always_viable module_limits survives_trial within_mass"},
    SlotText{"recruitment", "Who is born without a death, and which bodies are spare?", "after_escapes no_recruitment"},
    SlotText{"activation", "From when on is a newborn part of the ecology, to be seen and caught?",
             "active_away_from_hunters ages_once_away_from_hunters always_active founders_start_active"},
    SlotText{"capture", "Who is caught by whom?", "catch_closest catch_within_reach no_capture"},
    SlotText{"floor", "Below which number may no more of a species die?", "active_victim_floor no_floor victim_floor"},
    SlotText{"starvation", "Who starves, and when?", "choice exemption interval no_starvation procedure"},
    SlotText{"minimum_predators", "What happens when there are too few predators (minimum-predators rule)?",
             "no_minimum sacrifice_random_victim"},
    SlotText{"senescence", "Who dies of age or of an empty store of energy?",
             "energy_store no_senescence old_age old_age_of_victims"},
};

static_assert(slot_texts.size() == rules::slot_names.size());
static_assert([] {
  for (std::size_t i = 0; i < slot_texts.size(); ++i) {
    if (slot_texts[i].slot != rules::slot_names[i]) return false;
  }
  return true;
}());

}  // namespace trophic::command
