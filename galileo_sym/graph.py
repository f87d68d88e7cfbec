"""What is derived from what: the graph of premises, held against what it must be, and drawn as DOT and SVG."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from xml.etree import ElementTree as ET

from galileo_sym.files import write_whole

COLOURS = {
    "law": "#f4c87a",
    "definition": "#f7e6a6",
    "proved": "#cfe8cf",
    "certified": "#bfe3e0",
    None: "#ffffff",  # named as a premise only
}
FAILED = "#f2a0a0"
ROW, COLUMN, WIDTH, HEIGHT = 22, 330, 265, 16  # pixels: distances of boxes, and their size


def grounds(rows: list[dict]) -> dict[str, list[str]]:
    """Where chains of derivations end: laws, definitions, and identities, which are proved from no premise at all."""
    found: dict[str, list[str]] = {"law": [], "definition": [], "identity": []}
    for row in rows:
        if row["verdict"] in found:
            found[row["verdict"]].append(row["id"])
        elif not row["premises"]:
            found["identity"].append(row["id"])
    return found


def alone(rows: list[dict]) -> list[str]:
    """Ids that stand on nothing, and that nothing stands on."""
    used = {premise for row in rows for premise in row["premises"]}
    return [row["id"] for row in rows if not row["premises"] and row["id"] not in used]


def levels(rows: list[dict]) -> dict[str, int]:
    """How many derivations lie, at most, between each id and its grounds; the graph must have no circle."""
    premises = {row["id"]: row["premises"] for row in rows}
    found: dict[str, int] = {}

    def level(identifier):
        if identifier not in found:
            found[identifier] = 1 + max((level(p) for p in premises.get(identifier, ())), default=-1)
        return found[identifier]

    for row in rows:
        level(row["id"])
    return found


def dot(rows: list[dict]) -> str:
    """The graph in the language of Graphviz, chapters as clusters."""
    lines = ["digraph derivations {", "  rankdir=LR;", '  node [shape=box, style=filled, fontname="sans-serif"];']
    chapters: dict[str, list] = {}
    for row in rows:
        chapters.setdefault(row["chapter"], []).append(row)
    for chapter, inside in chapters.items():
        lines += [f'  subgraph "cluster_{chapter}" {{', f'    label="{chapter}";']
        lines += [f'    "{row["id"]}" [fillcolor="{_colour(row["verdict"])}"];' for row in inside]
        lines.append("  }")
    lines += [f'  "{premise}" -> "{row["id"]}";' for row in rows for premise in row["premises"]]
    return "\n".join([*lines, "}", ""])


def _colour(verdict):
    return COLOURS.get(verdict, FAILED)


def svg(rows: list[dict]) -> bytes:
    """The graph drawn from left to right, each box to the right of its premises; hover for statement and verdict.

    Needs the package igraph, which comes with ``galileo-sym[all]``.
    """
    places, links = _layout(rows)
    right, down = (max(p[n] for p in places.values()) for n in (0, 1))
    size = {"width": str(right + WIDTH + 40), "height": str(down + HEIGHT + 40)}
    root = ET.Element("svg", {"xmlns": "http://www.w3.org/2000/svg", **size, "font-family": "sans-serif"})
    ET.SubElement(root, "title").text = "What is derived from what"
    for link in links:
        ET.SubElement(root, "path", {"d": _curve(*link), "fill": "none", "stroke": "#8899aa", "stroke-width": "0.7"})
    known = {row["id"]: row for row in rows}
    for identifier, (x, y) in places.items():
        _box(root, identifier, known.get(identifier), x, y)
    return ET.tostring(root, encoding="utf-8", xml_declaration=True) + b"\n"


def _layout(rows):
    """The corner of each box, and the links: from where to where, one for each column that they cross.

    Whatever is derived from a premise hangs on one line from it, which runs on from column to column.
    """
    from igraph import Graph  # here: only a drawing needs it

    level = levels(rows)
    index = {identifier: n for n, identifier in enumerate(level)}
    layers = list(level.values())
    line = {i: [n] for i, n in index.items()}  # the premise, and the spots its line passes, by column
    edges = []
    for premise, row in sorted(((p, r["id"]) for r in rows for p in r["premises"]), key=lambda e: level[e[1]]):
        while len(line[premise]) < level[row] - level[premise]:
            layers.append(level[premise] + len(line[premise]))
            edges.append((line[premise][-1], len(layers) - 1))
            line[premise].append(len(layers) - 1)
        edges.append((line[premise][-1], index[row]))
    spots = Graph(len(layers), edges, directed=True).layout_sugiyama(layers=layers, hgap=1, vgap=1, maxiter=1000)
    top = min(along for along, _ in spots)
    points = [(round(20 + layer * COLUMN, 1), round(20 + (along - top) * ROW, 1)) for along, layer in spots]
    return {i: points[n] for i, n in index.items()}, [(points[a], points[b], b >= len(level)) for a, b in edges]


def _curve(start, end, runs_on):
    """A smooth path from the right side of one spot to the left side of the next, or past it if the line runs on."""
    (x, y), (left, level) = ((px, py + HEIGHT / 2) for px, py in (start, end))
    half = (x + WIDTH + left) / 2
    return f"M{x + WIDTH},{y} C{half},{y} {half},{level} {left},{level}" + (f" H{left + WIDTH}" if runs_on else "")


def _box(root, identifier, row, x, y):
    group = ET.SubElement(root, "g")
    verdict = row and row["verdict"]
    ET.SubElement(group, "title").text = f"{identifier}: {row['label']}; {verdict}" if row else identifier
    shape = {"x": str(x), "y": str(y), "width": str(WIDTH), "height": str(HEIGHT), "rx": "3"}
    ET.SubElement(group, "rect", {**shape, "fill": _colour(verdict), "stroke": "#556677", "stroke-width": "0.6"})
    ET.SubElement(group, "text", {"x": str(x + 5), "y": str(y + 12), "font-size": "10"}).text = identifier


def write(rows: list[dict], folder) -> list[str]:
    """Write derivations.dot and, if igraph is there, derivations.svg; returns what to tell of it."""
    target = Path(folder)
    write_whole(target / "derivations.dot", dot(rows).encode())
    told = [f"{target / 'derivations.dot'}: {len(rows)} entries, {sum(len(r['premises']) for r in rows)} premises"]
    if find_spec("igraph"):
        write_whole(target / "derivations.svg", svg(rows))
        told.append(str(target / "derivations.svg"))
    else:
        told.append("derivations.svg is not drawn: it needs the package igraph (pip install 'galileo-sym[all]')")
    ends = ", ".join(f"{kind} {len(ids)}" for kind, ids in grounds(rows).items())
    return [*told, f"chains end in: {ends}; {max(levels(rows).values())} derivations at most in a row"]
