#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""site_test.py ROOT OUT: the site builds without a warning, each policy has a card, and the checks find planted errors."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

ROOT, OUT = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
sys.path[:0] = [str(ROOT / "scripts/site"), str(ROOT / "tests/docs")]

import check_links  # noqa: E402
import pages  # noqa: E402
import rule_cards  # noqa: E402
import rule_pictures  # noqa: E402


def finds_broken_links() -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "a.html").write_text('<a href="b.html#here">1</a><a href="b.html#gone">2</a><img src="gone.png"><a href="https://x.org">3</a>')
        (folder / "b.html").write_text('<h1 id="here"></h1>')
        found = check_links.broken_links(folder)
        assert len(found) == 2 and "b.html#gone" in found[0] and "gone.png" in found[1], found


def refuses_a_rule_that_hides_its_draws() -> None:
    header = (ROOT / "include/trophic/death/floor/no_floor.hpp").read_text()
    with tempfile.TemporaryDirectory() as name:
        path = pathlib.Path(name) / "trophic/death/floor/no_floor.hpp"
        path.parent.mkdir(parents=True)
        path.write_text(header.replace("Random draws", "Draws"))
        try:
            rule_cards.read(path, pathlib.Path(name))
        except SystemExit as refusal:
            assert "does not say how many random numbers" in str(refusal), refusal
        else:
            raise AssertionError("a doc block without its random draws must be refused")


def cards_say_what_the_sources_say() -> None:
    include = ROOT / "include"
    card = rule_cards.read(include / "trophic/reproduction/mutation/normal_mutation.hpp", include)
    assert (card.type, card.name, card.slot) == ("NormalMutation", "normal_mutation", "mutation"), card
    assert card.params == [("sd", "0.05", "at_least(0.0)", "standard deviation")], card.params
    crowding = rule_cards.read(include / "trophic/death/starvation/interval/delayed_crowding_interval.hpp", include)
    assert crowding.params[0][:2] == ("base_ticks", "25"), crowding.params
    used = rule_cards.tables(include)
    assert used["NormalMutation"] == [("paper", "Mutation")] and ("released", "Mutation") in used["UniformMutation"], used
    policies = [p for kind in rule_cards.KINDS for p in (include / "trophic" / kind).rglob("*.hpp") if "string_view name" in p.read_text()]
    for path in policies:
        if "detail" not in path.parts and path.name not in ("contract.hpp", "list.hpp", "per_species.hpp", "cognitive_network.hpp"):
            assert rule_cards.read(path, include), f"{path} has no card"


def cards_are_used_as_they_say() -> None:
    include = ROOT / "include"
    slots, used = rule_cards.slots_of(include), rule_cards.tables(include)
    assert {"heredity", "tag_switch"} <= slots and not slots & {"sensors", "starvation"}, slots
    copy = rule_cards.read(include / "trophic/reproduction/heredity/shared_copy.hpp", include)
    assert "using Rules = trophic::with_heredity<trophic::rules::Paper, trophic::reproduction::heredity::SharedCopy>;" in rule_cards.use_of(copy, used, slots)
    mutation = rule_cards.read(include / "trophic/reproduction/mutation/normal_mutation.hpp", include)
    assert "trophic-predator-prey --set rules.mutation.sd=0.05" in rule_cards.use_of(mutation, used, slots)
    for path in include.glob("trophic/*/*/*.hpp"):
        card = path.parts[-3] in rule_cards.KINDS and rule_cards.read(path, include)
        if card:
            sentence = rule_cards.first_sentence(card)
            assert len(sentence) > 12 and sum(map(sentence.count, "([")) == sum(map(sentence.count, ")]")), f"{path}: {sentence}"


def pictures_are_drawn_from_the_headers() -> None:
    include = ROOT / "include"
    headers = [path for kind in rule_cards.KINDS for path in (include / "trophic" / kind).rglob("*.hpp") if "detail" not in path.parts]
    cards = [card for path in headers if (card := rule_cards.read(path, include))]
    drawn = {(card.slot, card.name): rule_pictures.picture_of(card) for card in cards}
    assert set(rule_pictures.PICTURES) <= set(drawn), set(rule_pictures.PICTURES) - set(drawn)
    for key in rule_pictures.PICTURES:
        root = xml.etree.ElementTree.fromstring(drawn[key][0])
        assert len(list(root)) > 4, key
    reach = next(card for card in cards if card.name == "catch_closest")
    assert "reach 1 m" in rule_pictures.picture_of(reach)[0]
    reach.params = [("reach_m", "0.25", "", "")]
    assert "reach 0.25 m" in rule_pictures.picture_of(reach)[0]


def a_site_inside_the_tree_is_not_read() -> None:
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        (root / "docs/how-to").mkdir(parents=True)
        (root / "docs/how-to/README.md").write_text("# How-tos\n")
        (root / "docs/references.bib").write_text("")
        (root / "README.md").write_text("# trophic\n")
        (root / "debian/site/pages").mkdir(parents=True)
        (root / "debian/site/pages/card.md").write_text("# A card\n\n![a picture of it](card.svg)\n")
        pages.write(root, root / "debian/site/pages", root / "debian/site/images", [])
        assert not list(root.rglob("*debian__site*"))


def search_offers_documents_alone() -> None:
    offered = "".join(path.read_text() for path in (OUT / "html/search").glob("*.js"))
    assert "../page_docs_tutorial.html" in offered and "../card_capture_catch_within_reach.html" in offered
    assert "_8md.html" not in offered and not list((OUT / "html").glob("*_8md.html"))


def main() -> int:
    a_site_inside_the_tree_is_not_read()
    pictures_are_drawn_from_the_headers()
    cards_are_used_as_they_say()
    finds_broken_links()
    refuses_a_rule_that_hides_its_draws()
    cards_say_what_the_sources_say()
    if not shutil.which("doxygen"):
        print("doxygen is not installed")
        return 77
    if code := subprocess.run([ROOT / "scripts/build-site", "--out", OUT]).returncode:
        return code
    search_offers_documents_alone()
    return 0


if __name__ == "__main__":
    sys.exit(main())
