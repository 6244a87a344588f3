#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""words.py ROOT [--only PREFIX | --spelling | --self-test]: the sentences that users read are plain English.

Reads Markdown documents, comments and docstrings of C++, Python and TypeScript, messages (string literals of several words), texts of
help and names of tests.
--spelling runs codespell on the tree. --self-test checks each pattern on an example that it must catch and one that it must not, and
codespell on a planted error. Prints each finding; exit 0 none, 1 some, 77 if codespell is not installed."""

import argparse
import ast
import dataclasses
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator

from documents import all_documents

LONGEST_SENTENCE = 30  # words, in documents
COMMENTS = ("include", "backends", "examples", "studies", "src", "tools", "tests/conformance", "tests/support")
MESSAGES = ("include", "backends", "examples", "studies", "tools")
SCRIPTS = ("docs", "studies", "packaging", "scripts", "tools")  # in Python
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
    Pattern("of", "begin with the subject, a noun", r"^Of (?!course\b|\d)", "Of each individual: its age.", "The age of each individual.", re.NOFLAG),
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
    Pattern("home-made", "the field's word (docs/GLOSSARY.md)", r"\b(verdicts?|reprieve[sd]?|heirs?|hand(s|ed)? on|crews?|knots?|cut off)\b",
            "The verdict is above.", "The conclusion is above."),
    Pattern("decided", "an effect is significant, a comparison inconclusive", r"\b(is|are|was|were|not) decided\b(?! (by|in)\b)",
            "The effects that are decided.", "The agents that decided first."),
    Pattern("numbers", "parameters", r"\b(rules?|tables?|policy|policies|backend|engine|experiment)('s|s')? numbers\b|"
            r"\b(rules|rule tables?), numbers\b|\bnumbers of (the |a |these )?(rules?|rule tables?|policy|policies|backend|engine|experiment)\b",
            "The rule's numbers.", "The number of rules."),
    Pattern("own", "its owner's, or 'the same'", r"\bthe own\b", "Opponents of the own run.", "Opponents of its own run."),
    Pattern("none of", "empty or null, if", r"\b(none|nothing) of (fewer|less|no|none|nothing)\b", "The mean; none of fewer than two.", "None of them."),
    Pattern("history", "the present alone", r"\b(no longer|earlier versions?|formerly)\b|^Before, |(?<!\bis )(?<!\bare )(?<!\bbe )(?<!\bwas )(?<!\bwere )\bused to\b",
            "It used to draw two numbers.", "It is used to draw two numbers."),
]  # fmt: skip

# (path, name of the pattern) that it may break. At most ten.
EXCEPTIONS = [
    ("CHANGELOG.md", "history"),
]
assert len(EXCEPTIONS) <= 10

# Of codespell: a name, and words that tests misspell on purpose.
SPELLED = "savable,upto,flor,gird,childen,relased,nd,ontop,nown,trough"
UNREAD = "*.png,*.svg,*.bib,*.csv,*.trp,*package-lock.json,*/viewer/page/*,*/corpus/*,*/golden/*,*/node_modules/*,*/build/*,*/runs/*,*/.git/*"
SKIPPED = 77


@dataclasses.dataclass
class Text:
    path: pathlib.Path
    line: int
    kind: str  # document, comment, message, help, test
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


COMMENT = re.compile(r"(?<![:\"'])//[/!]?<?[ \t]?(.*)")
TYPESCRIPT = re.compile(r"(?<![:\"'])//[ \t]?(.*)|/\*\*?[ \t](.*?)(?:\*/|$)|^[ \t]*\*(?!/)[ \t]?(.*)")
PYTHON = re.compile(r"#!?[ \t]*(.*)")
LITERAL = r'"(?:\\.|[^"\\\n])*"'
TEMPLATE = r"`[^`]*`|'[^'\n]*'"
HELP = re.compile(r'"-{0,2}[\w-]+",\s*&[\w:.>-]+,[^"{}]*$|\.(?:help|about)\s*=\s*$')


def comment_blocks(path: pathlib.Path, lines: list[str], comment: re.Pattern[str]) -> Iterator[Text]:
    """Comments on lines of their own, those of adjacent lines as one, and comments after code."""
    block, start = [], 0
    for number, line in enumerate([*lines, ""], 1):
        bare = re.sub(LITERAL, '""', line)
        match = comment.search(bare)
        text = next((group for group in match.groups() if group), "").strip() if match else ""
        alone = match and not bare[: match.start()].strip()
        if alone and text and not re.match(r"SPDX|/usr/bin", text):
            start = start if block else number
            block.append(text)
            continue
        if block:
            yield Text(path, start, "comment", " ".join(block))
            block = []
        if text and not alone:
            yield Text(path, number, "comment", text)


def comments(root: pathlib.Path) -> Iterator[Text]:
    for path, text in sources(root, COMMENTS, ".hpp", ".ipp", ".cpp"):
        yield from comment_blocks(path, text.splitlines(), COMMENT)
    for path, text in sources(root, ("tools",), ".ts", ".mjs"):
        yield from comment_blocks(path, text.splitlines(), TYPESCRIPT)


def is_sentence(text: str) -> bool:
    return bool(re.search(r"[a-z]+ [a-z]+ [a-z]+", text))


def messages(root: pathlib.Path) -> Iterator[Text]:
    for path, text in sources(root, MESSAGES, ".hpp", ".ipp", ".cpp"):
        code = re.sub(rf"({LITERAL})|//[^\n]*", lambda m: m[1] or "", text)
        for match in re.finditer(rf"{LITERAL}(?:\s*{LITERAL})*", code):
            joined = "".join(part[1:-1] for part in re.findall(LITERAL, match[0]))
            kind = "help" if HELP.search(code[max(0, match.start() - 200) : match.start()]) else "message"
            if kind == "help" or is_sentence(joined):
                yield Text(path, code[: match.start()].count("\n") + 1, kind, re.sub(r"\\[nt]", " ", joined))
    for path, text in sources(root, ("tools",), ".ts", ".mjs"):
        if "tests" not in path.parts:
            code = re.sub(rf"({LITERAL}|{TEMPLATE})|//[^\n]*|/\*.*?\*/", lambda m: m[1] or "", text)
            for match in re.finditer(rf"{LITERAL}|{TEMPLATE}", code):
                if is_sentence(match[0]):
                    yield Text(path, code[: match.start()].count("\n") + 1, "message", match[0][1:-1])


def is_python(path: pathlib.Path) -> bool:
    if path.suffix:
        return path.suffix == ".py"
    with path.open("rb") as file:
        return b"python" in file.readline()


def python_strings(path: pathlib.Path, text: str) -> Iterator[Text]:
    """Docstrings, texts of argparse's help, and messages; a value in an f-string is read as "value"."""
    tree = ast.parse(text)
    kinds = {keyword.value: "help" for node in ast.walk(tree) if isinstance(node, ast.Call) for keyword in node.keywords
             if keyword.arg in ("help", "description", "epilog")}
    kinds |= {node.value: "comment" for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    inner = {part for node in ast.walk(tree) if isinstance(node, ast.JoinedStr) for part in node.values}
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            string = "".join(part.value if isinstance(part, ast.Constant) else "value" for part in node.values)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and node not in inner:
            string = node.value
        else:
            continue
        if node in kinds or is_sentence(string):
            yield Text(path, node.lineno, kinds.get(node, "message"), " ".join(string.split()))


def scripts(root: pathlib.Path) -> Iterator[Text]:
    for path in sorted(path for folder in SCRIPTS for path in (root / folder).rglob("*") if path.is_file() and "node_modules" not in path.parts):
        if is_python(path):
            text = path.read_text()
            yield from comment_blocks(path.relative_to(root), text.splitlines(), PYTHON)
            yield from python_strings(path.relative_to(root), text)


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
        tools = pathlib.Path(folder) / "tools"
        tools.mkdir()
        (tools / "x.py").write_text('"""Of a run."""\n# It goes\n# on.\nadd("--x", help="two heirs")\nfail(f"the heir of {x} is " "the next")\n')
        (tools / "x.ts").write_text("/** Of a run. */\nconst x = `the heirs of ${y}`; // It goes on.\n")
        (tools / "x.cpp").write_text('{"--heirs", &heirs, "heirs (1)"}\n')
        found = [(text.path.suffix, text.kind) for read in (comments, messages, scripts) for text in read(pathlib.Path(folder)) if list(findings(text))]
        expected = [(".py", kind) for kind in ("comment", "comment", "help", "message")] + [(".ts", kind) for kind in ("comment", "comment", "message")]
        offences += [] if sorted(found) == sorted([*expected, (".cpp", "help")]) else [f"planted findings: {found}"]
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
        texts = [text for read in (documents, comments, messages, scripts, tests) for text in read(root)]
        kinds = {text.kind for text in texts}
        offences = [found for text in texts if str(text.path).startswith(chosen.only) for found in findings(text)]
        offences += [f"no {kind} was read" for kind in ("document", "comment", "message", "help", "test") if kind not in kinds]
    for offence in offences:
        print(offence)
    print(f"{len(offences)} findings")
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main())
