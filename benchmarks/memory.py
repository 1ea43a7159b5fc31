#!/usr/bin/python3
"""Bytes that one more particle, cell or node costs: the difference of the peak memory of two runs of different size, over that of their numbers.

    /usr/bin/python3 benchmarks/memory.py build
    /usr/bin/python3 benchmarks/memory.py build spheroid      those kinds whose name has this

Each run takes a few steps, and frames where nothing else is said. Prints kind, both sizes and the bytes.
"""
import json
import os
import subprocess
import sys
import tempfile

SOURCE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FEW = ["Window=1e-5"]
SHELL = ["Periods=4", "Samples per period=20", "Sound speed=20", "Harmonics=1", "Cell/Frequency=6", "Cell/Settle steps=2", "Cell/Anneal steps=100", "Cell/Rest residual=1"]
RVE = ["RVE/Rule=cauchy_born", "Path/Points=3", "Path/Tangents=false"]
KINDS = {  # name: (input, settings of both, [(settings of one size, how many) of a small and a large one])
    "SPH in 2D, viscous, a particle": ("full_micro", FEW, [(["Columns=8", "Rows=8"], None), (["Columns=16", "Rows=16"], None)]),
    "SPH in 2D, without frames, a particle": ("full_micro", FEW + ["Frames=0"], [(["Columns=8", "Rows=8"], None), (["Columns=16", "Rows=16"], None)]),
    "spheroid, a cell": ("spheroid_free", ["End time=60", "Samples=10", "Frames=0", "Checkpoints=0", "First phases=spread"],
                         [(["First cells=10000"], 1e4), (["First cells=100000"], 1e5)]),
    "SPH in 3D (shell_oscillation), a particle of fluid": ("shell_oscillation", SHELL, [(["Cell/Fluid particles=1000"], 1e3), (["Cell/Fluid particles=6000"], 6e3)]),
    "RVE of particles (cauchy_born, 584 a cell), a particle": ("rve_response", RVE + ["RVE/Fluid=sph"], [(["RVE/Columns=4", "RVE/Rows=4"], 584 * 16.), (["RVE/Columns=12", "RVE/Rows=12"], 584 * 144.)]),
    "RVE of walls alone (hydrostatic, 100 a cell), a node": ("rve_response", RVE, [(["RVE/Columns=4", "RVE/Rows=4"], 100 * 16.), (["RVE/Columns=12", "RVE/Rows=12"], 100 * 144.)]),
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
    wanted = sys.argv[2] if len(sys.argv) > 2 else ""
    for name, (scene, common, sizes) in KINDS.items():
        if wanted not in name:
            continue
        bytes_of, count = [], []
        for settings, known in sizes:
            peak, particles = run(program, scene, common + settings)
            bytes_of.append(peak)
            count.append(known or particles)
        print(f"{name:55s} {count[0]:9.0f} {count[1]:9.0f}  {(bytes_of[1] - bytes_of[0]) / (count[1] - count[0]):7.0f} bytes", flush=True)


if __name__ == "__main__":
    main()
