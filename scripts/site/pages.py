# SPDX-License-Identifier: MIT
"""The repository's documents as pages of the site: each heading gets a label, and each link between documents becomes a reference."""

import os
import pathlib
import re
import shutil

import references
from documents import all_documents, parse

ORDER = [  # what a reader meets in the site's tree, with their parents
    ("README.md", None), ("docs/tutorial.md", None), ("docs/how-to/README.md", None), ("docs/GLOSSARY.md", None),
    ("studies/results/README.md", None), ("studies/results/open-choices.md", "studies/results/README.md"), ("docs/performance.md", None),
    ("docs/robustness.md", None), ("docs/history/robustness.md", "docs/robustness.md"), ("docs/ARCHITECTURE.md", None),
    ("docs/read-in-an-hour.md", "docs/ARCHITECTURE.md"), ("docs/decisions/README.md", None), ("docs/files.md", None),
    ("docs/tables.md", "docs/files.md"), ("models/README.md", None), ("backends/mujoco/README.md", None),
    ("backends/ode/README.md", None), ("CONTRIBUTING.md", None), ("docs/style.md", "CONTRIBUTING.md"),
    ("docs/api-stability.md", "CONTRIBUTING.md"), ("docs/size.md", "CONTRIBUTING.md"),
    ("tests/README.md", "CONTRIBUTING.md"), ("CHANGELOG.md", None),
]


def version(root: pathlib.Path) -> str:
    return re.search(r"VERSION (\d+\.\d+\.\d+)", (root / "CMakeLists.txt").read_text())[1]


def label(path: str) -> str:
    return "page_" + re.sub(r"\W+", "_", path.removesuffix(".md")).lower()


def parent_of(path: str, names: set[str]) -> str | None:
    folder = str(pathlib.PurePath(path).parent / "README.md")
    return folder if path != folder and folder in names and folder != "README.md" else dict(ORDER).get(path)


def anchor_label(path: str, anchor: str) -> str:
    return label(path) + "__" + re.sub(r"\W", "_", anchor)


def converted(root: pathlib.Path, path: str, names: set[str], images: pathlib.Path) -> str:
    document = parse(root / path)
    here = pathlib.PurePath(path).parent
    keys = set(references.entries(root))
    headings = {heading.line: heading for heading in document.headings}
    lines, fence, comment, first = [], False, False, True

    def linked(match: re.Match) -> str:
        bang, text, target = match[1], " ".join(match[2].split()), match[3]
        if re.match(r"[a-z]+:", target) or match[0].endswith("(@ref"):
            return match[0]
        file, _, anchor = target.partition("#")
        local = os.path.normpath(str(here / file)) if file else path
        if bang:
            shutil.copy(root / local, images / pathlib.PurePath(local).name)
            return f'@htmlonly<img src="{pathlib.PurePath(local).name}" alt="{text}"/>@endhtmlonly'
        if (root / local).is_dir() and f"{local}/README.md" in names:
            local = f"{local}/README.md"
        if local in names:
            return f"[{text}](@ref {anchor_label(local, anchor) if anchor else label(local)})"
        if local.startswith(("include/", "backends/")) and local.endswith(".hpp"):
            return f"[{text}](@ref {local.split('include/')[-1]})"
        return text if text.startswith("`") else f"{text} (`{local}`)"

    def prose(text: str) -> str:
        spans: list[str] = []

        def keep(match: re.Match) -> str:
            spans.append(f"`{match[0]}`" if "'" in match[0] else match[0])  # Doxygen ends a span of one backtick at a quote
            return f"\x00{len(spans) - 1}\x00"

        text = re.sub(r"`[^`]*`", keep, text)
        text = re.sub(r'<a id="([^"]+)"></a>', lambda m: f"@anchor {anchor_label(path, m[1])} ", text)
        text = references.linked(re.sub(r"<(?=[a-z])", "&lt;", text), keys)
        text = re.sub(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)", linked, text)
        return re.sub(r"\x00(\d+)\x00", lambda match: spans[int(match[1])], text)

    def end_prose() -> None:
        if waiting:
            lines.append(prose("\n".join(waiting)))
        waiting.clear()

    waiting: list[str] = []
    for number, document_line in enumerate((root / path).read_text().splitlines(), 1):
        if re.match(r"^\s*```", document_line):
            end_prose()
            fence = not fence
            opened = re.match(r"^(\s*)```(\S+)$", document_line)
            if fence and opened:
                kinds = {"cpp": "{.cpp}", "python": "{.py}"}
                document_line = f"{opened[1]}```{kinds.get(opened[2], '{.unparsed}')}"
            lines.append(document_line)
            continue
        if fence:
            lines.append(document_line)
            continue
        if comment or document_line.lstrip().startswith("<!--"):
            comment = "-->" not in document_line
            continue
        if number in headings:
            end_prose()
            heading = headings[number]
            text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading.text).replace("`", "")
            name = label(path) if first else anchor_label(path, heading.anchor)
            if first:
                lines.append(f"{text} {{#{name}}}\n{'=' * 20}\n")
                if path != "README.md":  # the front page begins with what trophic is; the tree has its sections
                    lines.append("@tableofcontents\n")
            else:
                lines.append(f"{'#' * heading.level} {text} {{#{name}}}")
            first = False
            continue
        waiting.append(document_line)
    end_prose()
    return "\n".join(lines) + "\n"


def write(root: pathlib.Path, out: pathlib.Path, images: pathlib.Path, cards: list) -> None:
    # The site may be built inside the tree: its own pages are not documents.
    names = {str(document.path.relative_to(root)) for document in all_documents(root) if out.parent not in document.path.parents}
    names = {name for name in names if not name.startswith((".github/", "packaging/", "docs/paper/"))}
    wanted = [name for name, _ in ORDER if name in names]
    wanted += sorted(names - set(wanted))
    (out / "references.md").write_text(references.page(root))
    for path in wanted:
        text = converted(root, path, names, images)
        children = [name for name in wanted if parent_of(name, names) == path]
        if path == "README.md":
            others = [label(name) for name in wanted if name != path and parent_of(name, names) is None]
            after_how_tos = others.index(label("docs/how-to/README.md")) + 1
            others[after_how_tos:after_how_tos] = ["page_gallery", "rule_cards"]
            text += "\n".join(["", *(f"@subpage {name}\n" for name in others), "@subpage page_references", ""])
        elif children:
            text += "\n".join(["", *(f"- @subpage {label(name)}" for name in children), ""])
        (out / (path if path == "README.md" else path.replace("/", "__"))).write_text(text)
