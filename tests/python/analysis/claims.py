# SPDX-License-Identifier: MIT
"""Every claim that an analysis makes, taken out of the texts and tables that it prints: names, effects, intervals, p values, conclusions, counts
and findings. Each output is read as its reader sees it, without the code that wrote it."""
from __future__ import annotations

import csv
import html.parser
import io
import json
import re
from typing import NamedTuple


class Claim(NamedTuple):
    """About a metric, as people read it."""

    set: str
    metric: str
    """title"""
    null: str
    """of a difference of sets: over_shadow or raw"""
    difference: str
    """with its interval"""
    p: str
    conclusion: str
    """"" if the output has none"""


class Output(NamedTuple):
    """The claims of one output."""

    claims: list[Claim]
    counts: list[tuple[int, int | None]]
    """(comparisons, significant) as said in sentences; None if not said"""
    findings: list[str]
    names: list[str]
    """of the sets"""


def counts_in(text: str) -> list[tuple[int, int | None]]:
    both = [(int(all_), int(found)) for found, all_ in re.findall(r"(\d+) of (\d+) comparisons are significant", text)]
    return both + [(int(all_), None) for all_ in re.findall(r"corrected for (\d+) comparisons", text)]


def findings_in(text: str) -> list[str]:
    return re.findall(r"^ *([A-Z][^\n]* runs\)\.)$", text, re.MULTILINE)


def slices(lines: list[str], headings: list[str]) -> list[dict[str, str]]:
    """The cells of lines below a line of headings, whose places they share. The last heading may be "": the column behind the one before it, two
    blanks from its cells."""
    places, at = [], 0
    for heading in filter(None, headings):
        at = lines[0].index(heading, at)
        places.append(at)
        at += len(heading)
    rows = []
    for line in lines[1:]:
        cells = [line[a:b] for a, b in zip(places, [*places[1:], None])]
        if not headings[-1]:
            cells[-1:] = re.fullmatch(r"((?:\S+)?)(?:  +)?(.*)", cells[-1]).groups()
        rows.append({heading: cell.strip() for heading, cell in zip(headings, cells)})
    return rows


def of_table(text: str) -> Output:
    """The whole table of a set on the terminal."""
    lines = text.splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith("metric "))
    end = next(i for i, line in enumerate(lines) if line.startswith("= null model"))
    headings = [
        one
        for one in ("metric", "ours [95 %]", "published", "ours - null [95 %]", "p", "conclusion")
        if one != "published" or "  published" in lines[start]
    ]
    label = lines[0].split(" on kinematic")[0]
    claims, title = [], ""
    for row in slices(lines[start:end], headings):
        if (
            not row["metric"].startswith(("= ", "* "))
            and row["ours - null [95 %]"] == ""
            and not _is_reference(row["metric"])
        ):
            title, same = row["metric"], row["conclusion"].startswith("tested as")
        elif row["metric"].startswith("= ") or row["metric"] == "shadow":  # a reference next to a neutral null
            conclusion = "same" if same else row["conclusion"].replace("not tested", "not compared")
            claims.append(
                Claim(
                    label,
                    title,
                    row["metric"].removeprefix("= ").removesuffix(" null"),
                    row["ours - null [95 %]"],
                    row["p"],
                    conclusion,
                )
            )
    return Output(claims, counts_in(text), findings_in(text), [label])


def _is_reference(cell: str) -> bool:
    return cell in ("uniform_density", "bernoulli_tags", "zero")


def of_difference_table(text: str) -> Output:
    """The whole comparison on the terminal."""
    lines = text.splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith("metric "))
    end = next(i for i, line in enumerate(lines) if line.startswith("p: corrected"))
    over = "over shadows: (b - shadow) - (a - shadow) [95 %]"
    answer = over if over in lines[start] else "raw: b - a [95 %]"
    headings = ["metric", "a", "b", "raw: b - a [95 %]", *([over] if answer == over else []), "p", ""]
    claims = []
    for row in slices(lines[start:end], headings):
        conclusion = "same" if row[""].startswith("tested as") else "significant" if row[""] == "*" else ""
        claims.append(
            Claim("", row["metric"], "over_shadow" if answer == over else "raw", row[answer], row["p"], conclusion)
        )
        if answer == over:
            claims.append(Claim("", row["metric"], "raw", row["raw: b - a [95 %]"], "", ""))
    return Output(
        claims, counts_in(text), findings_in(text), re.findall(r"^[ab]: (.*?) on kinematic", text, re.MULTILINE)
    )


class _Page(html.parser.HTMLParser):
    """Rows of cells and items of lists of a page."""

    def __init__(self) -> None:
        super().__init__()
        self.rows: list[list[str]] = []
        self.items: list[str] = []
        self.title = ""
        self._into: str | None = None

    def handle_starttag(self, tag: str, attributes: list) -> None:
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th") and self.rows:
            self.rows[-1].append("")
        if tag == "li":
            self.items.append("")
        self._into = (
            tag
            if tag in ("td", "th", "li", "h1")
            else self._into
            if tag in ("button", "svg", "line", "circle", "code")
            else None
        )

    def handle_endtag(self, tag: str) -> None:
        if tag in ("td", "th", "li", "h1", "button"):
            self._into = None

    def handle_data(self, data: str) -> None:
        if self._into in ("td", "th") and self.rows and self.rows[-1]:
            self.rows[-1][-1] += data
        if self._into == "li":
            self.items[-1] += data
        if self._into == "h1":
            self.title += data


def of_page(text: str) -> Output:
    page = _Page()
    page.feed(text)
    head = next((row for row in page.rows if "metric" in row), [])
    claims = []
    for cells in page.rows:
        row = dict(zip(head, cells))
        if len(cells) != len(head) or cells == head:
            continue
        name = row.get("set", "")
        if "compared" in row:
            kind = "over_shadow" if row["compared"].startswith("over") else "raw"
            claims.append(
                Claim(
                    "",
                    row["metric"],
                    kind,
                    row["difference [95 %]"],
                    row["p"] if row["conclusion"] != "not compared" else "",
                    row["conclusion"],
                )
            )
        elif row["ours - null [95 %]"]:
            claims.append(
                Claim(
                    name,
                    row["metric"],
                    row["null"].split(" ")[0],
                    row["ours - null [95 %]"],
                    row["p"],
                    row["conclusion"],
                )
            )
    claims = [
        claim._replace(
            conclusion="same"
            if claim.conclusion.startswith("tested as")
            else "not compared"
            if claim.conclusion.startswith("not tested: ")
            else claim.conclusion
        )
        for claim in claims
    ]
    items = "\n".join(page.items)
    return Output(
        claims,
        counts_in(items),
        findings_in(items),
        [part.rsplit(" on ", 1)[0] for part in re.split(r"(?<=kinematic 1) and ", page.title)],
    )


def of_latex(text: str) -> Output:
    """means.tex or differences.tex. An untested difference has a dash for p."""
    claims = []
    for line in text.splitlines():
        cells = [
            cell.strip(" $").replace("\\ ", " ").replace("\\allowbreak{}", "").replace("\\", "")
            for cell in line.removesuffix(" \\\\").split(" & ")
        ]
        if len(cells) != 6 or cells[0] == "metric":
            continue
        title, _, null = cells[0].removesuffix(")").partition(" (null: ")
        claims.append(
            Claim(
                "",
                title if null else cells[0],
                null.removesuffix(" null") or "shadow",
                cells[3],
                "" if cells[4] == "--" else cells[4],
                "",
            )
        )
    return Output(
        claims, counts_in(text), [], re.findall(r"(?:^%(?: a:)?|; b:) ([^%\n]*?) on kinematic", text, re.MULTILINE)
    )


def of_json(text: str, title_of, reading_of) -> Output:
    """summary.json; `title_of(metric)` and `reading_of(metric, value, lower, upper)` give its numbers as people read them."""
    content = json.loads(text)
    claims = []

    def add(label: str, metric: dict, null: str, difference: dict, value: str) -> None:
        at_once = "_corrected" if difference["lower_corrected"] is not None else ""
        shown = reading_of(metric, difference[value], difference[f"lower{at_once}"], difference[f"upper{at_once}"])
        p = difference["p_adjusted"]
        conclusion = difference["conclusion"]
        if difference["differs"] is not None and difference["differs"] != (conclusion in ("above", "below")):
            conclusion = f"differs is {difference['differs']}, conclusion {conclusion}"
        if conclusion == "not compared":
            p = None  # of a raw difference next to the answer
        claims.append(
            Claim(
                label,
                title_of(metric),
                null,
                shown,
                "" if p is None else "<0.001" if p < 0.0005 else f"{p:.3f}",
                conclusion,
            )
        )

    for one in content["sets"]:
        for metric in one["metrics"]:
            for baseline in metric["baselines"]:
                if baseline["role"] == "null" or baseline["name"] == "shadow":  # a reference next to a neutral null
                    add(
                        one["set"],
                        metric,
                        baseline["name"],
                        {**baseline, "conclusion": baseline["conclusion"] or "not compared"},
                        "difference",
                    )
    for metric in content.get("differences", []):
        for kind in ("over_shadow", "raw"):
            if metric[kind]["value"] is not None:
                add("", metric, kind, metric[kind], "value")
    counts = [(content["family"]["comparisons"], content["family"]["significant"])]
    return Output(
        claims,
        counts,
        [finding["sentence"] for finding in content["findings"]],
        [one["set"] for one in content["sets"]],
    )


def of_csv(text: str, title_of, reading_of) -> Output:
    """means.csv or differences.csv. A row with a corrected p value is tested, and significant if that is at most 0.05."""
    claims, found, tested = [], 0, 0
    rows = list(csv.DictReader(io.StringIO(text)))
    for row in rows:
        if not row.get("null", "differences") or not row["difference"]:
            continue
        value, lower, upper = (
            float(row[name]) if row.get(name) else None
            for name in (
                ("difference", "lower_corrected", "upper_corrected")
                if row["lower_corrected"]
                else ("difference", "difference_lower", "difference_upper")
                if "null" in row
                else ("difference", "lower", "upper")
            )
        )
        is_answer = row.get("compared") != "raw" or not any(one["compared"] == "over_shadow" for one in rows)
        p = float(row["p_holm"]) if row["p_holm"] and is_answer else None
        tested += p is not None
        found += p is not None and p <= 0.05
        conclusion = (
            "same"
            if row["same_as"] and is_answer
            else ""
            if p is None
            else "inconclusive"
            if p > 0.05
            else "above"
            if value > 0
            else "below"
        )
        claims.append(
            Claim(
                row.get("set", ""),
                title_of(row),
                row.get("null") or row["compared"],
                reading_of(row, value, lower, upper),
                "" if p is None else "<0.001" if p < 0.0005 else f"{p:.3f}",
                conclusion,
            )
        )
    return Output(claims, [(tested, found)], [], list(dict.fromkeys(row["set"] for row in rows if "set" in row)))


def contradictions(outputs: dict[str, Output]) -> list[str]:
    """What two outputs about the same sets say differently, each in a sentence. The first output is the one that others are held against."""
    (first, truth), *others = outputs.items()
    wrong = []
    known = {(claim.set, claim.metric, claim.null): claim for claim in truth.claims}
    lone = len({claim.set for claim in truth.claims}) <= 1
    for name, output in others:
        for claim in output.claims:
            key = (claim.set or (truth.claims[0].set if lone and truth.claims else ""), claim.metric, claim.null)
            of = known.get(key)
            if claim.difference in ("missing", "") and (of is None or of.difference == "missing"):
                continue
            if of is None:
                wrong.append(f"{name} has {key}, {first} has not")
                continue
            if claim.difference != of.difference or claim.p != of.p:
                wrong.append(f"{name}: {key}: {claim.difference} (p {claim.p}), in {first} {of.difference} (p {of.p})")
            said, other = claim.conclusion, of.conclusion
            if said == "significant":
                said = other if other in ("above", "below") else said
            if said and said != other:
                wrong.append(f"{name}: {key}: {said}, in {first} {other}")
        for comparisons, significant in output.counts:
            if (comparisons, significant if significant is not None else truth.counts[0][1]) != truth.counts[0]:
                wrong.append(f"{name}: {significant} of {comparisons} comparisons, in {first} {truth.counts[0]}")
        if output.findings and output.findings != truth.findings[: len(output.findings)]:
            wrong.append(f"{name}: findings {output.findings}, in {first} {truth.findings}")
        if output.names and output.names != truth.names[: len(output.names)]:
            wrong.append(f"{name} is about {output.names}, {first} about {truth.names}")
    return wrong
