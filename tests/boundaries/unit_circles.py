#!/usr/bin/env python3
"""Circles between units. A unit is a header with its source (and its -inl.h); it depends on the units whose headers it
includes. Units that reach each other form a circle, although no file includes itself.

unit_circles.py [ROOT]: prints the circles among the product's folders below ROOT; ends with 1 where there is one."""

import pathlib
import re
import sys

PRODUCT = ("processing", "io", "widgets", "app")
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def product_files(root):
    """Every header and source of the product's folders, as paths relative to root."""
    files = (path for folder in PRODUCT for path in (root / folder).rglob("*") if path.suffix in (".h", ".cpp"))
    return sorted(path.relative_to(root) for path in files)


def unit_of(path):
    return str(path.with_suffix("")).removesuffix("-inl")


def dependencies(root):
    """For each unit the other units whose files it includes."""
    files = product_files(root)
    known = {unit_of(path) for path in files}
    graph = {unit: set() for unit in known}
    for path in files:
        for name in INCLUDE.findall((root / path).read_text(encoding="utf-8")):
            target = unit_of(pathlib.PurePosixPath(name))
            if target in known and target != unit_of(path):
                graph[unit_of(path)].add(target)
    return graph


def circles(graph):
    """The sets of two or more units that reach each other (Tarjan's strongly connected components)."""
    order, lowest, path, found = {}, {}, [], []

    def visit(unit):
        order[unit] = lowest[unit] = len(order)
        path.append(unit)
        for target in sorted(graph[unit]):
            if target not in order:
                visit(target)
                lowest[unit] = min(lowest[unit], lowest[target])
            elif target in path:
                lowest[unit] = min(lowest[unit], order[target])
        if lowest[unit] == order[unit]:
            members = path[path.index(unit):]
            del path[path.index(unit):]
            if len(members) > 1:
                found.append(sorted(members))

    sys.setrecursionlimit(10000)
    for unit in sorted(graph):
        if unit not in order:
            visit(unit)
    return found


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    graph = dependencies(root)
    found = circles(graph)
    for members in found:
        print(f"a circle of {len(members)} units:")
        for unit in members:
            print(f"  {unit} -> {', '.join(sorted(graph[unit] & set(members)))}")
    print(f"{len(graph)} units, {len(found)} circles between them, {sum(map(len, found))} units in circles")
    return 1 if found or not graph else 0


if __name__ == "__main__":
    sys.exit(main())
