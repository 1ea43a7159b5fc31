#!/usr/bin/python3
"""Bytes that one more particle, cell or node costs: the difference of the peak memory of two runs of different size, over that of their numbers.

    /usr/bin/python3 benchmarks/memory.py build

Each run takes a few steps, and frames where nothing else is said. Prints kind, both sizes and the bytes.
"""
import json
import os
import subprocess
import sys
import tempfile

SOURCE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FEW = ["Window=1e-5"]
KINDS = {  # name: (input, settings of both, [(settings of one size, how many) of a small and a large one])
    "SPH in 2D, viscous, a particle": ("full_micro", FEW, [(["Columns=8", "Rows=8"], None), (["Columns=16", "Rows=16"], None)]),
    "SPH in 2D, without frames, a particle": ("full_micro", FEW + ["Frames=0"], [(["Columns=8", "Rows=8"], None), (["Columns=16", "Rows=16"], None)]),
    "spheroid, a cell": ("spheroid_free", ["End time=60", "Samples=10", "Frames=0", "Checkpoints=0", "First phases=spread"],
                         [(["First cells=10000"], 1e4), (["First cells=100000"], 1e5)]),
}


def run(program, scene, settings):
    """Peak memory, and the particles that the run says it has."""
    with tempfile.TemporaryDirectory() as directory:
        command = [program, "run", os.path.join(SOURCE, "inputs", scene + ".prm"), "-o", os.path.join(directory, "run"), "--quiet", "--threads", "1"]
        for one in settings:
            command += ["--set", one]
        subprocess.run(command, check=True, stdin=subprocess.DEVNULL)
        with open(os.path.join(directory, "run", "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
    return summary["peak_memory_bytes"], summary["results"].get("particles", {}).get("value")


def main():
    program = os.path.join(sys.argv[1], "app", "turgor")
    for name, (scene, common, sizes) in KINDS.items():
        bytes_of, count = [], []
        for settings, known in sizes:
            peak, particles = run(program, scene, common + settings)
            bytes_of.append(peak)
            count.append(known or particles)
        print(f"{name:40s} {count[0]:9.0f} {count[1]:9.0f}  {(bytes_of[1] - bytes_of[0]) / (count[1] - count[0]):7.0f} bytes", flush=True)


if __name__ == "__main__":
    main()
