#!/usr/bin/python3
"""The rigid bodies of inputs and tests, as closed surfaces of triangles counter-clockwise seen from outside, in micrometres:

    /usr/bin/python3 inputs/reference/make_bodies.py          writes pillar.off and block.off beside itself

pillar.off: a prism of 24 sides, radius 20, height 80 along z, its middle at the origin. block.off: a box 60 x 60 x 20.
"""
import math
import os

HERE = os.path.dirname(os.path.abspath(__file__))


def prism(corners, height):
    """(nodes, faces) of a prism over a convex polygon, counter-clockwise seen from +z."""
    n = len(corners)
    nodes = [(x, y, z) for z in (-height / 2, height / 2) for x, y in corners] + [(0, 0, -height / 2), (0, 0, height / 2)]
    faces = []
    for k in range(n):
        after = (k + 1) % n
        faces += [(k, after, n + after), (k, n + after, n + k), (2 * n, after, k), (2 * n + 1, n + k, n + after)]
    return nodes, faces


def write(name, nodes, faces):
    with open(os.path.join(HERE, name), "w", encoding="utf-8") as file:
        file.write(f"OFF\n{len(nodes)} {len(faces)} 0\n")
        file.writelines("%.10g %.10g %.10g\n" % node for node in nodes)
        file.writelines("3 %d %d %d\n" % face for face in faces)


if __name__ == "__main__":
    write("pillar.off", *prism([(20 * math.cos(math.pi * k / 12), 20 * math.sin(math.pi * k / 12)) for k in range(24)], 80))
    write("block.off", *prism([(30, 30), (-30, 30), (-30, -30), (30, -30)], 20))
