# SPDX-License-Identifier: MIT
"""Body plans as texts, such as core[front:hinge0[front:brick1]], and how far apart two are."""
from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple, NoReturn

_FACES = ("front", "back", "left", "right")


class Plan(NamedTuple):
    """The modules of a plan in postorder, as the algorithm of Zhang and Shasha numbers them."""

    labels: list[str]
    """type, face and quarter turns"""
    leftmost: list[int]
    """of each module: the first leaf of its subtree"""
    keyroots: list[int]
    """the root, and each module with a sibling before it, ascending"""


def read_plan(text: str) -> Plan:
    """Raises ValueError, a sentence, for another text."""
    words = re.findall(r"[\[\] ]|[^\[\] ]+", text)
    root: tuple[str, list] = ("core", [])
    opened: list[tuple[str, list]] = []
    last, before = root, words[0] if words else ""

    def refuse(at: int, must: str) -> NoReturn:
        raise ValueError(
            f'body plan "{text[:60]}{"..." if len(text) > 60 else ""}", character {len("".join(words[:at])) + 1}: must be {must}'
        )

    if before != "core":
        refuse(0, "core")
    for at, word in enumerate(words[1:], 1):
        if before in ("[", " "):
            if not re.fullmatch(rf"({'|'.join(_FACES)}):(hinge|brick)[0-3]", word):
                refuse(at, "FACE:hinge or FACE:brick with quarter turns of 0 to 3")
            last = (word, [])
            opened[-1][1].append(last)
        elif word == "[" and before != "]":
            opened.append(last)
        elif word == "]" and opened:
            opened.pop()
        elif word != " " or not opened:
            refuse(at, "] or a space" if opened else "[ or the end")
        before = word
    if opened:
        refuse(len(words), "] or a space")
    labels: list[str] = []
    leftmost: list[int] = []
    waiting: list[tuple[tuple[str, list], int | None]] = [(root, None)]
    while waiting:
        (label, children), first = waiting.pop()
        if first is not None:
            labels.append(label)
            leftmost.append(first)
            continue
        waiting.append(((label, children), len(labels)))
        waiting += [
            (child, None)
            for child in sorted(children, key=lambda child: _FACES.index(child[0].split(":")[0]), reverse=True)
        ]
    last_of = {first: place for place, first in enumerate(leftmost)}
    return Plan(labels, leftmost, sorted(last_of.values()))


def edit_distance(a: Plan, b: Plan) -> int:
    """The tree edit distance of two plans: the fewest modules that are inserted, deleted or changed to make one plan of the other, each at cost 1. A
    deleted module's children become its parent's; a change replaces type, face and quarter turns at once. Trees are ordered by face [zhang1989].
    """
    trees = [[0] * len(b.labels) for _ in a.labels]  # distance of the subtrees of i and j
    for root_a in a.keyroots:
        for root_b in b.keyroots:
            from_a, from_b = a.leftmost[root_a], b.leftmost[root_b]
            forests = [list(range(root_b - from_b + 2))]  # of what precedes i and j in the subtrees at hand
            for i in range(from_a, root_a + 1):
                before, row = forests[-1], [forests[-1][0] + 1]
                for j in range(from_b, root_b + 1):
                    less = min(before[j - from_b + 1], row[-1]) + 1
                    if a.leftmost[i] == from_a and b.leftmost[j] == from_b:
                        trees[i][j] = min(less, before[j - from_b] + (a.labels[i] != b.labels[j]))
                        row.append(trees[i][j])
                    else:
                        row.append(min(less, forests[a.leftmost[i] - from_a][b.leftmost[j] - from_b] + trees[i][j]))
                forests.append(row)
    return trees[-1][-1]


def distances_from_first(ids: Sequence[int], species: Sequence[str], texts: Sequence[str]) -> list[int]:
    """The distance of each individual's plan from that of the first individual of its species, the one with the lowest id. Raises ValueError, naming
    the individual, for a text that is not a plan."""
    first: dict[str, Plan] = {}
    known: dict[tuple[str, str], int] = {}
    for one, its, text in sorted(zip(ids, species, texts)):
        if (its, text) not in known:
            try:
                plan = read_plan(text)
            except ValueError as error:
                raise ValueError(f"id {one}: {error}") from None
            known[its, text] = edit_distance(first.setdefault(its, plan), plan)
    return [known[its, text] for its, text in zip(species, texts)]
