#!/usr/bin/env python3
"""The picture of the house in docs/house.svg, made from the includes.

    tests/support/house.py > docs/house.svg

A room stands above all rooms whose headers its files include; an arrow that follows from two others is left out.
"""
import html
import re
import sys

import project

FAMILIES = "algorithms"  # each topic includes core alone, or a topic of its own family: one room for all families
WIDTH, ROW, BOX = 1400, 88, 46
COLUMNS = {  # from left to right, and what a room is for
    "algorithms": (0, "the topics, each alone"),
    "pipeline/scene": (0, "models, cameras"),
    "pipeline": (0, "eight stages, chained"),
    "algorithms/core": (1, "numbers, rasters, observers"),
    "visualize/stories": (1, "what a step shows and says"),
    "visualize/json": (1, "runs for other programs"),
    "visualize/request": (0, "what is asked for, read"),
    "visualize/source": (6, "headers for others"),
    "visualize/check": (2, "others' answers, judged"),
    "visualize/live": (0, "the module of live pages"),
    "visualize/web": (1, "player and pages"),
    "visualize/cli": (1, "the command"),
    "visualize/figure": (2, "traces, wording, layout"),
    "visualize/theme": (2, "colours and fonts"),
    "visualize/cairo": (2, "SVG, PNG, PDF"),
    "visualize/office": (3, "slides to edit"),
    "visualize/worksheet": (4, "exercises with blanks"),
    "visualize/text": (4, "tables"),
    "visualize/plot": (5, "diagrams of benchmarks"),
}


def room_of(path):
    """The room of a file, "visualize/figure", from its path in the repository."""
    parts = path.split("/")
    if parts[0] == FAMILIES:
        return "algorithms/core" if parts[1] == "core" else FAMILIES
    if parts[0] == "pipeline":
        return "pipeline/scene" if parts[1] == "scene" else "pipeline"
    return "/".join(parts[:2])


def includes(root=project.ROOT):
    """{room: the other rooms whose headers its files include}"""
    found = {}
    for file in project.sources(root, "algorithms", "pipeline", "visualize"):
        room = room_of(file.relative_to(root).as_posix())
        for header in re.findall(r'^#include "([^"]+)"', file.read_text(encoding="utf-8"), re.MULTILINE):
            for place in ("algorithms", "pipeline", "visualize"):
                if (root / place / header).is_file():
                    found.setdefault(room, set()).add(room_of(f"{place}/{header}"))
    rooms = set(found).union(*found.values())
    return {room: found.get(room, set()) - {room} for room in rooms}


def floors(graph):
    """{room: how many rooms lie below it at most}; ValueError for rooms that include each other."""
    known = {}

    def floor(room, above=()):
        if room in above:
            raise ValueError(" includes ".join((*above[above.index(room):], room)))
        if room not in known:
            known[room] = max((floor(below, (*above, room)) + 1 for below in graph[room]), default=0)
        return known[room]
    for room in sorted(graph):
        floor(room)
    return known


def reduced(graph):
    """The graph without edges that follow from others."""
    reach = {}

    def below(room):
        if room not in reach:
            reach[room] = set(graph[room]).union(*(below(b) for b in graph[room]))
        return reach[room]
    return {room: {b for b in graph[room] if not any(b in below(other) for other in graph[room] - {b})} for room in graph}


def hung(graph, floor_of):
    """The floors with every room as high as those that include it let it be."""
    found = {}

    def floor(room):
        if room not in found:
            above = [other for other in graph if room in graph[other]]
            found[room] = min((floor(other) - 1 for other in above), default=floor_of[room])
        return found[room]
    for room in graph:
        floor(room)
    return found


STEP = WIDTH / (1 + max(column for column, _ in COLUMNS.values()))


def places(floor_of):
    """{room: (middle, top)}; ValueError for two rooms in one place."""
    highest = max(floor_of.values())
    place = {room: (STEP * (COLUMNS[room][0] + 0.5), 16 + (highest - floor) * ROW) for room, floor in floor_of.items()}
    if len(set(place.values())) < len(place):
        raise ValueError("two rooms stand in one place: one needs another column")
    return place


def picture(root=project.ROOT):
    graph = includes(root)
    place = places(hung(graph, floors(graph)))
    height = 16 + max(top for _, top in place.values()) + BOX
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" font-family="sans-serif" role="img">',
           "<title>The rooms of the house: each includes only those below it</title>",
           '<style>rect { fill: #f4f6f8; stroke: #33475b } path { fill: none; stroke: #8296a8 } text { text-anchor: middle; '
           "fill: #1b2733 }</style>",
           '<defs><marker id="end" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
           '<path d="M0,0 L8,4 L0,8" style="stroke: #8296a8"/></marker></defs>']
    for room, below in sorted(reduced(graph).items()):
        x, top = place[room]
        for other in sorted(below):
            to, under = place[other]
            start, end = x + (to - x) / 10, to - (to - x) / 10
            out.append(f'<path d="M{start:g},{top + BOX} L{end:g},{under - 2}" marker-end="url(#end)"/>')
    width = STEP - 24
    for room, (x, top) in sorted(place.items()):
        out.append(f'<rect x="{x - width / 2:g}" y="{top}" width="{width:g}" height="{BOX}" rx="4"/>')
        out.append(f'<text x="{x:g}" y="{top + 20}" font-size="15" font-weight="bold">{room}</text>')
        out.append(f'<text x="{x:g}" y="{top + 37}" font-size="12">{html.escape(COLUMNS[room][1])}</text>')
    return "\n".join([*out, "</svg>", ""])


if __name__ == "__main__":
    sys.stdout.write(picture())
