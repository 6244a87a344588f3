#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_documents.py ROOT CHECK [--only FILE] [--programs FOLDER] [--program NAME=FILE]: one property of every document of the tree.

names     each path, file and name in code style exists, and each name marked as former does not
links     each link and anchor resolves
commands  each command's program, flags, keys, presets and targets are accepted (--programs: folder of the built programs)
excerpts  each block marked as taken from a file is in that file
figures   each section with a table of figures names the command that made them
slots     docs/how-to/which-slot.md has a heading for each slot, links every policy's header and marks those of the two tables
reading   docs/read-in-an-hour.md has twelve files of at most 1,500 lines together, with two or three sentences each, whose names they have
lengths   README, the changelog's unreleased section and the cells of tables are short
speed     a document that repeats a figure of speed repeats that of docs/performance.md
readme    README has its two commands, continuous integration calls the second, and each word of the glossary is linked
          where it is first used

Comments in a document exempt what a test cannot know: <!-- former: NAMES -->, <!-- example: NAMES --> (names that a reader chooses),
<!-- given: why --> (above a table: its figures were not measured), <!-- from FILE --> (above a block). follow.py uses <!-- file NAME -->,
<!-- append NAME -->, <!-- run --> and <!-- skipped: why -->.
Prints each offence; exit code 0 without offences, 1 otherwise."""

import argparse
import fnmatch
import os
import pathlib
import re
import sys

import commands
from documents import Document, all_documents, slug

README_COMMANDS = ["scripts/quickstart", "scripts/run-tests"]
LONGEST_CELL = 600  # characters
LONGEST_README, LONGEST_UNRELEASED = 250, 60  # lines
READ_FILES, READ_LINES = 12, 1520
HISTORY = {"CHANGELOG.md"}  # mentions names that are gone
SUFFIXES = ("hpp", "ipp", "cpp", "h", "py", "md", "toml", "csv", "json", "png", "cmake", "txt", "html", "trp", "bin", "bib", "svg", "log", "sh")
SOURCES = (".hpp", ".ipp", ".cpp", ".py", ".toml", ".cmake", ".json", ".ts", ".in", ".bib", ".cff", ".txt", ".sh", ".js", ".yml", ".yaml")


class Tree:
    """The files and names of the tree."""

    def __init__(self, root: pathlib.Path):
        self.root = root
        self.files = [path for path in self.walk(root)]
        self.relative = {str(path.relative_to(root)) for path in self.files}
        self.folders = {str(pathlib.PurePath(name).parent) for name in self.relative}
        self.folders |= {str(parent) for name in self.folders for parent in pathlib.PurePath(name).parents}
        sources = [path for path in self.files if path.suffix in SOURCES or not path.suffix]
        sources = [path for path in sources if "golden" not in path.parts and path.name != "planted_lies_test.py"]
        self.text = "\n".join(path.read_text(errors="replace") for path in sources)
        self.words = set(re.findall(r"[A-Za-z_]\w*", self.text))
        self.heads = [root, *(path for path in self.include_folders())]

    @staticmethod
    def walk(root: pathlib.Path):
        for folder, folders, names in os.walk(root):
            folders[:] = [n for n in folders if not (n.startswith("build") or n in ("runs", "node_modules", ".git", ".cache", "__pycache__"))]
            yield from (pathlib.Path(folder) / name for name in names)

    def include_folders(self):
        for include in [self.root / "include", *sorted(self.root.glob("backends/*/include"))]:
            yield include
            yield include / "trophic"
            yield include / "trophic" / "backend"
            yield from (path for path in sorted((include / "trophic" / "backend").glob("*")) if path.is_dir())
        yield from (self.root / folder for folder in ("models", "tests", "examples", "tools", "tools/python", "tools/viewer"))

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
        return [one for part in braces[1].split(",") for one in expanded(pattern[: braces.start()] + part + pattern[braces.end() :])]
    return [pattern]


def is_output(name: str) -> bool:
    """Documents use these folders for the output of programs."""
    return name.split("/")[0] in ("runs", "analysis", "build")


def names(tree: Tree, document: Document) -> list[str]:
    if document.path.name in HISTORY:
        return []
    offences = []
    former = set(document.noted("former").split())
    example = set(document.noted("example").split())
    for name in sorted(former):
        if re.fullmatch(r"\w+", name) and name in tree.words:
            offences.append(f"1: '{name}' is marked as a former name, but the sources have it")
    own = set(re.findall(r"[A-Za-z_]\w*", "\n".join(block.code for block in document.blocks)))  # a document's own code
    for line, span in document.spans:
        bare = span.strip()
        if commands.is_command(bare):
            continue
        if re.fullmatch(r"<?[\w.\-*<>{},/]+>?", bare) and ("/" in bare or re.fullmatch(rf"[\w\-*<>.]+\.({'|'.join(SUFFIXES)})", bare)):
            named = bare[1:-1] if re.fullmatch(r"<[^<>]+>", bare) else bare
            if is_output(named) or named.split("/")[0] in example or any(part.isupper() for part in named.split("/")):
                continue
            named = re.sub(r"\.\.\./", "**/", named)
            if not tree.has_path(named, document) and not tree.knows_file(named):
                offences.append(f"{line}: there is no '{bare}'")
            continue
        for word in re.findall(r"[A-Za-z_]\w*", re.sub(r'"[^"]*"', "", bare)):
            if len(word) < 4 or word.isupper() or word in own or word in tree.words or word in former or word in example:
                continue
            offences.append(f"{line}: nothing is called '{word}' (in `{bare}`)")
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


def figures(tree: Tree, document: Document) -> list[str]:
    offences = []
    if document.path.name in HISTORY:
        return []
    given = [line for line, key, _ in document.notes if key == "given"]
    for table in document.tables:
        measured = [cell for row in table.rows[2:] for cell in row if re.match(r"[-+<]? ?\d[\d,]*(\.\d+)?( |$|%)", cell)]
        if len(measured) < 3 or any(table.line - 3 <= line < table.line for line in given):
            continue
        start = table.line
        made = False
        while not made:  # the section, then the one that it is part of
            heading = max((h for h in document.headings if h.line < start), key=lambda h: h.line, default=None)
            start = heading.line if heading else 0
            end = next((h.line for h in document.headings if h.line > table.line), 10**9)
            near = [span for line, span in document.spans if start <= line < end]
            near += [block.code for block in document.blocks if start <= block.line < end]
            made = any(commands.is_command(line.strip()) for text in near for line in text.splitlines())
            if not heading or heading.level <= 2:
                break
        if not made:
            offences.append(f"{table.line}: a table of figures, but its section names no command that made them")
    return offences


def sentences(text: str) -> list[str]:
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"`[^`]*`", "code", text)
    return re.split(r"(?<=[.!?])\s+(?=[A-Z*\[\"(\d]|code\b|trophic\b)|(?<=[.!?][)*])\s+|(?<=[.!?]\*\*)\s+", text)


def slots(tree: Tree, document: Document) -> list[str]:
    if document.path != tree.root / "docs/how-to/which-slot.md":
        return []
    linked = {(document.path.parent / target).resolve() for _, target in document.links}
    folders = [tree.root / "include/trophic" / kind for kind in ("perception", "control", "reproduction", "death", "energy", "initialization")]
    headers = [path for folder in folders for path in folder.glob("*/**/*.hpp") if "detail" not in path.parts]
    policies = [path for path in headers if re.search(r"^  static constexpr std::string_view name\b|^using \w+ = .*\nstatic_assert", path.read_text(), re.M)]
    missing = [path.relative_to(tree.root) for path in policies if path.resolve() not in linked]
    offences = [f"1: no link to the policy {path}" for path in sorted(missing)] + ([] if policies else ["1: no policies were found"])
    listed = re.findall(r"^  SLOT\((\w+),", (tree.root / "include/trophic/rules/slots.hpp").read_text(), re.M)
    headings = [heading.text for heading in document.headings if heading.level == 3]
    offences += [f"1: no heading of the slot {slot}" for slot in listed if slot not in headings] + ([] if listed else ["1: no slots were found"])
    used = {}
    for letter, table in (("P", "paper"), ("R", "released")):
        text = re.sub(r"//.*", "", (tree.root / f"include/trophic/rules/{table}.hpp").read_text())
        used[letter] = set(re.findall(r"\w+", " ".join(re.findall(r"using \w+ =(.*?);", text, re.DOTALL))))
    in_no_table = {path.stem for path in policies if path.stem.startswith("no_")}  # a table leaves such a slot out
    for name, target, mark in re.findall(r"\[(\w+)\]\(([^)]+)\.hpp\)(?: \*\*(P?R?)\*\*)?", document.path.read_text()):
        expected = "".join(letter for letter, names in used.items() if name in names)
        if mark != expected and pathlib.PurePath(target).name not in in_no_table | {"contract", "list", "by_cause", "procedure", "cognitive_network"}:
            offences.append(f"1: {name} is marked '{mark}', but the tables that use it are '{expected}'")
    return offences


def reading(tree: Tree, document: Document) -> list[str]:
    if document.path != tree.root / "docs/read-in-an-hour.md":
        return []
    offences, files, lines = [], 0, 0
    for start, end in zip(document.headings, [*document.headings[1:], None]):
        if not (heading := re.fullmatch(r"(\d+)\. \[(.*)\]\((.*)\)", start.text)):
            continue
        number, name, target = heading.groups()
        files += 1
        path = document.path.parent / target
        text = path.read_text() if path.is_file() else ""
        lines += text.count("\n")
        if int(number) != files or not text or not target.endswith(name):
            offences.append(f"{start.line}: '{start.text}' must be file {files} and exist")
        inside = range(start.line, end.line if end else 10**9)
        words = {word for line, span in document.spans if line in inside for word in re.findall(r"\w+", span)}
        offences += [f"{start.line}: {name} has no '{word}'" for word in sorted(words) if not re.search(rf"\b{word}\b", text)]
        said = sum(len(sentences(text)) for line, text in document.paragraphs if line in inside)
        if not 2 <= said <= 4:
            offences.append(f"{start.line}: {said} sentences about {name}: must be 2 to 4")
    if files != READ_FILES or lines > READ_LINES:
        offences.append(f"1: {files} files of {lines} lines: must be {READ_FILES} of at most {READ_LINES}")
    return offences


def lengths(tree: Tree, document: Document) -> list[str]:
    offences = [
        f"{table.line}: a cell of {len(cell)} characters: must have <= {LONGEST_CELL}"
        for table in document.tables
        for row in table.rows
        for cell in row
        if len(cell) > LONGEST_CELL
    ]
    text = document.path.read_text()
    if document.path == tree.root / "README.md" and text.count("\n") > LONGEST_README:
        offences.append(f"1: {text.count(chr(10))} lines: must be <= {LONGEST_README}")
    if document.path == tree.root / "CHANGELOG.md":
        unreleased = re.search(r"^## \[Unreleased\]\n(.*?)(?=^## |\Z)", text, re.M | re.S)
        if not unreleased or unreleased[1].strip().count("\n") >= LONGEST_UNRELEASED:
            offences.append(f"1: the unreleased section must exist and have <= {LONGEST_UNRELEASED} lines")
    return offences


def speed(tree: Tree, document: Document) -> list[str]:
    """Decimals: 29 repeats 29.3 of the row of 30 robots in docs/performance.md."""
    measured = re.search(r"^\| 30 \|.*\(([\d.]+)\) \| [\d.]+ \([\d.]+\) \|$", (tree.root / "docs/performance.md").read_text(), re.M)
    if not measured:
        return ["1: docs/performance.md has no row of 30 robots with speed-ups"]
    expected = f"{float(measured[1]):.0f} times faster"
    offences = [] if document.path.name in HISTORY else [
        f"{line}: '{found}': the figure of docs/performance.md is '{expected}'"
        for line, text in document.paragraphs
        for found in re.findall(r"[\d.]+ times faster", text)
        if found != expected
    ]
    if document.path == tree.root / "README.md" and expected not in document.path.read_text():
        offences.append(f"1: does not repeat '{expected}'")
    return offences


def readme(tree: Tree, document: Document) -> list[str]:
    if document.path != tree.root / "README.md":
        return []
    offences = []
    shell = "".join(block.code for block in document.blocks if block.language == "sh").splitlines()
    for command in README_COMMANDS:
        if command not in shell:
            offences.append(f"1: no line '{command}' in a sh block")
        if not os.access(tree.root / command, os.X_OK):
            offences.append(f"1: {command} is not an executable file")
    ci = [line for line in (tree.root / ".ci/run").read_text().splitlines() if line and not line.startswith(("#", "set ", "cd "))]
    if ci != [f"exec {README_COMMANDS[1]}"]:
        offences.append(f"1: .ci/run must only call {README_COMMANDS[1]}, it has: {ci}")
    return offences + unexplained(tree, document)


def unexplained(tree: Tree, document: Document) -> list[str]:
    """Words of the glossary that are not linked at their first use, except <!-- plain: WORDS --> in their everyday meaning."""
    plain = set(document.noted("plain").split())
    offences = []
    for term in sorted(re.findall(r'<a id="([^"]+)">', (tree.root / "docs/GLOSSARY.md").read_text())):
        plural = term[:-1] + "(y|ies)" if term.endswith("y") else term + "s?"
        word = re.compile(rf"\b{plural.replace('-', '[ -]')}\b", re.IGNORECASE)
        for line, text in document.paragraphs:
            text = re.sub(r"`[^`]*`|!\[[^\]]*\]\([^)]*\)", "", text)
            if not (first := word.search(re.sub(r"\]\([^)]*\)", lambda m: "]" + " " * (len(m[0]) - 1), text))):
                continue
            link = next((m for m in re.finditer(r"\[[^\]]*\]\(([^)]*)\)", text) if m.start() <= first.start() < m.end()), None)
            if term not in plain and not (link and link[1] == f"docs/GLOSSARY.md#{term}"):
                offences.append(f"{line}: '{first[0]}' is a word of the glossary, but its first use is not linked to docs/GLOSSARY.md#{term}")
            break
    return offences


CHECKS = {
    "names": names,
    "links": links,
    "commands": commands.check,
    "excerpts": excerpts,
    "figures": figures,
    "slots": slots,
    "reading": reading,
    "lengths": lengths,
    "speed": speed,
    "readme": readme,
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
