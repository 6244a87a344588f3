#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""quotations_test.py ROOT [--source TEX]: each quotation of the paper is in paper_sentences.txt, word for word.

A block is a doc block or comment of C++ or TOML, a docstring of Python, a paragraph or a row of a table of Markdown. In a block that names the paper
(Sec. "...", the paper, the text, the authors, a draft), everything of four words or more between double quotes is a quotation. It
must be part of one sentence; [...] stands for words left out. If the block cites sections, the sentence must be of one of them. A
draft's sentence needs the word draft in the block. Section titles, in Sec. "..." and in `source` strings, must be the paper's.
--source: also compares the file with the paper's LaTeX source. Prints each offence; exit 0 none, 1 some."""

import argparse
import dataclasses
import pathlib
import re
import sys

from documents import all_documents

HERE = pathlib.Path(__file__).parent
CODE = ("include", "src", "backends", "tools", "examples", "studies", "models")
HISTORY = {"CHANGELOG.md"}  # may quote what was wrong
NAMES_PAPER = re.compile(r'\bSec\. "|\b[Tt]he (paper|text|authors)\b|\b[Dd]raft\b')
CITATION = re.compile(r'\bSec\. "([^"]*)"')


@dataclasses.dataclass
class Sentence:
    text: str
    sections: list[str]  # that it stands in, from the outermost
    is_draft: bool


@dataclasses.dataclass
class Paper:
    title: str
    sections: set[str]
    sentences: list[Sentence]


def read_paper(path: pathlib.Path) -> Paper:
    paper, sections = Paper("", set(), []), []
    for line in path.read_text().splitlines():
        key, _, value = line.partition(": ")
        if line.startswith("#"):
            continue
        if key == "title":
            paper.title = value
        elif key == "section":
            sections = value.split(" / ")
            paper.sections.add(sections[-1])
        else:
            paper.sentences.append(Sentence(value if key == "draft" else line, sections, key == "draft"))
    return paper


def comments(path: pathlib.Path) -> list[tuple[int, str]]:
    """Line and text of each comment or docstring; lines of comment one below the other are one."""
    if path.suffix == ".py":
        text = path.read_text()
        return [
            (text.count("\n", 0, found.start()) + 1, " ".join(found[1].split()))
            for found in re.finditer(r'"""(.*?)"""', text, re.S)
        ]
    mark = r"#" if path.suffix == ".toml" else r"///?<?"
    found, open_block = [], False
    for number, line in enumerate(path.read_text().splitlines(), 1):
        own, behind = re.match(rf"\s*{mark}(?: (.*))?$", line), re.search(rf"\s{mark} (.*)$", line)
        if own and open_block:
            found[-1] = (found[-1][0], f"{found[-1][1]} {own[1] or ''}")
        elif own or behind:
            found.append((number, (own or behind)[1] or ""))
        open_block = bool(own)
    return found


def contains(sentence: str, pieces: list[str]) -> bool:
    """Whether the pieces follow each other in the sentence, each from a word's start to a word's end."""
    pattern = ".*".join(re.escape(piece) for piece in pieces)
    return re.search(rf"(?<!\w){pattern}(?!\w)", sentence) is not None


def judged(block: str, paper: Paper) -> list[str]:
    block = " ".join(re.sub(r"</?[a-z][^<>]*>", "", block).split())
    if not NAMES_PAPER.search(block):
        return []
    cited = CITATION.findall(block)
    offences = [f'the paper has no section "{title}"' for title in cited if title not in paper.sections]
    for quotation in re.findall(r'"([^"]*)"', CITATION.sub("", block)):
        words = quotation.strip(" .,;:")
        if len(re.split(r"[\s-]+", words)) < 4 or words in paper.sections or words == paper.title:
            continue
        pieces = [piece.strip() for piece in words.split("[...]")]
        forms = [
            pieces,
            [pieces[0][:1].lower() + pieces[0][1:], *pieces[1:]],
            [pieces[0][:1].upper() + pieces[0][1:], *pieces[1:]],
        ]
        found = [one for one in paper.sentences if any(contains(one.text, form) for form in forms)]
        if not found:
            offences.append(f'"{words}" is not in the paper')
        elif cited and not any(set(one.sections) & set(cited) for one in found):
            offences.append(f'"{words}" is not of a section that is cited with it')
        elif all(one.is_draft for one in found) and not re.search(r"\b[Dd]raft\b", block):
            offences.append(f'"{words}" is of a draft, which must be said')
    return offences


def in_tree(root: pathlib.Path, paper: Paper) -> list[str]:
    offences = []
    for path in sorted(
        path
        for folder in CODE
        for path in (root / folder).rglob("*")
        if path.suffix in (".hpp", ".ipp", ".cpp", ".py", ".toml")
    ):
        for line, block in comments(path):
            offences += [f"{path.relative_to(root)}:{line}: {said}" for said in judged(block, paper)]
        for source in re.findall(r'string_view source =[^"]*"((?:[^"\\]|\\.)*)"', path.read_text()):
            titles = re.findall(r'\\"([^"\\]*)\\"', source)
            offences += [
                f'{path.relative_to(root)}: the paper has no section "{title}"'
                for title in titles
                if title not in paper.sections
            ]
    for document in all_documents(root):
        if document.path.name in HISTORY:
            continue
        rows = [(table.line + n, " | ".join(row)) for table in document.tables for n, row in enumerate(table.rows)]
        for line, block in document.paragraphs + rows:
            offences += [f"{document.path.relative_to(root)}:{line}: {said}" for said in judged(block, paper)]
    listed = re.search(r"sections = \{([^}]*)\}", (root / "docs/references.bib").read_text())[1]
    titles = [" ".join(title.split()) for title in listed.split(";")]
    return offences + [
        f'docs/references.bib: the paper has no section "{title}"' for title in titles if title not in paper.sections
    ]


def in_source(tex: str, paper: Paper) -> list[str]:
    """Parts of the file that are not in the LaTeX source, in order, with its markup left out as the file states."""

    def plain(text: str) -> str:
        text = re.sub(r"~?\\(cite|label|ref|footnote)\{[^}]*\}", "", text)
        text = re.sub(r"\\(textit|textbf)\{([^}]*)\}", r"\2", text).replace("`", "'").replace("\\", "").replace("$", "")
        return " ".join(text.split())

    text = plain(re.sub(r"(?<!\\)%.*", "", tex))
    drafts = plain(" ".join(re.findall(r"(?<!\\)%(.*)", tex)))
    titles = [plain(title) for title in re.findall(r"\\(?:(?:sub)*section|paragraph)\{([^}]*)\}", tex)]
    offences = [f'the source has no section "{title}"' for title in paper.sections if title not in titles]
    offences += [f'the file lacks the section "{title}"' for title in titles if title not in paper.sections]
    offences += [
        f"not in the source: {one.text}"
        for one in paper.sentences
        if one.text not in (drafts if one.is_draft else text)
    ]
    return offences + ([] if paper.title in plain(tex) else ["another title"])


def main() -> int:
    arguments = argparse.ArgumentParser()
    arguments.add_argument("root", type=pathlib.Path)
    arguments.add_argument("--source", type=pathlib.Path)
    options = arguments.parse_args()
    paper = read_paper(HERE / "paper_sentences.txt")
    offences = in_tree(options.root, paper)
    if options.source:
        offences += in_source(options.source.read_text(), paper)
    print("\n".join(offences) or f"{len(paper.sentences)} sentences, and all quotations are of them")
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main())
