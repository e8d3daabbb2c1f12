"""The table of systems in docs/performance.md as a picture: times of one forward dynamics, and operations.

    python3 benches/peers/systems/picture.py

reads what `compare.py` printed there, and writes docs/systems.svg.
"""

import math
from pathlib import Path

DOCS = Path(__file__).resolve().parents[3] / "docs"
# columns of the table, with a color and a shape that the color-blind tell apart
TIMES = {
    "ours, native": ("#0072b2", "circle"),
    "CasADi's C": ("#e69f00", "square"),
    "Pinocchio, ABA": ("#009e73", "triangle"),
    "MuJoCo, `mj_forward`": ("#cc79a7", "diamond"),
    "dynibo": ("#555555", "cross"),
}
OPERATIONS = {"operations": ("#0072b2", "circle"), "CasADi's": ("#e69f00", "square")}
HEADS = {"operations": "ours", "CasADi's": "CasADi's C", "MuJoCo, `mj_forward`": "MuJoCo"}
ROW, TOP, LEFT, WIDTH, GAP = 30, 64, 190, 330, 70


def table():
    """The rows below the heading that begins with `system`, by column."""
    lines = iter((DOCS / "performance.md").read_text().split("\n"))
    cells = lambda line: [cell.strip() for cell in line.strip("|").split("|")]
    heads = next(cells(line) for line in lines if line.startswith("| system |"))
    next(lines)
    for line in lines:
        if not line.startswith("|"):
            return
        yield dict(zip(heads, cells(line)))


def shape(kind, x, y, color):
    if kind == "circle":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5" fill="{color}"/>'
    outline = {
        "square": "-4.5,-4.5 4.5,-4.5 4.5,4.5 -4.5,4.5",
        "triangle": "0,-5.5 5.5,4.5 -5.5,4.5",
        "diamond": "0,-6 6,0 0,6 -6,0",
        "cross": "-5,-3 -3,-5 0,-2 3,-5 5,-3 2,0 5,3 3,5 0,2 -3,5 -5,3 -2,0",
    }[kind]
    return f'<polygon points="{outline}" transform="translate({x:.1f} {y:.1f})" fill="{color}"/>'


def words(x, y, anchor, text):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{text}</text>'


def panel(rows, columns, left, title, decades):
    """Columns of all rows on one logarithmic axis, with a legend above."""
    first, last = decades
    across = lambda value: left + WIDTH * (math.log10(value) - first) / (last - first)
    bottom = TOP + ROW * len(rows)
    yield words(left, 18, "start", f"<tspan font-weight='bold'>{title}</tspan>")
    at = left
    for name, (color, kind) in columns.items():
        yield shape(kind, at + 5, 37, color)
        yield words(at + 14, 41, "start", HEADS.get(name, name.split(",")[0]))
        at += 24 + 7.2 * len(HEADS.get(name, name.split(",")[0]))
    for decade in range(first, last + 1):
        x = across(10**decade)
        yield f'<line x1="{x:.1f}" y1="{TOP}" x2="{x:.1f}" y2="{bottom}" stroke="#dddddd"/>'
        yield words(x, bottom + 18, "middle", f"{10**decade:,}".replace(",", " "))
    for number, row in enumerate(rows):
        y = TOP + ROW * (number + 0.5)
        values = {name: sum(map(float, row[name].split("+"))) for name in columns if row[name]}
        ends = [across(pick(values.values())) for pick in (min, max)]
        yield f'<line x1="{ends[0]:.1f}" y1="{y}" x2="{ends[1]:.1f}" y2="{y}" stroke="#bbbbbb"/>'
        for name, value in values.items():
            color, kind = columns[name]
            yield shape(kind, across(value), y, color)


def main():
    rows = list(table())
    height = TOP + ROW * len(rows) + 30
    second = LEFT + WIDTH + GAP
    width = second + WIDTH + 30
    drawn = [words(LEFT - 14, TOP + ROW * (k + 0.5) + 4, "end", row["system"]) for k, row in enumerate(rows)]
    drawn += panel(rows, TIMES, LEFT, "ns for one forward dynamics", (1, 5))
    drawn += panel(rows, OPERATIONS, second, "operations, with sines and cosines", (1, 5))
    head = f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" font-family="sans-serif" font-size="13">'
    background = '<rect width="100%" height="100%" fill="white"/>'
    (DOCS / "systems.svg").write_text("\n".join([head, background, *drawn, "</svg>"]) + "\n")


if __name__ == "__main__":
    main()
