# SPDX-License-Identifier: MIT
"""Markdown documents parsed into headings, links, blocks of code, spans of code, tables and prose, each with its line."""

import dataclasses
import pathlib
import re

SKIPPED = {"node_modules"}  # and build folders, run folders and hidden ones but .github


@dataclasses.dataclass
class Heading:
    line: int
    level: int
    text: str
    anchor: str


@dataclasses.dataclass
class Block:
    line: int
    language: str
    code: str
    note: tuple[str, str] = ("", "")  # of a comment above it: <!-- from FILE -->, <!-- file FILE -->, <!-- run -->


@dataclasses.dataclass
class Table:
    line: int
    rows: list[list[str]]


@dataclasses.dataclass
class Document:
    path: pathlib.Path
    headings: list[Heading]
    links: list[tuple[int, str]]
    blocks: list[Block]
    spans: list[tuple[int, str]]
    tables: list[Table]
    paragraphs: list[tuple[int, str]]  # prose only: no code, tables, headings, comments
    anchors: set[str]  # of headings, and those written <a id="...">


def slug(text: str) -> str:
    """The anchor that GitHub gives a heading."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text).replace("`", "").strip().lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def parse(path: pathlib.Path) -> Document:
    document = Document(path, [], [], [], [], [], [], set())
    taken, paragraph, paragraph_line, fence, above, in_comment = {}, [], 0, None, ("", ""), False

    def end_paragraph():
        nonlocal paragraph
        if paragraph:
            document.paragraphs.append((paragraph_line, " ".join(paragraph)))
        paragraph = []

    for number, line in enumerate(path.read_text().splitlines(), 1):
        opened = re.match(r"^\s*```(\S*)$", line)
        if fence is not None:
            if opened:
                fence = None
            else:
                document.blocks[-1].code += line + "\n"
            continue
        if opened:
            end_paragraph()
            fence = opened[1]
            document.blocks.append(Block(number, opened[1], "", above))
            above = ("", "")
            continue
        if in_comment or line.lstrip().startswith("<!--"):
            if note := re.match(r"\s*<!--\s*(\w+):? ?(.*?)\s*-->\s*$", line):
                above = (note[1], note[2])
            in_comment = "-->" not in line
            continue
        if line.strip():
            above = ("", "")
        for span in re.findall(r"(?<!`)`([^`]+)`(?!`)", line):
            document.spans.append((number, span))
        bare = re.sub(r"`[^`]*`", "`", line)
        document.anchors |= set(re.findall(r'<a id="([^"]+)">', bare))
        for target in re.findall(r"\]\(([^)\s]+)\)", bare):
            document.links.append((number, target))
        if heading := re.match(r"^(#+) (.*)$", line):
            end_paragraph()
            anchor = slug(heading[2])
            taken[anchor] = taken.get(anchor, -1) + 1
            anchor += f"-{taken[anchor]}" if taken[anchor] else ""
            document.headings.append(Heading(number, len(heading[1]), heading[2], anchor))
            document.anchors.add(anchor)
        elif line.lstrip().startswith("|"):
            end_paragraph()
            row = [cell.strip() for cell in line.strip().strip("|").split("|")]
            if document.tables and document.tables[-1].line + len(document.tables[-1].rows) == number:
                document.tables[-1].rows.append(row)
            else:
                document.tables.append(Table(number, [row]))
        elif not line.strip():
            end_paragraph()
        else:
            if re.match(r"^\s*([-*]|\d+\.) ", line):
                end_paragraph()
            if not paragraph:
                paragraph_line = number
            paragraph.append(line.strip())
    end_paragraph()
    return document


def all_documents(root: pathlib.Path) -> list[Document]:
    def wanted(path: pathlib.Path) -> bool:
        folders = path.relative_to(root).parts[:-1]
        return not any(
            part in SKIPPED
            or part.startswith("build")
            or part == "runs"
            or (part.startswith(".") and part != ".github")
            for part in folders
        )

    return [parse(path) for path in sorted(root.rglob("*.md")) if wanted(path)]
