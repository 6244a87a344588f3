# SPDX-License-Identifier: MIT
"""`trophic help POLICY`: the docstring of a policy's header, in the terminal."""
from __future__ import annotations

import pathlib
import re
from collections.abc import Mapping
from typing import Any

from .runs import RunError


def include_folder() -> pathlib.Path:
    """The headers: those of the sources, or of an installed trophic. Raises RunError if there are none."""
    here = pathlib.Path(__file__).resolve()
    for folder in (here.parents[3] / "include", here.parents[4] / "include"):
        if (folder / "trophic").is_dir():
            return folder
    raise RunError("the headers of trophic are not installed")


def card(policy: str, headers: pathlib.Path) -> str:
    """The docstring in the header of a policy, by the name that tables have. Raises RunError for a policy without a header of its own."""
    for path in sorted(headers.rglob("*.hpp")):
        text = path.read_text()
        named = re.search(rf'static constexpr std::string_view name = "{re.escape(policy)}"', text)
        documented = [found for found in re.finditer(r"((?:^///.*\n)+)(?:template.*\n)?(?:class|struct) (\w+)", text, re.M)
                      if named and found.start() < named.start()]
        if documented:
            lines, name = documented[-1].groups()
            about = re.sub(r"^/// ?", "", lines, flags=re.M)
            return f"{policy} ({name}, {path.relative_to(headers)})\n{about}"
    raise RunError(f"{policy}: has no header of its own; `trophic help slots` lists the folders of the slots")


def run(request: Mapping[str, Any]) -> int:
    """Prints the card of `policy`."""
    print(card(request["policy"], include_folder()), end="")
    return 0
