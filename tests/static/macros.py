#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""macros.py ROOT: every macro that the library defines is in this table, with the reason why no template, concept or constexpr can serve, and
every entry is defined somewhere. Prints each offence; exit 0 kept, 1 broken."""

import fnmatch
import pathlib
import re
import sys

FOLDERS = ("include", "backends")

# Names and texts that follow from one list cannot be made otherwise: a template cannot name a member, a type or a file of its own accord, and
# the text of a static_assert must be a literal.
LIST = "one list from which names follow, each of them written once"
NAMES = "declares something named after an entry of the list, which a template cannot"
TEXT = "puts the name of an entry into the text of a static_assert, which must be a literal"
REASONS = {
    "TROPHIC_RULE_SLOTS": LIST,
    "TROPHIC_STATE_HOOKS": LIST,
    "TROPHIC_OBSERVER_HOOKS": LIST,
    "TROPHIC_ENUMERATOR": NAMES,
    "TROPHIC_SLOT_NAME": "makes the text of a slot's name, which only the preprocessor has",
    "TROPHIC_SLOT_KIND": "makes the text of a kind's name, which only the preprocessor has",
    "TROPHIC_MEMBER": "the only place where a slot's value leads to the member of its name",
    "TROPHIC_STATED": NAMES + ": asks whether a table has a type of this name",
    "TROPHIC_SLOT": NAMES + ": a concept cannot be passed as a template argument",
    "TROPHIC_ALIAS": NAMES,
    "TROPHIC_WITH": NAMES,
    "TROPHIC_NUMBERS": NAMES + "; members with designated initialisers cannot be inherited",
    "TROPHIC_POLICY": NAMES,
    "TROPHIC_STATES": NAMES,
    "TROPHIC_NOTIFY_SENSORS": NAMES,
    "TROPHIC_NOTIFY_LISTS": NAMES,
    "TROPHIC_PROBE*": NAMES + ": whether a class has any member of a name",
    "TROPHIC_ANY_HOOK": "joins concepts that TROPHIC_PROBE names",
    "TROPHIC_CHECK_SLOT": TEXT,
    "TROPHIC_CHECK_STATE": TEXT,
    "TROPHIC_CHECK_STATE_OF": TEXT,
    "TROPHIC_CHECK_STATE_HOOK": TEXT,
    "TROPHIC_CHECK_HOOK": TEXT,
    "TROPHIC_NO_SLOT": TEXT,
    "TROPHIC_SENTENCE_*": "a contract's sentence next to its concept, joined with other literals in a static_assert",
    "TROPHIC_HEADER_ONLY": "decides which files are included",
    "TROPHIC_INLINE": "a specifier that is there or not, for definitions that are included or compiled",
    "TROPHIC_LANES": "the namespace into which a source of the kernel is compiled, once with four lanes and once with eight",
    "TROPHIC_LANES_INLINE": "an attribute and a specifier in one, for every function of the kernel",
    "R123_USE_*": "a setting of Random123, which its headers read",
    "TOML_ASSERT": "a setting of toml++, which its headers read",
    "TROPHIC_MODEL_DIR": "given by the build or an installed header: where the models lie",
}


def main() -> int:
    root = pathlib.Path(sys.argv[1])
    defined: dict[str, str] = {}
    for path in sorted(path for folder in FOLDERS for path in (root / folder).rglob("*") if path.suffix in (".hpp", ".ipp", ".cpp", ".h")):
        for number, line in enumerate(path.read_text().splitlines(), 1):
            if found := re.match(r"\s*#\s*define\s+(\w+)", line):
                defined.setdefault(found[1], f"{path.relative_to(root)}:{number}")
    offences = [
        f"{where}: {name}: write a template, a concept or a constexpr, or its reason into tests/static/macros.py"
        for name, where in defined.items()
        if not any(fnmatch.fnmatchcase(name, known) for known in REASONS)
    ]
    offences += [f"tests/static/macros.py: {known} is defined nowhere" for known in REASONS if not fnmatch.filter(defined, known)]
    print("\n".join(offences) or f"{len(defined)} macros, each with a reason")
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main())
