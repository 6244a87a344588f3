# SPDX-License-Identifier: MIT
"""Attribution: which share of what a species does or suffers falls to those who inherited their genome."""
from __future__ import annotations

import numpy
import pandas

from .tables import Results, Web

NEWBORN_THAT_INHERIT = 2.0 / 3.0
"""The paper compares both attributions with the share of the newborn that inherit (Sec. "Attribution")."""


def caught(events: pandas.DataFrame, species: str) -> float:
    """The inherited among the members of a species that were caught (Eq. 4); lower is better. nan without a catch."""
    return _inherited(events[(events.event == "death") & (events.cause == "caught") & (events.species == species)])


def died(events: pandas.DataFrame, species: str) -> float:
    """The inherited among the dead of any cause. The authors' log of deaths names no cause, so this is what it gives for prey."""
    return _inherited(events[(events.event == "death") & (events.species == species)])


def catches(events: pandas.DataFrame, species: str) -> float:
    """Catches made by inherited members of a species, among its catches; higher is better. nan without a catch."""
    return _inherited(events[(events.event == "catch") & (events.species == species)])


def catchers(events: pandas.DataFrame, species: str) -> float:
    """The inherited among the members of a species that ever caught one (Eq. 5, as the paper's text says)."""
    return _inherited(events[(events.event == "catch") & (events.species == species)].drop_duplicates("id"))


def credited(events: pandas.DataFrame, web: Web, hunter: str) -> float:
    """The share of the deaths of a hunter's prey that are attributed to an inherited hunter as in the authors' log: to the occupant of the
    body that last caught the prey's body. A sacrifice has such a killer too; a body that was never caught has body 1. The published 0.725
    for predators is this share. nan without such a death."""
    row = numpy.arange(len(events))
    body, victim = events.body.to_numpy(), events.victim_id.to_numpy(float)
    is_birth = (events.event == "birth").to_numpy()
    home = pandas.Series(body[is_birth], index=events.id[is_birth])
    home = home[~home.index.duplicated(keep="last")]
    caught_body = home.reindex(victim).to_numpy(float)
    catch = numpy.flatnonzero((events.event == "catch").to_numpy() & ~numpy.isnan(caught_body))
    victims = [eaten for eater, eaten in web.links if eater == hunter]
    death = numpy.flatnonzero((events.event == "death").to_numpy() & events.species.isin(victims).to_numpy())
    last = _last_before(caught_body[catch].astype(int), row[catch], body[death], row[death])
    killer = numpy.where(last >= 0, body[catch[last]] if len(catch) else 1, 1)
    births = row[is_birth]
    occupant = _last_before(body[is_birth], births, killer, row[death])
    inherited = (events.origin == "inherited").to_numpy()[births[occupant[occupant >= 0]]]
    return float(inherited.mean()) if len(inherited) else float("nan")


def measure(events: pandas.DataFrame, of_free: pandas.DataFrame, web: Web, results: Results) -> None:
    """`of_free`: the events of robots that are not locked."""
    two_thirds = (("two_thirds", "paper", NEWBORN_THAT_INHERIT),)
    for species in web.species:
        if web.is_hunted(species):
            results.add("attribution_caught", species, "all", "1", caught(events, species), two_thirds)
            results.add("attribution_caught_not_locked", species, "all", "1", caught(of_free, species))
            results.add("attribution_died", species, "all", "1", died(events, species), two_thirds)
        if web.hunts(species):
            results.add("attribution_catches", species, "all", "1", catches(events, species), two_thirds)
            results.add("attribution_catches_not_locked", species, "all", "1", catches(of_free, species))
            results.add("attribution_catchers", species, "all", "1", catchers(events, species), two_thirds)
            results.add("attribution_credited", species, "all", "1", credited(events, web, species), two_thirds)


def _inherited(events: pandas.DataFrame) -> float:
    return float((events.origin == "inherited").mean()) if len(events) else float("nan")


def _last_before(
    keys: numpy.ndarray, rows: numpy.ndarray, of_keys: numpy.ndarray, before: numpy.ndarray
) -> numpy.ndarray:
    """For each key and row the place of the last entry with that key in an earlier row; -1 if there is none."""
    if len(keys) == 0:
        return numpy.full(len(of_keys), -1)
    width = max(int(rows.max()), int(before.max()) if len(before) else 0) + 1
    order = numpy.argsort(keys * width + rows)
    place = numpy.searchsorted((keys * width + rows)[order], of_keys * width + before) - 1
    found = order[numpy.maximum(place, 0)]
    return numpy.where((place >= 0) & (keys[found] == of_keys), found, -1)
