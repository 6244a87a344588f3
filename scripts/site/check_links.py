# SPDX-License-Identifier: MIT
"""Every local link of a folder of HTML pages leads to a file that is there, and to an anchor that is in it."""

import functools
import html
import pathlib
import re
import urllib.parse


@functools.cache
def anchors(page: pathlib.Path) -> frozenset[str]:
    return frozenset(re.findall(r'(?:id|name)="([^"]+)"', page.read_text(errors="replace")))


def broken_links(folder: pathlib.Path) -> list[str]:
    broken = []
    for page in sorted(folder.glob("*.html")):
        for target in re.findall(r'(?:href|src)="([^"]+)"', page.read_text(errors="replace")):
            target = urllib.parse.unquote(html.unescape(target))
            if re.match(r"[a-z]+:|//", target):
                continue
            name, _, anchor = target.partition("#")
            other = page if not name else folder / name
            if not other.exists():
                broken.append(f"{page.name} links to {target}, which does not exist")
            elif anchor and other.suffix == ".html" and anchor not in anchors(other):
                broken.append(f"{page.name} links to {target}, and that page has no such anchor")
    return broken
