#!/usr/bin/env python3
"""Circles between units, circles between rooms, and rooms that hold too much.

A unit is a header with its source (and its -inl.h); it depends on the units whose headers it includes. Units that reach
each other form a circle, although no file includes itself. A room is a folder; rooms without circles have an order, so
that no include goes up.

include_circles.py [ROOT]: prints what it finds among the product's folders below ROOT, and ends with 1 if there is
anything. include_circles.py ROOT --order prints the rooms, each below those that it knows."""

import collections
import pathlib
import re
import sys

PRODUCT = ("processing", "io", "widgets", "app")
MOST_FILES = 35  # of a room
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def product_files(root):
    """Every header and source of the product's folders, as paths relative to root."""
    files = (path for folder in PRODUCT for path in (root / folder).rglob("*") if path.suffix in (".h", ".cpp"))
    return sorted(path.relative_to(root) for path in files)


def unit_of(path):
    return str(path.with_suffix("")).removesuffix("-inl")


def room_of(path):
    return str(path.parent)


def dependencies(root, part_of):
    """For each unit or room the others whose files it includes; `part_of` gives that of a path."""
    files = product_files(root)
    graph = {part_of(path): set() for path in files}
    for path in files:
        for name in INCLUDE.findall((root / path).read_text(encoding="utf-8")):
            target = part_of(pathlib.PurePosixPath(name))
            if target in graph and target != part_of(path):
                graph[part_of(path)].add(target)
    return graph


def components(graph):
    """The parts in an order in which each follows those that it reaches, as sets: those of two or more are circles
    (Tarjan's strongly connected components)."""
    order, lowest, path, found = {}, {}, [], []

    def visit(part):
        order[part] = lowest[part] = len(order)
        path.append(part)
        for target in sorted(graph[part]):
            if target not in order:
                visit(target)
                lowest[part] = min(lowest[part], lowest[target])
            elif target in path:
                lowest[part] = min(lowest[part], order[target])
        if lowest[part] == order[part]:
            members = path[path.index(part):]
            del path[path.index(part):]
            found.append(sorted(members))

    sys.setrecursionlimit(10000)
    for part in sorted(graph):
        if part not in order:
            visit(part)
    return found


def tell_circles(graph, what):
    """Prints the circles and returns how many there are."""
    found = [members for members in components(graph) if len(members) > 1]
    for members in found:
        print(f"a circle of {len(members)} {what}:")
        for part in members:
            print(f"  {part} -> {', '.join(sorted(graph[part] & set(members)))}")
    print(f"{len(graph)} {what}, {len(found)} circles between them")
    return len(found)


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    rooms = dependencies(root, room_of)
    if "--order" in sys.argv:
        for members in components(rooms):
            print(", ".join(members))
        return 0
    found = tell_circles(dependencies(root, unit_of), "units") + tell_circles(rooms, "rooms")
    sizes = collections.Counter(room_of(path) for path in product_files(root))
    crowded = {room: files for room, files in sizes.items() if files > MOST_FILES}
    for room, files in crowded.items():
        print(f"{room} holds {files} files, more than {MOST_FILES}")
    return 1 if found or crowded or not rooms else 0


if __name__ == "__main__":
    sys.exit(main())
