#!/usr/bin/env python3
"""Grades a student's picture against the expected one.

Usage: grade.py EXPECTED STUDENT
Exit codes: 0 passed, 1 failed, 2 cannot be graded. PNG, PPM and PFM are compared as 8-bit
levels. The program is $CATOPTRIC, or catoptric on the PATH.
"""

import json
import os
import subprocess
import sys

# The part of all pixels that may be off by more than one level: a tracer with other
# rounding decides a few pixels at edges otherwise.
ALLOWED = ["--tolerance", "1", "--allow", "0.1%"]


def compare(expected, student):
    """The report of `catoptric compare`; None where the pictures cannot be compared."""
    program = os.environ.get("CATOPTRIC", "catoptric")
    command = [program, "compare", expected, student, "--json", *ALLOWED]
    ran = subprocess.run(command, stdout=subprocess.PIPE)
    return json.loads(ran.stdout) if ran.returncode in (0, 1) else None


def verdict(report):
    """Whether it passed, and why."""
    if report["equal"]:
        return True, "equal"
    off = report["pixels_counted"]
    if report["passed"]:
        return True, f"{off} pixels are off by more than one level, which is few enough"
    part = off / (report["width"] * report["height"])
    first = report["first"]
    return False, (
        f"{off} pixels ({part:.1%}) are off by more than one level; the first difference is at"
        f" ({first['x']}, {first['y']}): expected {first['a']}, found {first['b']}"
    )


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: grade.py EXPECTED STUDENT")
    report = compare(*sys.argv[1:])
    if report is None:
        print("cannot be graded")
        sys.exit(2)
    passed, why = verdict(report)
    print("passed:" if passed else "failed:", why)
    sys.exit(0 if passed else 1)
