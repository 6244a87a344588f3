// SPDX-License-Identifier: MIT
// The rule tables of the study: a criterion for the reproduction of prey, with and without prey that age, with more room, and
// with one side that evolves alone.
#pragma once

#include <trophic/control/brain/growing_brain.hpp>
#include <trophic/reproduction/heredity/switched.hpp>
#include <trophic/reproduction/parent/fastest_escape.hpp>
#include <trophic/reproduction/parent/last_escapee.hpp>
#include <trophic/reproduction/parent/most_escapes.hpp>
#include <trophic/reproduction/recruitment/after_escapes.hpp>
#include <trophic/rules/by_species.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>
#include <trophic/rules/with_ageing_victims.hpp>

#include <trophic/worlds/pond.hpp>
#include "room.hpp"

namespace trophic::arms_race {

using reproduction::parent::FastestEscape;
using reproduction::parent::LastEscapee;
using reproduction::parent::MostEscapes;
using rules::Paper;
using rules::Released;

/// The table in which `Criterion` chooses the parent of the prey that follows a starved predator.
template <class Base, class Criterion>
using By = with_parent_after<Base, Cause::starved, Criterion>;

/// The same with prey that die of age. The nearest prey is the parent of the one that follows: a criterion about the predator
/// that dies says nothing about a prey that dies.
template <class Base, class Criterion>
using ByAgeing = with_ageing_victims<By<Base, Criterion>>;

/// Most escapes is about prey alone, so it also chooses the parent of the prey that follows a prey that died of age.
template <class Base>
using MostEscapesAgeing = with_ageing_victims<By<Base, MostEscapes>, MostEscapes>;

using PaperLastEscapee = named<By<Paper, LastEscapee>, "paper_last_escapee">;
using PaperMostEscapes = named<By<Paper, MostEscapes>, "paper_most_escapes">;
using PaperFastestEscape = named<By<Paper, FastestEscape>, "paper_fastest_escape">;
using PaperAgeing = named<with_ageing_victims<Paper>, "paper_ageing">;
using PaperLastEscapeeAgeing = named<ByAgeing<Paper, LastEscapee>, "paper_last_escapee_ageing">;
using PaperMostEscapesAgeing = named<MostEscapesAgeing<Paper>, "paper_most_escapes_ageing">;
using PaperFastestEscapeAgeing = named<ByAgeing<Paper, FastestEscape>, "paper_fastest_escape_ageing">;

using ReleasedMostEscapes = named<By<Released, MostEscapes>, "released_most_escapes">;
using ReleasedAgeing = named<with_ageing_victims<Released>, "released_ageing">;
using ReleasedMostEscapesAgeing = named<MostEscapesAgeing<Released>, "released_most_escapes_ageing">;

/// Prey reproduce by escaping, into spare bodies.
using PaperAfterEscapes = named<with_recruitment<Paper, reproduction::recruitment::AfterEscapes>, "paper_after_escapes">;

using PaperRoom = named<WithRoom<Paper>, "paper_room">;
using PaperMostEscapesRoom = named<WithRoom<PaperMostEscapes>, "paper_most_escapes_room">;

/// One side may evolve against another that does not: `rules.heredity.prey.inherited=false`.
template <class Base>
using BySide = with_heredity<Base, rules::by_species<reproduction::heredity::Switched<typename Base::Heredity>>>;

using PaperBySide = named<BySide<Paper>, "paper_by_side">;
using ReleasedBySide = named<BySide<Released>, "released_by_side">;
using PondBySide = named<BySide<worlds::Pond>, "pond_by_side">;

/// Nine senses, and neurons and links that evolve from the paper's three neurons.
using GrowingBySide =
    named<BySide<with_brain<with_sensors<Paper, RoomySensors>, control::brain::GrowingBrain>>, "growing_by_side">;

}  // namespace trophic::arms_race
