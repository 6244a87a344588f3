// SPDX-License-Identifier: MIT
// Rules that an experiment would never ask are refused..
#include <doctest/doctest.h>

#include <support/toy_bodies.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/control/gait/inherited_cpg.hpp>
#include <trophic/control/gait/inherited_cppn.hpp>
#include <trophic/control/gait/learnt.hpp>
#include <trophic/control/gait/named_gait.hpp>
#include <trophic/control/steering/no_steering.hpp>
#include <trophic/ecology/checked_experiment.hpp>
#include <trophic/ecology/describe.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/habitat/load/installed_models.hpp>
#include <trophic/initialization/embodiment/stands_up.hpp>
#include <trophic/perception/heading/reversed_on_back.hpp>
#include <trophic/perception/heading/root_yaw_heading.hpp>
#include <trophic/reproduction/body_plan/inherited_modules.hpp>
#include <trophic/reproduction/body_plan/named_body.hpp>
#include <trophic/reproduction/heredity/all_but.hpp>
#include <trophic/reproduction/viability/module_limits.hpp>
#include <trophic/reproduction/viability/survives_trial.hpp>
#include <trophic/reproduction/viability/within_mass.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

using namespace trophic;
using rules::Paper;
namespace gait = control::gait;
namespace birth = reproduction;

namespace {

/// The words of the refusal of a table on a backend; empty if it is accepted.
template <class Rules>
std::string refusal(const BackendChoice& backend) {
  try {
    static_cast<void>(load_checked(Experiment<Rules>{}, backend, TROPHIC_MODEL_DIR));
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

template <class... Tables>
void check_refused(const BackendChoice& backend, const std::string& rule) {
  for (const std::string& words : {refusal<Tables>(backend)...}) {
    CHECK(words.find(": must be ") != std::string::npos);
    CHECK(words.find(rule) != std::string::npos);
  }
}

template <class Rules>
std::vector<std::string> remarks(const BackendChoice& backend) {
  const auto checked = load_checked(Experiment<Rules>{}, backend, TROPHIC_MODEL_DIR);
  auto found = describe(checked.params, backend, checked.habitat, 1.0).remarks;
  std::erase_if(found, [](const std::string& remark) { return remark.starts_with("physics"); });
  return found;
}

}  // namespace

TEST_CASE("effects: rule that would never be asked -> refused by a sentence that names slot, policy and what it needs") {
  const BackendChoice points = backend::Kinematic::Params{};
  const BackendChoice joints = test::ToyBodies::Params{};
  CHECK(refusal<with_steering<Paper, control::steering::NoSteering>>(points) ==
        "rules.steering = no_steering on backend kinematic: must be a backend with joints; without joints robots turn as in "
        "their measured walk, which uses targeted_steering");
  CHECK(refusal<with_steering<Paper, control::steering::NoSteering>>(joints) == "");
  check_refused<with_gait<Paper, gait::InheritedCpg>, with_gait<Paper, gait::InheritedCppn>, with_gait<Paper, gait::NamedGait>,
                with_gait<Paper, gait::Learnt<gait::InheritedCpg>>>(points, "rules.gait = ");
  for (const BackendChoice& backend : {points, joints}) {
    CHECK(refusal<Paper>(backend) == "");
    check_refused<with_embodiment<Paper, initialization::embodiment::StandsUp>>(backend, "rules.embodiment = stands_up");
    check_refused<with_viability<Paper, birth::viability::ModuleLimits>, with_viability<Paper, birth::viability::WithinMass>,
                  with_viability<Paper, birth::viability::SurvivesTrial<birth::viability::AlwaysViable>>>(backend,
                                                                                                          "rules.viability = ");
    check_refused<with_heredity<Paper, birth::heredity::AllButGait>, with_heredity<Paper, birth::heredity::AllButBody>>(
        backend, "rules.heredity = all_but_");
    CHECK(refusal<with_heredity<Paper, birth::heredity::AllButBrain>>(backend) == "");
  }
  using Walking = with_embodiment<with_gait<Paper, gait::InheritedCppn>, initialization::embodiment::StandsUp>;
  using Grown = with_body_plan<Walking, birth::body_plan::InheritedModules>;
  check_refused<Grown, with_body_plan<Walking, birth::body_plan::NamedBody>>(points, "rules.body_plan = ");
  CHECK(refusal<with_heredity<Grown, birth::heredity::AllButBody>>(joints) == "");
  CHECK(refusal<with_viability<Grown, birth::viability::ModuleLimits>>(joints) == "");
  check_refused<with_viability<with_body_plan<Walking, birth::body_plan::NamedBody>, birth::viability::ModuleLimits>>(
      joints, "rules.viability = module_limits");
}

TEST_CASE("effects: swapped heading of robots that stand upright -> a remark, with joints none") {
  using Yaw = with_heading<Paper, perception::heading::RootYawHeading>;
  using Back = with_heading<Paper, perception::heading::ReversedOnBack<perception::heading::RootYawHeading>>;
  const BackendChoice points = backend::Kinematic::Params{};
  CHECK(remarks<Yaw>(points) ==
        std::vector<std::string>{"rules.heading = root_yaw_heading has no effect: robots of kinematic stand upright"});
  CHECK(remarks<Back>(points).size() == 1);
  CHECK(remarks<Yaw>(test::ToyBodies::Params{}).empty());
  CHECK(remarks<Paper>(points).empty());
  CHECK(remarks<rules::Released>(points).empty());
}
