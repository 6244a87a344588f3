# SPDX-License-Identifier: MIT
"""Pictures of rules: who sees, catches or activates, and curves of formulas, drawn from the parameters in the headers.

A robot is a ring with a pointer in its heading, as in pages and films: blue is prey, vermilion a predator, grey not yet active; a filled
ring is one tag, a hollow one another."""

import math
import random

PREY, PREDATOR, GREY, INK, FAINT = "#0072b2", "#d55e00", "#9aa1a9", "#1d2733", "#cbd3da"
CATCH = "#c2002f"
WIDTH, HEIGHT = 460, 190


def svg(parts: list[str], title: str) -> str:
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" role="img" '
            f'font-family="sans-serif" font-size="12"><title>{title}</title><rect width="{WIDTH}" height="{HEIGHT}" rx="8" fill="#f6f8f9"/>'
            + "".join(parts) + "</svg>\n")


def text(x: float, y: float, words: str, anchor: str = "middle", colour: str = INK) -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}">{words}</text>'


def robot(x: float, y: float, colour: str, filled: bool = True, heading_deg: float = 0.0, name: str = "") -> str:
    turn = math.radians(heading_deg)
    tip = (x + 17 * math.cos(turn), y - 17 * math.sin(turn))
    ring = f'<circle cx="{x}" cy="{y}" r="10" fill="{colour if filled else "#fff"}" fill-opacity="{0.45 if filled else 1}" stroke="{colour}" stroke-width="2.5"/>'
    pointer = f'<line x1="{x}" y1="{y}" x2="{tip[0]:.1f}" y2="{tip[1]:.1f}" stroke="{colour}" stroke-width="2.5"/>'
    return ring + pointer + (text(x, y + 27, name) if name else "")


def circle(x: float, y: float, radius: float, label: str) -> str:
    return (f'<circle cx="{x}" cy="{y}" r="{radius}" fill="none" stroke="{INK}" stroke-dasharray="5 4"/>'
            f'<line x1="{x}" y1="{y}" x2="{x}" y2="{y - radius}" stroke="{INK}" stroke-width="0.8"/>' + text(x + 6, y - radius + 15, label, "start"))


def arrow(x0: float, y0: float, x1: float, y1: float, colour: str = INK, crossed: bool = False) -> str:
    """A line between two rings; crossed out for what does not take place."""
    length = math.hypot(x1 - x0, y1 - y0)
    ux, uy = (x1 - x0) / length, (y1 - y0) / length
    ax, ay, bx, by = x0 + 14 * ux, y0 + 14 * uy, x1 - 16 * ux, y1 - 16 * uy
    head = f'<path d="M{bx:.1f} {by:.1f} l{-8 * ux + 4 * uy:.1f} {-8 * uy - 4 * ux:.1f} l{-8 * uy:.1f} {8 * ux:.1f} z" fill="{colour}"/>'
    dashes = ' stroke-dasharray="3 4"' if crossed else ""
    line = f'<line x1="{ax:.1f}" y1="{ay:.1f}" x2="{bx:.1f}" y2="{by:.1f}" stroke="{colour}" stroke-width="1.6"{dashes}/>'
    mx, my = (ax + bx) / 2, (ay + by) / 2
    cross = f'<path d="M{mx - 5:.1f} {my - 5:.1f} l10 10 m0 -10 l-10 10" stroke="{CATCH}" stroke-width="2.2"/>' if crossed else ""
    return line + ("" if crossed else head) + cross


def plot(points: list[tuple[float, float]], x_label: str, y_label: str, more: str = "") -> list[str]:
    """A curve with its axes, from the least to the largest value of each."""
    left, right, top, bottom = 58, WIDTH - 20, 30, HEIGHT - 38
    xs, ys = [x for x, _ in points], [y for _, y in points]
    low = min(0.0, *ys)
    place_x = lambda x: left + (right - left) * (x - min(xs)) / (max(xs) - min(xs))  # noqa: E731
    place_y = lambda y: bottom - (bottom - top) * (y - low) / (max(ys) - low)  # noqa: E731
    path = " ".join(f"{'M' if i == 0 else 'L'}{place_x(x):.1f} {place_y(y):.1f}" for i, (x, y) in enumerate(points))
    parts = [f'<path d="M{left} {top} V{bottom} H{right}" fill="none" stroke="{INK}"/><path d="{path}" fill="none" stroke="{PREY}" stroke-width="2.2"/>']
    parts += [text(left, bottom + 16, f"{min(xs):g}"), text(right, bottom + 16, f"{max(xs):g}", "end"), text(left - 6, top + 5, f"{max(ys):.3g}", "end")]
    parts += [text((left + right) / 2, HEIGHT - 8, x_label), text(left, 18, y_label, "start"), more]
    return parts


def parameters(card) -> dict[str, float]:
    """The defaults of a policy's parameters that are plain."""
    found = {}
    for name, default, _, _ in card.params:
        try:
            found[name] = float(default)
        except ValueError:
            continue
    return found


def capture(closest_only: bool):
    def draw(card) -> list[str]:
        reach = f"reach {parameters(card)['reach_m']:g} m"
        parts = [circle(150, 105, 72, reach), robot(150, 105, PREDATOR, name="hunter"), robot(196, 120, PREY, heading_deg=20), robot(110, 70, PREY, heading_deg=120)]
        parts += [robot(330, 60, PREY, heading_deg=200, name="out of reach"), arrow(150, 105, 196, 120, CATCH), arrow(150, 105, 110, 70, CATCH, crossed=closest_only)]
        return [*parts, text(330, 150, "the closest alone is caught" if closest_only else "all within reach are caught")]

    return draw


def visibility(sees_other_tag: bool, sees_far: bool, inactive_sees: bool):
    def draw(card) -> list[str]:
        far = parameters(card).get("range_m")
        parts = [robot(70, 95, PREDATOR, name="self"), robot(220, 40, PREY, heading_deg=180, name="same tag")]
        parts += [robot(220, 130, PREY, filled=False, heading_deg=180, name="other tag"), robot(390, 95, PREY, heading_deg=180, name="same tag, far")]
        parts += [arrow(70, 95, 220, 40), arrow(70, 95, 220, 130, crossed=not sees_other_tag), arrow(70, 95, 390, 95, crossed=not sees_far)]
        if far is not None:
            parts.append(text(150, 178, f"range {far:g} m"))
        if not inactive_sees:
            parts.append(text(WIDTH / 2, 180, "a robot that is not yet active perceives none"))
        return parts

    return draw


def activation(card) -> list[str]:
    values = parameters(card)
    label = f"{values['distance_m']:g} m"
    parts = [circle(150, 108, 70, label), robot(150, 108, PREDATOR, heading_deg=30), robot(190, 86, GREY, heading_deg=45, name="inactive")]
    return [*parts, robot(320, 70, PREY, heading_deg=30, name="becomes active"), arrow(190, 86, 320, 70)]


def scattered(card) -> list[str]:
    draws, placed = random.Random(4), []
    while len(placed) < 26:
        at = (draws.uniform(160, 300), draws.uniform(25, 165))
        if all(math.dist(at, other) > 20 for other in placed):
            placed.append(at)
    return [f'<rect x="145" y="10" width="170" height="170" fill="#fff" stroke="{INK}"/>', *(small(x, y, draws.uniform(0, 360)) for x, y in placed)]


def uniform_square(card) -> list[str]:
    draws = random.Random(4)
    half = parameters(card)["half_extent_m"]
    parts = [f'<rect x="145" y="10" width="170" height="170" fill="#fff" stroke="{INK}"/>', f'<rect x="153" y="18" width="154" height="154" fill="none" stroke="{FAINT}" stroke-dasharray="4 3"/>']
    parts += [small(draws.uniform(155, 305), draws.uniform(20, 170), 45) for _ in range(26)]
    return [*parts, text(325, 30, f"h = {half:g} m", "start")]


def small(x: float, y: float, heading_deg: float) -> str:
    turn = math.radians(heading_deg)
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5" fill="{PREY}" fill-opacity="0.5"/><line x1="{x:.1f}" y1="{y:.1f}" x2="{x + 9 * math.cos(turn):.1f}" y2="{y - 9 * math.sin(turn):.1f}" stroke="{PREY}" stroke-width="1.5"/>'


def normal(card) -> list[str]:
    sd = parameters(card)["sd"]
    points = [(x * sd / 20, math.exp(-0.5 * (x / 20) ** 2) / (sd * math.sqrt(2 * math.pi))) for x in range(-70, 71)]
    return plot(points, "change of a weight", "density")


def uniform(card) -> list[str]:
    half = parameters(card)["half_width"]
    height = 1 / (2 * half)
    return plot([(-1.6 * half, 0), (-half, 0), (-half, height), (half, height), (half, 0), (1.6 * half, 0)], "change of a weight", "density")


def crowding(card) -> list[str]:
    values = parameters(card)
    base, least = values["base_ticks"], values["min_interval_ticks"]
    return plot([(p, max(least, base - p)) for p in range(0, 31)], "number of hunters", "ticks between two procedures")


def old_age(card) -> list[str]:
    age = parameters(card)["max_age_s"]
    return plot([(0, 1), (age, 1), (age, 0), (1.4 * age, 0)], "age, s", "share that lives, without other deaths")


def steering(card) -> list[str]:
    exponent = parameters(card)["exponent"]
    return plot([(a / 50, max(0.0, (math.pi - abs(a / 50)) / math.pi) ** exponent) for a in range(-157, 158)], "target angle, rad", "delta, scale of one side's targets")


PICTURES = {
    ("capture", "catch_closest"): (capture(True), "A hunter, its reach and three prey; the closest within reach is caught"),
    ("capture", "catch_within_reach"): (capture(False), "A hunter, its reach and three prey; both within reach are caught"),
    ("visibility", "same_tag"): (visibility(False, True, True), "A robot perceives those with its own tag, at any distance"),
    ("visibility", "same_tag_if_active"): (visibility(False, True, False), "A robot perceives those with its own tag if both are active"),
    ("visibility", "all_active"): (visibility(True, True, True), "A robot perceives all active ones, whatever their tags"),
    ("visibility", "within_range"): (visibility(False, False, True), "A robot perceives those with its own tag that are near"),
    ("activation", "active_away_from_hunters"): (activation, "A newborn near a hunter is inactive; one farther away becomes active"),
    ("placement", "scattered"): (scattered, "Robots apart from each other on the floor, with any heading"),
    ("placement", "uniform_square"): (uniform_square, "Robots anywhere in a square, all with one heading"),
    ("mutation", "normal_mutation"): (normal, "Density of the change of a weight: a normal distribution"),
    ("mutation", "uniform_mutation"): (uniform, "Density of the change of a weight: a uniform distribution"),
    ("starvation", "delayed_crowding_interval"): (crowding, "The interval falls with the number of hunters, down to its least value"),
    ("starvation", "direct_crowding_interval"): (crowding, "The interval falls with the number of hunters, down to its least value"),
    ("senescence", "old_age"): (old_age, "All live until the maximum age, and none beyond it"),
    ("steering", "targeted_steering"): (steering, "The scale of one side's targets falls from 1 straight ahead to 0 behind"),
}


def picture_of(card) -> tuple[str, str] | None:
    """The picture of a card's rule and its caption, if it has one."""
    found = PICTURES.get((card.slot, card.name))
    return (svg(found[0](card), found[1]), found[1]) if found else None
