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
};

/// In the order of a rule table.
inline constexpr std::array slot_texts{
    SlotText{"community", "Which species are there, how many of each, and who eats whom?"},
    SlotText{"placement", "Where do robots stand at the start?"},
    SlotText{"embodiment", "How does a newborn's body take the place of the old one?"},
    SlotText{"heading", "Which way does a body face?"},
    SlotText{"visibility", "Who perceives whom?"},
    SlotText{"sensors", "What does a brain get as inputs?"},
    SlotText{"newborn_tag", "Which tag does a newborn show?"},
    SlotText{"tag_switch", "When may an individual change its tag?"},
    SlotText{"acts", "What can an individual decide besides where to go and which tag to show?"},
    SlotText{"brain", "How do inputs become a direction and a tag; is there learning in a lifetime?"},
    SlotText{"steering", "How does a body turn towards a direction?"},
    SlotText{"gait", "By which gait does an individual walk?"},
    SlotText{"pace", "How fast does an individual walk?"},
    SlotText{"initial_genome", "Which genome does a founder or a random newcomer have?"},
    SlotText{"genome_source", "Does a vacancy go to an offspring or to a random newcomer (immigration)?"},
    SlotText{"parent", "Who becomes a parent?"},
    SlotText{"heredity", "What does an offspring inherit?"},
    SlotText{"mutation", "How do genomes change between generations?"},
    SlotText{"body_plan", "With which body is an individual born?"},
    SlotText{"viability", "Which bodies may be born?"},
    SlotText{"traits", "Which numbers of an individual are inherited besides its brain, gait and body?"},
    SlotText{"recruitment", "Who is born without a death, and who dies without a birth?"},
    SlotText{"activation", "From when on is a newborn part of the ecology, to be seen and caught?"},
    SlotText{"capture", "Who is caught by whom?"},
    SlotText{"floor", "Below which number may no more of a species die?"},
    SlotText{"starvation", "Who starves, and when?"},
    SlotText{"minimum_predators", "What happens when there are too few predators (minimum-predators rule)?"},
    SlotText{"senescence", "Who dies of age or of an empty store of energy?"},
    SlotText{"metabolism", "What does living cost, and what does an eater get?"},
    SlotText{"resource", "Where does food grow?"},
};

static_assert(slot_texts.size() == rules::slot_names.size());
static_assert([] {
  for (std::size_t i = 0; i < slot_texts.size(); ++i) {
    if (slot_texts[i].slot != rules::slot_names[i]) return false;
  }
  return true;
}());

}  // namespace trophic::command
