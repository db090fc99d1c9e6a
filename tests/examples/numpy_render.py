#!/usr/bin/env python3
"""A scene made in Python, its picture as a numpy array.

The scene goes to the program as JSON on stdin, the picture comes back as PFM on stdout;
no file is written. The program is $CATOPTRIC, or catoptric on the PATH.
"""

import json
import os
import subprocess
import sys

import numpy


def render(scene, *options):
    """Linear RGB of a scene: float32, shape (height, width, 3), the top row first."""
    program = os.environ.get("CATOPTRIC", "catoptric")
    command = [program, "render", "-", "-o", "-", "--format", "pfm", "--quiet", *options]
    ran = subprocess.run(command, input=json.dumps(scene).encode(), stdout=subprocess.PIPE)
    if ran.returncode != 0:
        sys.exit(ran.returncode)  # The program has said why on stderr.
    kind, size, scale, pixels = ran.stdout.split(b"\n", 3)
    assert kind == b"PF" and float(scale) < 0, "little-endian RGB"
    width, height = map(int, size.split())
    return numpy.frombuffer(pixels, "<f4").reshape(height, width, 3)[::-1]


def row_of_mirrors(count):
    """Mirrors side by side on a floor."""
    return {
        "image": {"width": 160, "height": 90},
        "camera": {"position": [0, 1, 8], "look_at": [0, 0, 0], "fov": 40},
        "render": {"max_depth": 6, "background": [0.2, 0.3, 0.5]},
        "lights": [{"position": [5, 9, 6]}],
        "materials": {"mirror": {"color": [0.8, 0.7, 0.6], "diffuse": 0.3, "specular": 0.7}},
        "spheres": [
            {"center": [2.1 * (i - (count - 1) / 2), 0, 0], "radius": 1, "material": "mirror"}
            for i in range(count)
        ],
        "planes": [{"point": [0, -1, 0], "normal": [0, 1, 0], "color": [0.5, 0.5, 0.5]}],
    }


if __name__ == "__main__":
    scene = row_of_mirrors(3)
    picture = render(scene)
    assert picture.shape == (90, 160, 3) and picture.dtype == numpy.float32
    sky = numpy.float32(scene["render"]["background"])
    assert (picture[0] == sky).all() and (picture[-1] != sky).any(), "the sky is above"
    recursive = render(scene, "--engine", "recursive")
    same = numpy.array_equal(picture.view(numpy.uint32), recursive.view(numpy.uint32))
    print(f"{picture.shape} {picture.dtype}, mean {picture.mean(axis=(0, 1))}")
    print("both engines give the same bits" if same else "the engines differ")
    sys.exit(0 if same else 1)
