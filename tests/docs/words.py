#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""words.py ROOT [--only PREFIX | --spelling | --self-test]: the sentences that users read are plain English.

Reads Markdown documents, comments of headers, sources, examples and scripts, messages (string literals of several words) and names of tests.
--spelling runs codespell on the tree. --self-test checks each pattern on an example that it must catch and one that it must not, and
codespell on a planted error. Prints each finding; exit 0 none, 1 some, 77 if codespell is not installed."""

import argparse
import dataclasses
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tokenize
from collections.abc import Iterator

from documents import all_documents

LONGEST_SENTENCE = 30  # words, in documents
COMMENTS = ("include", "backends", "examples", "src", "tools")
MESSAGES = ("include", "backends", "examples", "tools")
SCRIPTS = ("scripts", "tools/python")  # in Python
TESTS = ("tests", "tools/viewer/tests")


@dataclasses.dataclass
class Pattern:
    name: str
    advice: str
    regex: str
    caught: str  # an example that it must catch
    passed: str  # and one that it must not
    flags: re.RegexFlag = re.IGNORECASE

    def found(self, sentence: str) -> str:
        match = re.search(self.regex, sentence, self.flags)
        return match[0].strip() if match else ""


PATTERNS = [
    Pattern("headless", "begin with the subject, a noun", r"^(Who|Whom|Whose|What|Which|Whoever|Whatever)\b[^?]*$",
            "What is no template is declared in the header.", "What is a template?", re.NOFLAG),
    Pattern("where", "'if' for a condition, else begin with the subject; 'where' is for places", r"^Where\b[^?]*$",
            "Where it is not linked, the program exits.", "Where does it stand?", re.NOFLAG),
    Pattern("is no", "'is not a' or 'has no'", r"(?<!there )\b(is|are|was|were) no (?!(more|longer|fewer|less|greater|later|smaller|larger|higher|lower)\b)",
            "A run is no result.", "There is no result."),
    Pattern("somebody", "name it: an individual, a robot, a user, a process", r"\b(somebody|nobody|everybody|anybody|whoever|whomever)\b('s)?",
            "Nobody sees it.", "No robot sees it."),
    Pattern("go on", "continue or resume", r"\b(go|goes|going|went|gone) on\b(?! (a|the) )",
            "The run goes on from there.", "The run continues from there."),
    Pattern("beside", "with or next to", r"\bbeside\b", "The shadow beside it.", "Besides, it is short."),
    Pattern("hang on", "depend on", r"\b(hang|hangs|hanging|hung) (on|upon|together)\b", "It hangs on the gait.", "The program hangs."),
    Pattern("mend", "fix", r"\bmend(s|ed|ing)?\b", "This mends the table.", "This amends the table."),
    Pattern("held against", "compared with", r"\b(held|hold|holds|holding)( \w+){0,3} (against|beside)\b|\b(tells?|told|telling) apart\b",
            "The runs are held against the null.", "The hinge is held by a servo."),
    Pattern("tell", "things return, print, report or contain", r"\b(tells?|told)\b", "The table tells who died.", "The table contains the dead."),
    Pattern("home-made", "the field's word (docs/GLOSSARY.md)", r"\b(verdicts?|reprieve[sd]?|heirs?|undecided|hand(s|ed)? on)\b",
            "The verdict is above.", "The conclusion is above."),
    Pattern("history", "the present alone", r"\b(no longer|earlier versions?|formerly)\b|^Before, |(?<!\bis )(?<!\bare )(?<!\bbe )(?<!\bwas )(?<!\bwere )\bused to\b",
            "It used to draw two numbers.", "It is used to draw two numbers."),
]  # fmt: skip

# (path, name of the pattern) that it may break. At most ten.
EXCEPTIONS = [
    ("CHANGELOG.md", "history"),
]
assert len(EXCEPTIONS) <= 10

# Of codespell: a name, and words that tests misspell on purpose.
SPELLED = "savable,upto,flor,childen,relased,nd,ontop,nown"
UNREAD = "*.png,*.svg,*.bib,*.csv,*.trp,*package-lock.json,*/viewer/page/*,*/corpus/*,*/golden/*,*/node_modules/*,*/build/*,*/runs/*,*/.git/*"
SKIPPED = 77


@dataclasses.dataclass
class Text:
    path: pathlib.Path
    line: int
    kind: str  # document, comment, message, test
    text: str


def plain(text: str) -> str:
    """Without links, code and quotations."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"<[^<>]*>|\*\*|\\[ce] ", "", text)
    text = re.sub(r"`[^`]*`", "code", text)
    return re.sub(r'"[^"]*"|“[^”]*”', "quotation", text)


def sentences(text: str) -> list[str]:
    parts = re.split(r"(?<=[.!?])\s+(?=[A-Z*\[(\d]|code\b|quotation\b)|(?<=[.!?][)\"])\s+|(?<=:)\s+(?=[A-Z][a-z]+ \w)", plain(text))
    return [re.sub(r"^[-*\d. ]+(?=[A-Za-z])", "", part).strip() for part in parts if part.strip()]


def documents(root: pathlib.Path) -> Iterator[Text]:
    for document in all_documents(root):
        path = document.path.relative_to(root)
        yield from (Text(path, line, "document", text) for line, text in document.paragraphs)
        for table in document.tables:
            for number, row in enumerate(table.rows):
                yield from (Text(path, table.line + number, "document", cell) for cell in row)


def sources(root: pathlib.Path, folders: tuple[str, ...], *suffixes: str) -> Iterator[tuple[pathlib.Path, str]]:
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in suffixes and not {"node_modules", "build"} & set(path.parts):
                yield path.relative_to(root), path.read_text()


TYPESCRIPT = re.compile(r"(?<![:\"'])//[ \t]?(.*)|/?\*\*?[ \t](.*?)(?:\*/|$)")
COMMENT = re.compile(r"//[/!]?<?[ \t]?(.*)")
LITERAL = r'"(?:\\.|[^"\\\n])*"'


def comments(root: pathlib.Path) -> Iterator[Text]:
    for path, text in sources(root, COMMENTS, ".hpp", ".ipp", ".cpp"):
        block, start = [], 0
        for number, line in enumerate([*text.splitlines(), ""], 1):
            bare = re.sub(LITERAL, '""', line)
            match = COMMENT.search(bare)
            alone = match and not bare[: match.start()].strip()
            if alone and not match[1].startswith("SPDX") and match[1].strip():
                start = start if block else number
                block.append(match[1].strip())
                continue
            if block:
                yield Text(path, start, "comment", " ".join(block))
                block = []
            if match and not alone:
                yield Text(path, number, "comment", match[1])


def messages(root: pathlib.Path) -> Iterator[Text]:
    for path, text in sources(root, MESSAGES, ".hpp", ".ipp", ".cpp"):
        code = re.sub(rf"({LITERAL})|//[^\n]*", lambda m: m[1] or "", text)
        for match in re.finditer(rf"{LITERAL}(?:\s*{LITERAL})*", code):
            joined = "".join(part[1:-1] for part in re.findall(LITERAL, match[0]))
            if re.search(r"[a-z]+ [a-z]+ [a-z]+", joined):
                yield Text(path, code[: match.start()].count("\n") + 1, "message", re.sub(r"\\[nt]", " ", joined))


def is_python(path: pathlib.Path) -> bool:
    if path.suffix:
        return path.suffix == ".py"
    with path.open("rb") as file:
        return b"python" in file.readline()


def scripts(root: pathlib.Path) -> Iterator[Text]:
    for path in sorted(path for folder in SCRIPTS for path in (root / folder).rglob("*") if path.is_file() and is_python(path)):
        with path.open("rb") as file:
            for token in tokenize.tokenize(file.readline):
                if token.type == tokenize.COMMENT and not re.search(r"SPDX|#!", token.string):
                    yield Text(path.relative_to(root), token.start[0], "comment", token.string.lstrip("# "))
                if token.type == tokenize.STRING and re.search(r"[a-z]+ [a-z]+ [a-z]+", token.string):
                    yield Text(path.relative_to(root), token.start[0], "message", token.string.strip("rbf\"'").replace("\n", " "))


def viewer(root: pathlib.Path) -> Iterator[Text]:
    for path, text in sources(root, ("tools/viewer",), ".ts", ".mjs"):
        if "tests" in path.parts:
            continue
        for number, line in enumerate(text.splitlines(), 1):
            match = TYPESCRIPT.search(re.sub(LITERAL, '""', line))
            if match and "SPDX" not in line:
                yield Text(path, number, "comment", (match[1] or match[2] or "").strip())
            for literal in re.findall(rf"{LITERAL}|`[^`]*`", line):
                if re.search(r"[a-z]+ [a-z]+ [a-z]+", literal):
                    yield Text(path, number, "message", literal[1:-1])


def tests(root: pathlib.Path) -> Iterator[Text]:
    for path, text in sources(root, TESTS, ".cpp", ".hpp", ".mjs"):
        for match in re.finditer(rf"\b(?:TEST_CASE|TEST_CASE_TEMPLATE|TEST_CASE_TEMPLATE_DEFINE|SUBCASE|test)\(\s*({LITERAL}(?:\s*{LITERAL})*)", text):
            name = "".join(part[1:-1] for part in re.findall(LITERAL, match[1]))
            yield Text(path, text[: match.start()].count("\n") + 1, "test", name)
    for path, text in sources(root, ("tests",), ".txt", ".py"):
        names = re.findall(r'NAME "([^"]*)"', text) if path.suffix == ".txt" else re.findall(r"def test_(\w+)\(", text)
        for name in names:
            line = text[: text.index(name)].count("\n") + 1
            yield Text(path, line, "test", name.replace("_", " "))


def findings(text: Text) -> Iterator[str]:
    for sentence in sentences(text.text):
        for pattern in PATTERNS:
            if (str(text.path), pattern.name) in EXCEPTIONS:
                continue
            if found := pattern.found(sentence):
                shown = sentence if len(sentence) < 140 else sentence[:137] + "..."
                yield f"{text.path}:{text.line}: {text.kind}: '{found[:40]}': {pattern.advice}: {shown}"
        words = len(re.findall(r"\w[\w'’.,/-]*", sentence))
        if text.kind == "document" and words > LONGEST_SENTENCE:
            yield f"{text.path}:{text.line}: document: {words} words, must be <= {LONGEST_SENTENCE}: {sentence[:100]}..."


def spelling(root: pathlib.Path) -> list[str]:
    if not shutil.which("codespell"):
        print("codespell is not installed")
        sys.exit(SKIPPED)
    done = subprocess.run(["codespell", "-L", SPELLED, "-S", UNREAD, "."], cwd=root, capture_output=True, text=True)
    return done.stdout.splitlines() + done.stderr.splitlines()


def self_test() -> list[str]:
    offences = []
    for pattern in PATTERNS:
        offences += [] if pattern.found(pattern.caught) else [f"{pattern.name}: does not catch: {pattern.caught}"]
        offences += [f"{pattern.name}: catches: {pattern.passed}"] if pattern.found(pattern.passed) else []
    long = Text(pathlib.Path("x.md"), 1, "document", "One " + "and one " * 15 + ".")
    offences += [] if list(findings(long)) else ["a sentence of 31 words passes"]
    planted = Text(pathlib.Path("x.hpp"), 1, "comment", "Reads `a`. Whoever comes first goes on. (Who comes second waits.) It is short.")
    offences += [] if len(list(findings(planted))) == 3 else ["sentences of a comment are not read one by one"]
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "x.md").write_text("The reci" + "eved runs.\n")
        offences += [] if len(spelling(pathlib.Path(folder))) == 1 else ["codespell does not find a planted error"]
    return offences


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--only", default="", help="paths that begin with this")
    parser.add_argument("--spelling", action="store_true")
    parser.add_argument("--self-test", action="store_true")
    chosen = parser.parse_args()
    if chosen.self_test:
        offences = self_test()
    elif chosen.spelling:
        offences = spelling(chosen.root.resolve())
    else:
        root = chosen.root.resolve()
        texts = [text for read in (documents, comments, messages, scripts, viewer, tests) for text in read(root)]
        kinds = {text.kind for text in texts}
        offences = [found for text in texts if str(text.path).startswith(chosen.only) for found in findings(text)]
        offences += [f"no {kind} was read" for kind in ("document", "comment", "message", "test") if kind not in kinds]
    for offence in offences:
        print(offence)
    print(f"{len(offences)} findings")
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main())
