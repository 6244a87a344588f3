# SPDX-License-Identifier: MIT
"""`trophic help`: the help of a command, the slots of a rule table and their policies as their headers document them, and the metrics."""
from __future__ import annotations

import os
import pathlib
import re
from collections.abc import Mapping
from typing import Any

from .errors import RunError
from .options import VERBS, did_you_mean, parsed
from .programs import find_program


def run(request: Mapping[str, Any]) -> int:
    """Prints the help of `topic`, or becomes the help of the program trophic."""
    topic = request["topic"]
    if topic in VERBS:
        parsed(topic, ["--help"])
    if topic is None or not re.fullmatch(r"\w+", topic):
        _help_of_trophic(topic)
    else:
        headers = include_folder()
        slots = slots_in(headers)
        topic = next((name for name in ("slots", "metrics", *slots) if _same(name, topic)), topic)
        if topic == "metrics":
            print(_metrics(), end="")
        elif topic in ("slots", *slots):
            print(
                "".join(slot_text(headers, slot, slots[slot]) for slot in ([topic] if topic in slots else slots)),
                end="",
            )
        elif text := card(topic, headers):
            print(text, end="")
        elif mistaken := did_you_mean(topic, ["slots", "metrics", *slots]):
            raise RunError(f"{topic}: must be a command, a slot, a policy, slots or metrics{mistaken}")
        else:
            _help_of_trophic(topic)
    return 0


def _same(name: str, word: str) -> bool:
    """Whether a word is a name, in any spelling: TagSwitch is tag_switch."""
    return name.replace("_", "").lower() == word.replace("_", "").lower()


def _help_of_trophic(command: str | None) -> None:
    program = find_program("trophic")
    os.execv(program, [program, *([command] if command else []), "--help"])


def include_folder() -> pathlib.Path:
    """The headers: those of the sources, or of an installed trophic. Raises RunError if there are none."""
    here = pathlib.Path(__file__).resolve()
    for folder in (here.parents[3] / "include", here.parents[4] / "include"):
        if (folder / "trophic").is_dir():
            return folder
    raise RunError("the headers of trophic are not installed")


def slots_in(headers: pathlib.Path) -> dict[str, str]:
    """The slots of a rule table, in its order, with the folders of their kinds."""
    return dict(
        re.findall(
            r"^  SLOT\(\w+, (\w+), (\w+),", (headers / "trophic/rules/slots.hpp").read_text(encoding="utf-8"), re.M
        )
    )


def slot_text(headers: pathlib.Path, slot: str, kind: str) -> str:
    """The decision of a slot, its policies, and how one is swapped."""
    folder = headers / "trophic" / kind / slot
    about = re.search(r"^// The contract of a slot: (.*)$", (folder / "contract.hpp").read_text(encoding="utf-8"), re.M)
    is_list = (folder / "list.hpp").exists()
    parts = [
        f"{'' if path.parent == folder else f'{path.parent.relative_to(folder)}: '}"
        f"{' '.join(sorted(other.stem for other in path.parent.glob('*.hpp') if other.stem not in ('contract', 'list')[:1 + is_list]))}"
        for path in sorted(folder.rglob("contract.hpp"), key=lambda path: (path.parent != folder, path))
    ]
    return (
        f"{slot} ({kind})\n  {about[1] if about else ''}\n  policies: {'list of: ' * is_list}{'; '.join(parts)}\n"
        f"  swap: with_{slot}<Table, Policy>; contract and policies: include/trophic/{kind}/{slot}/\n"
    )


def card(policy: str, headers: pathlib.Path) -> str:
    """The docstring in the header of a policy, by the name that tables have or that of its type, in any spelling; empty if no policy with a header
    of its own has it."""
    for path in sorted(headers.rglob("*.hpp")):
        text = path.read_text(encoding="utf-8")
        names = re.finditer(r'static constexpr std::string_view name = "(\w+)"', text)
        named = next((found for found in names if _same(found[1], policy)), None)
        documented = [
            found
            for found in re.finditer(r"((?:^///.*\n)+)(?:template.*\n)?(?:class|struct) (\w+)", text, re.M)
            if named and found.start() < named.start()
        ]
        if documented:
            lines, name = documented[-1].groups()
            return f"{named[1]} ({name}, {path.relative_to(headers)})\n" + re.sub(r"^/// ?", "", lines, flags=re.M)
    return ""


def _metrics() -> str:
    from .metrics import Web, living, names_of
    from .words import columns

    rows: dict[tuple[str, str], list[str]] = {}
    web = Web(["prey", "predator"], [("predator", "prey")])
    for name in [*names_of(web), *living.names(web, True)]:
        rows.setdefault((name.metric, name.unit), []).append(f"{name.species}:{name.group}")
    return (
        "METRIC:SPECIES:GROUP as --metric takes them, in a food web of prey and predators; docs/GLOSSARY.md defines them\n"
        + columns([("metric", "unit", "of"), *((*of, " ".join(groups)) for of, groups in rows.items())])
    )
