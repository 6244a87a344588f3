# SPDX-License-Identifier: MIT
"""Draws docs/performance.png and fills the first two tables of docs/performance.md from the output of bench_mujoco.
Measures and does both: cmake --build build/ci --target performance

    python3 docs/performance.py docs/performance.txt docs/performance.png docs/performance.md
"""
import re
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

# Okabe and Ito's colours, which colour-blind readers distinguish; line styles and markers differ too.
WAYS = (
    ("fast, 2 threads", "#0072B2", "o", "-"),
    ("fast, 1 thread", "#56B4E9", "s", "--"),
    ("one model, mj_step", "#D55E00", "^", "-."),
)


def read(path):
    """Number of robots -> robot-steps per second of one model, fast_1, fast_2 (None where not measured)."""
    table = {}
    inside = False
    with open(path) as file:
        for line in file:
            if "bytes per robot" in line:
                inside = True
            elif inside and re.fullmatch(r"(\s+[\d-]+){5}\s*", line):
                robots, *speeds = line.split()[:4]
                table[int(robots)] = [None if speed == "-" else float(speed) for speed in speeds]
    if not table:
        sys.exit(f"{path}: no table of robot-steps per second")
    return table


def number(speed):
    """Steps per second as the documents write them; empty where not measured."""
    if speed is None:
        return ""
    return f"{speed / 1e6:.2f} million" if speed >= 99500 else f"{speed / 1e3:.0f} thousand"


def rows_of(path):
    """Header of a table in the documents -> its rows, made from what bench_mujoco printed."""
    times, speeds = [], []
    inside = False
    with open(path) as file:
        for line in file:
            inside = inside or "bytes per robot" in line
            if not re.match(r"\s+\d+\s", line):
                continue
            if inside:
                robots, whole, one, two, memory = (None if cell == "-" else float(cell) for cell in line.split())
                start = f"| {robots:,.0f} | {number(whole)} | {number(one)} | {number(two)} |".replace("|  |", "| |")
                speeds.append(f"{start} {memory:,.0f} |")
            else:
                robots, whole, *ways = line.replace("= 1/", "").split()
                cells = (
                    f"{time if float(time) < 100 else round(float(time))} ({ratio(times_faster)})"
                    for time, times_faster in zip(ways[::2], ways[1::2])
                )
                whole = whole if float(whole) < 100 else round(float(whole))
                times.append(f"| {robots} | {whole} | " + " | ".join(cells) + " |")
    return {"| robots | one model | islands, 1 thread |": times, "| robots | one model | fast, 1 thread |": speeds}


def ratio(text):
    return text if float(text) < 100 else f"{float(text):.0f}"


def fill(document, tables):
    """Replaces the rows of each table that the document has."""
    with open(document) as file:
        lines = file.read().splitlines()
    for header, rows in tables.items():
        starts = [i for i, line in enumerate(lines) if line.startswith(header)]
        for start in starts:
            end = start + 2
            while end < len(lines) and lines[end].startswith("|"):
                end += 1
            lines[start + 2 : end] = rows
    with open(document, "w") as file:
        file.write("\n".join(lines) + "\n")


def main(source, target, document):
    table = read(source)
    tables = rows_of(source)
    fill(document, tables)
    figure, axes = plt.subplots(figsize=(7.0, 4.2), dpi=150)
    for (label, colour, marker, style), column in zip(WAYS, (2, 1, 0)):
        points = [(robots, speeds[column]) for robots, speeds in sorted(table.items()) if speeds[column]]
        x, y = zip(*points)
        axes.plot(x, y, style, color=colour, marker=marker, markersize=6, linewidth=1.8)
        axes.annotate(
            label, (x[-1], y[-1]), xytext=(8, 0), textcoords="offset points", color="#333333", va="center", fontsize=10
        )
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(0.8, 4e6)
    axes.set_xticks([10**k for k in range(6)], ["1", "10", "100", "1,000", "10,000", "100,000"])
    axes.set_ylim(1e4, 1e7)
    axes.set_yticks([1e4, 1e5, 1e6, 1e7], ["10 thousand", "100 thousand", "1 million", "10 million"])
    axes.minorticks_off()
    axes.set_xlabel("spiders in the arena, each with a gait of its own")
    axes.set_ylabel("physics steps of one robot per second")
    axes.grid(True, color="#dddddd", linewidth=0.8)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    figure.tight_layout()
    figure.savefig(target)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
