# SPDX-License-Identifier: MIT
"""A card for each policy: what its doc block and its Params say, which tables use it, and what swapping it changed (studies/results)."""

import dataclasses
import pathlib
import re

import references
import rule_pictures
from documents import parse

KINDS = ("perception", "control", "reproduction", "death", "energy", "initialization")


@dataclasses.dataclass
class Card:
    header: str  # trophic/death/floor/no_floor.hpp
    slot: str  # its folder
    kind: str
    type: str
    name: str
    source: str
    doc: list[str]
    params: list[tuple[str, str, str, str]]  # name, default, bounds, meaning
    state: bool
    is_template: bool = False


def params_of(body: str, folder: pathlib.Path | None = None) -> list[tuple[str, str, str, str]]:
    """Name, default, bounds and meaning of each number that fields() lists; policies of a folder may share the struct that has them."""
    if "Params params;" not in body:
        return []
    shared = re.search(r"using Params = detail::(\w+);", body)
    if shared and folder:
        texts = [path.read_text() for path in sorted((folder / "detail").glob("*.hpp"))]
        body = next(text[text.index(f"struct {shared[1]} ") :] for text in texts if f"struct {shared[1]} " in text)
        fields = body[body.find("fields()") : body.find("\n};")]
    else:
        fields = body[body.find("fields()") : body.find("Params params;")]
    params = []
    for name, bounds, meaning in re.findall(r'field\("(\w+)", &\w+::\w+,\s*(?:([^"]*?),\s*)?"([^"]*)"\)', fields):
        default = re.search(rf"\b{name} = ([^;]+);", body)
        params.append((name, default[1] if default else "", " ".join(bounds.split()), meaning))
    return params


def doc_lines(comment: str) -> list[str]:
    return [line.removeprefix("///").removeprefix(" ") for line in comment.splitlines()]


def read_alias(path: pathlib.Path, include: pathlib.Path) -> Card | None:
    """A policy that is a template of its folder with its arguments: its doc block, then the template's."""
    header = path.relative_to(include)
    alias = re.search(r"((?:^///.*\n)+)using (\w+) = (\w+)<[^;]*>;\nstatic_assert", path.read_text(), re.MULTILINE)
    if not alias:
        return None
    general = next(other for other in path.parent.glob("*.hpp") if re.search(rf"^struct {alias[3]}\b", other.read_text(), re.MULTILINE))
    text = general.read_text()
    base = re.search(rf"((?:^///.*\n)+)template <[^\n]*>\nstruct {alias[3]}\b", text, re.MULTILINE)
    kind, slot = header.parts[1:3]
    doc = [*doc_lines(alias[1]), "", *doc_lines(base[1])]
    return Card(str(header), slot, kind, alias[2], snake(alias[2]), "", doc, params_of(text[base.start() :]), False)


def read_made_of_parts(path: pathlib.Path, include: pathlib.Path) -> Card | None:
    """A policy made of policies, which has no name, source and parameters but those of its parts."""
    header = path.relative_to(include)
    whole = re.search(r"((?:^///.*\n)+)template <[^\n]*>\nstruct (\w+) : Parts<", path.read_text(), re.MULTILINE)
    return Card(str(header), header.parts[2], header.parts[1], whole[2], snake(whole[2]), "", doc_lines(whole[1]), [], False, True) if whole else None


def read(path: pathlib.Path, include: pathlib.Path) -> Card | None:
    text = path.read_text()
    header = str(path.relative_to(include))
    struct = re.search(r"((?:^///.*\n)+)(?:template <[^\n]*>\n)?^struct (\w+) (?:final )?(?::[^{]*)?\{\n(?:  static_assert.*;\n|  static_assert[^;]*;\n|  static constexpr std::array<char[^;]*;\n)*  static constexpr std::string_view name\b", text, re.M)
    if not struct:
        return read_made_of_parts(path, include) or read_alias(path, include)
    doc = doc_lines(struct[1])
    body = re.sub(r"^ *///.*\n", "", text[struct.start() :], flags=re.MULTILINE)  # a doc block may have formulas like "hidden = ..."
    kind, *folders = pathlib.PurePath(header).parts[1:-1]
    name = re.search(r'string_view name = "([^"]*)"', body)
    source = re.search(r'string_view source =\s*"((?:[^"\\]|\\.)*)"', body)
    is_template = "template <" in struct[0]
    if not source or not (name or is_template):
        return None
    prose = " ".join(doc)
    if not re.search(r"Random draws?:", prose):
        raise SystemExit(f"rule cards: {header}: the doc block of {struct[2]} does not say how many random numbers it draws")
    if not re.search(r"\bRules?\b[^:.]*:", prose):
        raise SystemExit(f"rule cards: {header}: the doc block of {struct[2]} has no 'Rule:'")
    return Card(header, folders[0] if folders else kind, kind, struct[2], name[1] if name else snake(struct[2]), source[1].replace('\\"', '"'), doc, params_of(body, path.parent), "struct State" in body, is_template)


def tables(include: pathlib.Path) -> dict[str, list[tuple[str, str]]]:
    """Policy's type -> (table, slot) in which it stands."""
    used: dict[str, list[tuple[str, str]]] = {}
    for table in ("paper", "released"):
        text = (include / f"trophic/rules/{table}.hpp").read_text()
        for slot, policy in re.findall(r"using (\w+) =\s*(.*?);", text, re.DOTALL):
            for name in re.findall(r"(\w+)(?=[,<>\s]|$)", policy):
                used.setdefault(name, []).append((table, slot))
    return used


def snake(slot: str) -> str:
    return re.sub(r"(?<!^)([A-Z])", r"_\1", slot).lower()


def swaps(root: pathlib.Path) -> list[list[str]]:
    """The rows of the tables of rule swaps: put into, metric, before, after, difference, p."""
    rows = []
    for table in parse(root / "studies/results/ablations.md").tables:
        if table.rows[0][0].startswith("put into"):
            into = re.sub(r"[`\s]|put into", "", table.rows[0][0])
            rows += [[into, *row] for row in table.rows[2:]]
    return rows


def escaped(text: str) -> str:
    return re.sub(r"([<>@\\#])", r"\\\1", text)


def first_sentence(card: Card) -> str:
    """The first sentence of a policy's doc block."""
    prose = " ".join(line.strip() for line in card.doc if not line.startswith("  "))
    prose = re.sub(r"^.*?\bRules?\b(?:\s*\([^)]*\))?[^:.]*:\s*", "", prose) or prose
    prose = re.sub(r"\s*\((?:[^()]*\bSec\.|released code|ties:)[^)]*\)", "", prose)
    sentence = re.match(r"(.+?)[.:;](?:\s|$)", prose)
    text = sentence[1] if sentence else prose
    return text[:1].upper() + text[1:] + "."


def use_of(card: Card, used: dict, slots: set[str]) -> list[str]:
    """How one swaps it into a table, and sets its parameters."""
    lines = []
    if card.slot in slots and not card.is_template:
        space = f"trophic::{card.kind}" + (f"::{card.slot}" if card.slot != card.kind else "")
        lines += ["**To use it:**", "", "```{.cpp}", f"#include <{card.header}>", f"using Rules = trophic::with_{card.slot}<trophic::rules::Paper, {space}::{card.type}>;", "```", ""]
    tables = [(table, snake(slot)) for table, slot in used.get(card.type, [])]
    if card.params and len(tables) > 0 and tables[0][1] == card.slot and card.params[0][1]:
        table, slot = tables[0]
        rules = "" if table == "paper" else f"--rules {table} "
        lines += ["**To set its parameters:**", "", "```{.unparsed}", f"trophic-predator-prey {rules}--set rules.{slot}.{card.params[0][0]}={card.params[0][1]}", "```", ""]
    return lines


def slots_of(include: pathlib.Path) -> set[str]:
    """Those that `with_SLOT` swaps as a whole; a sensor and a procedure's part are swapped in their own ways."""
    return set(re.findall(r"^  SLOT\(\w+, (\w+),", (include / "trophic/rules/slots.hpp").read_text(), re.MULTILINE)) - {"sensors", "starvation"}


def page(card: Card, used: dict, swapped: list[list[str]], keys: set[str], slots_swapped: set[str]) -> str:
    prose, formula = [], []
    for line in card.doc:
        (formula if line.startswith("  ") else prose).append(line)
        if line.startswith("  "):
            prose.append(f"\x01{line.strip()}")
    place = f"{card.kind}/{card.slot}" if card.slot != card.kind else card.kind
    lines = [f"{card.type} {{#card_{card.slot}_{card.name}}}", "=" * 20, "", f"A rule of the slot `{place}`.", ""]
    text: list[str] = []
    for line in prose:
        if line.startswith("\x01"):
            text.append(f"\n\n    {line[1:]}\n\n")
        else:
            text.append(escaped(line))
    body = "\n".join(text)
    body = re.sub(r"\s*Reads:\s*", "\n\n**Reads.** ", body)
    body = re.sub(r"\s*Random draws?:\s*", "\n\n**Random draws.** ", body)
    body = re.sub(r"\b(Rules?\b[^:.]*):\s*", r"**\1.** ", body, count=1)
    lines += [body, ""]
    picture = rule_pictures.picture_of(card)
    if picture:
        lines += [f"![{picture[1]}]({picture_name(card)})", ""]
    if card.source:
        lines += [f"**Source.** {escaped(card.source)}", ""]
    if card.params:
        lines += ["| number | default | bounds | meaning |", "|---|---|---|---|"]
        lines += [f"| `{field}` | `{default}` | {bounds and f'`{bounds}`'} | {escaped(meaning)} |" for field, default, bounds, meaning in card.params] + [""]
    else:
        lines += ["It has no parameters.", ""]
    if card.state:
        lines += ["It keeps a `State` for each body.", ""]
    lines += use_of(card, used, slots_swapped)
    places = used.get(card.type, [])
    if places:
        lines += ["**Tables that use it.** " + ", ".join(f"`{table}` as `{slot}`" for table, slot in places), ""]
    else:
        lines += ["**Tables that use it.** None that is shipped.", ""]
    slots = {snake(slot) for _, slot in places}
    told = [row for row in swapped if row[1].split(".")[0] in slots]
    lines += ["**Significant effects of swapping its slot or one of its parameters**, on the kinematic backend ([ablations](@ref page_studies_results_ablations)):", ""]
    if told:
        lines += ["| into | swapped | metric | before | after | difference | p |", "|---|---|---|---|---|---|---|"]
        lines += ["| " + " | ".join(escaped(cell) for cell in row) + " |" for row in told] + [""]
    else:
        lines[-2] = ("**Swapping its slot or one of its parameters** changes no metric significantly on the kinematic backend; "
                     "this does not show that it has no effect ([ablations](@ref page_studies_results_ablations)).")
    lines += [f"The header: [{card.header}](@ref {card.header}).", ""]
    return references.linked("\n".join(lines), keys)


def picture_name(card: Card) -> str:
    return f"rule_{card.slot}_{card.name}.svg"


def write(root: pathlib.Path, out: pathlib.Path, images: pathlib.Path) -> list[Card]:
    include = root / "include"
    headers = [path for kind in KINDS for path in sorted((include / "trophic" / kind).rglob("*.hpp")) if "detail" not in path.parts]
    cards = [card for path in headers if (card := read(path, include))]
    used, swapped, keys = tables(include), swaps(root), set(references.entries(root))
    index = ["Rule cards {#rule_cards}", "=" * 20, "", "One page for each policy, made from its doc block.", ""]
    for kind in KINDS:
        index += [f"## {kind} {{#cards_{kind}}}", ""]
        for slot in sorted({card.slot for card in cards if card.kind == kind}):
            index += [f"**{slot}**", ""]
            for card in (card for card in cards if card.kind == kind and card.slot == slot):
                if picture := rule_pictures.picture_of(card):
                    (images / picture_name(card)).write_text(picture[0])
                (out / f"card_{card.slot}_{card.name}.md").write_text(page(card, used, swapped, keys, slots_of(include)))
                index.append(f"- @subpage card_{card.slot}_{card.name} &ndash; {escaped(first_sentence(card))}")
            index.append("")
    (out / "rule_cards.md").write_text("\n".join(index))
    return cards
