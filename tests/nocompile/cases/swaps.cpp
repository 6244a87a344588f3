// SPDX-License-Identifier: MIT
// Rules swapped in a table.
#include <trophic/backend/kinematic.hpp>
#include <trophic/death/senescence/old_age.hpp>
#include <trophic/death/starvation/exemption/no_exemption.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/reproduction/mutation/uniform_mutation.hpp>
#include <trophic/reproduction/parent/nearest_victim.hpp>
#include <trophic/rules/by_species.hpp>
#include <trophic/rules/paper.hpp>

using trophic::perception::sensors::SideOfAdversary;
using trophic::rules::Paper;

struct Merciful {
  static constexpr std::string_view name = "merciful";
  double within_m = 3.0;
  bool is_exempt(trophic::BodyIndex, const trophic::View&, const trophic::perception::Perceives&) const { return within_m > 1.0; }
};

using Mutating = trophic::with_mutation<Paper, trophic::reproduction::mutation::UniformMutation>;
using Ageing = trophic::with_senescence<Paper, trophic::death::senescence::OldAge>;
using Five = trophic::with_params<Paper, [](auto& params) { params.floor.floor = 5; }>;
using EachItsOwn = trophic::with_floor<Paper, trophic::rules::by_species<trophic::death::floor::VictimFloor>>;
using Killers = trophic::with_parent<Paper, trophic::reproduction::parent::Killer>;
using Sensing = trophic::with_sensors<Paper, trophic::perception::sensors::List<SideOfAdversary>>;
using Catching = trophic::with_capture<Paper, Paper::Capture>;
using Spared = trophic::with_starvation_exemption<Catching, trophic::death::starvation::exemption::NoExemption>;

int main() {
  trophic::Ecology<Spared> ecology{{}, trophic::backend::Kinematic::Params{}};
  ecology.run_until(10.0);
  static_cast<void>(trophic::RuleParams<EachItsOwn>{});
  static_cast<void>(sizeof(trophic::with_parent<Killers, trophic::reproduction::parent::NearestVictim>));
  static_cast<void>(trophic::RuleParams<Sensing>{});
  return trophic::RuleParams<Five>{}.floor.floor == 5 ? 0 : 1;
}
