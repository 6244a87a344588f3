# SPDX-License-Identifier: MIT
"""references.bib as a page, and [key] in other pages as a link to it."""

import pathlib
import re


def entries(root: pathlib.Path) -> dict[str, dict[str, str]]:
    """Key -> field -> text."""
    found = {}
    for entry in re.split(r"^@\w+\{", (root / "docs/references.bib").read_text(), flags=re.MULTILINE)[1:]:
        key, rest = entry.split(",", 1)
        fields = re.findall(r"^  (\w+) = \{(.*?)\},$", rest, re.MULTILINE | re.DOTALL)
        found[key] = {name: re.sub(r"[{}]", "", " ".join(re.sub(r"\\'e", "é", text).split())) for name, text in fields}
    return found


def linked(text: str, keys: set[str]) -> str:
    return re.sub(r"\[([a-z]+\d{4}[a-z]?)\](?!\()", lambda m: f"[[{m[1]}]](@ref ref_{m[1]})" if m[1] in keys else m[0], text)


def page(root: pathlib.Path) -> str:
    lines = ["References {#page_references}", "=" * 20, "", "The sources that the code and these pages cite, from `references.bib`.", ""]
    for key, entry in sorted(entries(root).items()):
        where = entry.get("journal") or entry.get("booktitle") or entry.get("publisher", "")
        address = f"https://doi.org/{entry['doi']}" if "doi" in entry else entry.get("url")
        authors = entry["author"].replace(" and ", "; ")
        lines += [f"## {key} {{#ref_{key}}}", "", f"{authors} ({entry['year']}). {entry['title']}. {where}.", ""]
        if address:
            lines += [f"<{address}>", ""]
    return "\n".join(lines)
