#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_documents.py ROOT CHECK [--only FILE] [--programs FOLDER] [--program NAME=FILE]: one property of every document of the tree.

names     each path and file in code style exists, and so does each type and function
links     each link and anchor resolves
commands  each command's program, flags, keys, presets and targets are accepted (--programs: folder of the built programs)
excerpts  each block marked as taken from a file is in that file
slots     docs/how-to/which-slot.md has a heading for each slot, links every policy's header and marks those of the two tables
reading   the names in docs/read-in-an-hour.md are in the file that their section is about

A comment above a block names its file: <!-- from FILE --> is a file of the tree. follow.py uses <!-- file NAME -->, <!-- append NAME -->,
<!-- run --> and <!-- skipped: why -->.
Prints each offence; exit code 0 without offences, 1 otherwise."""

import argparse
import fnmatch
import os
import pathlib
import re
import sys

import commands
from documents import Document, all_documents, slug

HISTORY = {"CHANGELOG.md"}  # mentions names that are gone
SUFFIXES = (
    "hpp",
    "ipp",
    "cpp",
    "h",
    "py",
    "md",
    "toml",
    "csv",
    "json",
    "png",
    "cmake",
    "txt",
    "html",
    "trp",
    "bin",
    "bib",
    "svg",
    "log",
    "sh",
)
SOURCES = (
    ".hpp",
    ".ipp",
    ".cpp",
    ".py",
    ".toml",
    ".cmake",
    ".json",
    ".ts",
    ".in",
    ".bib",
    ".cff",
    ".txt",
    ".sh",
    ".js",
    ".yml",
    ".yaml",
)


class Tree:
    """The files and names of the tree."""

    def __init__(self, root: pathlib.Path):
        self.root = root
        self.files = [path for path in self.walk(root)]
        self.relative = {str(path.relative_to(root)) for path in self.files}
        self.folders = {str(pathlib.PurePath(name).parent) for name in self.relative}
        self.folders |= {str(parent) for name in self.folders for parent in pathlib.PurePath(name).parents}
        sources = [path for path in self.files if path.suffix in SOURCES or not path.suffix]
        sources = [path for path in sources if "golden" not in path.parts]
        self.text = "\n".join(path.read_text(errors="replace") for path in sources)
        self.words = set(re.findall(r"[A-Za-z_]\w*", self.text))
        self.heads = [root, *(path for path in self.include_folders())]

    @staticmethod
    def walk(root: pathlib.Path):
        for folder, folders, names in os.walk(root):
            folders[:] = [
                n
                for n in folders
                if not (n.startswith("build") or n in ("runs", "node_modules", ".git", ".cache", "__pycache__"))
            ]
            yield from (pathlib.Path(folder) / name for name in names)

    def include_folders(self):
        for include in [self.root / "include", *sorted(self.root.glob("backends/*/include"))]:
            yield include
            yield include / "trophic"
            yield include / "trophic" / "backend"
            yield from (path for path in sorted((include / "trophic" / "backend").glob("*")) if path.is_dir())
        yield from (
            self.root / folder for folder in ("models", "tests", "examples", "tools", "tools/python", "tools/viewer")
        )

    def has_path(self, named: str, document: Document) -> bool:
        """<slot> and * stand for any name, ... for any folders, {a,b} for both."""
        pattern = re.sub(r"<[^>]*>", "*", named).rstrip("/")
        for alternative in expanded(pattern):
            found = False
            for head in [document.path.parent, *self.heads]:
                if "*" in alternative:
                    found = found or any(True for _ in head.glob(alternative))
                else:
                    found = found or (head / alternative).exists()
            if not found:
                return False
        return True

    def knows_file(self, name: str) -> bool:
        """A file of the tree, or one that a program writes, whose name is in the sources."""
        pattern = re.sub(r"<[^>]*>", "*", name)
        if "/" not in name and any(fnmatch.fnmatch(pathlib.PurePath(known).name, pattern) for known in self.relative):
            return True
        return name in self.text


def expanded(pattern: str) -> list[str]:
    if braces := re.search(r"\{([^}]*)\}", pattern):
        return [
            one
            for part in braces[1].split(",")
            for one in expanded(pattern[: braces.start()] + part + pattern[braces.end() :])
        ]
    return [pattern]


def is_output(name: str) -> bool:
    """Documents use these folders for the output of programs."""
    return name.split("/")[0] in ("runs", "analysis", "build")


def names(tree: Tree, document: Document) -> list[str]:
    """Files of the reader's own are those that a block of the document writes."""
    if document.path.name in HISTORY:
        return []
    offences = []
    own = set(re.findall(r"[A-Za-z_]\w*", "\n".join(block.code for block in document.blocks)))
    written = {block.note[1] for block in document.blocks if block.note[0] in ("file", "append")}
    for line, span in document.spans:
        bare = span.strip()
        if commands.is_command(bare):
            continue
        if re.fullmatch(r"<?[\w.\-*<>{},/]+>?", bare) and (
            "/" in bare or re.fullmatch(rf"[\w\-*<>.]+\.({'|'.join(SUFFIXES)})", bare)
        ):
            named = bare[1:-1] if re.fullmatch(r"<[^<>]+>", bare) else bare
            if (
                is_output(named)
                or pathlib.PurePath(named).name in written
                or any(part.isupper() for part in named.split("/"))
            ):
                continue
            named = re.sub(r"\.\.\./", "**/", named)
            if not tree.has_path(named, document) and not tree.knows_file(named):
                offences.append(f"{line}: there is no '{bare}'")
        elif re.search(r"::|\w[(<]|\b[A-Z][a-z]+[A-Z]", bare):
            words = re.findall(r"[A-Za-z_]\w*", re.sub(r'"[^"]*"', "", bare))
            missing = [
                word
                for word in words
                if len(word) > 3 and not word.isupper() and word not in own and word not in tree.words
            ]
            offences += [f"{line}: nothing is called '{word}' (in `{bare}`)" for word in missing]
    return offences


def links(tree: Tree, document: Document, anchors: dict[pathlib.Path, set[str]]) -> list[str]:
    offences = []
    for line, target in document.links:
        if re.match(r"[a-z]+:", target):
            continue
        file, _, anchor = target.partition("#")
        path = (document.path.parent / file).resolve() if file else document.path.resolve()
        if not path.exists():
            offences.append(f"{line}: links to {target}, which does not exist")
        elif anchor and anchor not in anchors.get(path, set()):
            offences.append(f"{line}: links to {target}, but that document has no such heading")
    return offences


def excerpts(tree: Tree, document: Document) -> list[str]:
    offences = []
    for block in document.blocks:
        key, name = block.note
        if key == "from" and not (tree.root / name).is_file():
            offences.append(f"{block.line}: taken from {name}, which does not exist")
        elif key == "from" and block.code not in (tree.root / name).read_text():
            offences.append(f"{block.line}: these lines are not in {name}:\n{block.code}")
    return offences


def slots(tree: Tree, document: Document) -> list[str]:
    if document.path != tree.root / "docs/how-to/which-slot.md":
        return []
    linked = {(document.path.parent / target).resolve() for _, target in document.links}
    folders = [
        tree.root / "include/trophic" / kind
        for kind in ("perception", "control", "reproduction", "death", "energy", "initialization")
    ]
    headers = [path for folder in folders for path in folder.glob("*/**/*.hpp") if "detail" not in path.parts]
    policies = [
        path
        for path in headers
        if re.search(
            r"^  static constexpr std::string_view name\b|^using \w+ = .*\nstatic_assert", path.read_text(), re.M
        )
    ]
    missing = [path.relative_to(tree.root) for path in policies if path.resolve() not in linked]
    offences = [f"1: no link to the policy {path}" for path in sorted(missing)] + (
        [] if policies else ["1: no policies were found"]
    )
    listed = re.findall(r"^  SLOT\((\w+),", (tree.root / "include/trophic/rules/slots.hpp").read_text(), re.M)
    headings = [heading.text for heading in document.headings if heading.level == 3]
    offences += [f"1: no heading of the slot {slot}" for slot in listed if slot not in headings] + (
        [] if listed else ["1: no slots were found"]
    )
    used = {}
    for letter, table in (("P", "paper"), ("R", "released")):
        text = re.sub(r"//.*", "", (tree.root / f"include/trophic/rules/{table}.hpp").read_text())
        used[letter] = set(re.findall(r"\w+", " ".join(re.findall(r"using \w+ =(.*?);", text, re.DOTALL))))
    in_no_table = {path.stem for path in policies if path.stem.startswith("no_")}  # a table leaves such a slot out
    for name, target, mark in re.findall(r"\[(\w+)\]\(([^)]+)\.hpp\)(?: \*\*(P?R?)\*\*)?", document.path.read_text()):
        expected = "".join(letter for letter, names in used.items() if name in names)
        if mark != expected and pathlib.PurePath(target).name not in in_no_table | {
            "contract",
            "list",
            "by_cause",
            "procedure",
            "cognitive_network",
        }:
            offences.append(f"1: {name} is marked '{mark}', but the tables that use it are '{expected}'")
    return offences


def reading(tree: Tree, document: Document) -> list[str]:
    if document.path != tree.root / "docs/read-in-an-hour.md":
        return []
    offences = []
    for start, end in zip(document.headings, [*document.headings[1:], None]):
        if not (heading := re.fullmatch(r"\d+\. \[(.*)\]\((.*)\)", start.text)):
            continue
        text = (document.path.parent / heading[2]).read_text()
        inside = range(start.line, end.line if end else 10**9)
        words = {word for line, span in document.spans if line in inside for word in re.findall(r"\w+", span)}
        offences += [
            f"{start.line}: {heading[1]} has no '{word}'"
            for word in sorted(words)
            if not re.search(rf"\b{word}\b", text)
        ]
    return offences


CHECKS = {
    "names": names,
    "links": links,
    "commands": commands.check,
    "excerpts": excerpts,
    "slots": slots,
    "reading": reading,
}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("check", choices=CHECKS)
    parser.add_argument("--only", help="this document of the tree")
    parser.add_argument("--programs", type=pathlib.Path, help="folder of the built programs")
    parser.add_argument("--program", action="append", default=[], help="NAME=FILE: a program that documents build")
    chosen = parser.parse_args()
    root = chosen.root.resolve()
    tree = Tree(root)
    documents = all_documents(root)
    extra = ()
    if chosen.check == "links":
        extra = ({document.path.resolve(): document.anchors for document in documents},)
    elif chosen.check == "commands":
        extra = (commands.Programs(chosen.programs, dict(pair.split("=", 1) for pair in chosen.program)),)
    offences = 0
    for document in documents:
        name = str(document.path.relative_to(root))
        if chosen.only in (None, name):
            for offence in CHECKS[chosen.check](tree, document, *extra):
                print(f"{name}:{offence}")
                offences += 1
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main())
