#!/usr/bin/python3
"""Runs every scene of `turgor list`, sized down, for some seconds of CPU; it must end by itself or stop when it is asked to.
What a sanitizer reports counts as a failure, which is what this is for:

    /usr/bin/python3 tests/every_scene.py --program build-sanitize/app/turgor [--time 2] [SCENE...]

The last line is "N passed, N failed".
"""
import argparse
import concurrent.futures
import os
import random
import sys
import time

SOURCE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(SOURCE, "inputs", "studies"))
import fuzz  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=os.path.join(SOURCE, "build", "app", "turgor"))
    parser.add_argument("--time", type=float, default=2.0, help="CPU seconds before a scene is asked to stop")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("scenes", nargs="*", metavar="SCENE")
    options = parser.parse_args()
    program = os.path.abspath(options.program)

    def one(scene):
        start = time.time()
        settings = fuzz.draw(random.Random(1), scene, fuzz.entries_of(program, scene), sizes_only=True)
        return (scene,) + fuzz.run_scene(program, scene, settings, options.time) + (settings, time.time() - start)

    failed = 0
    scenes = options.scenes or fuzz.listed(program)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for scene, verdict, sentence, settings, seconds in pool.map(one, scenes):
            print(f"{scene}: {verdict} ({seconds:.1f} s)", flush=True)
            if verdict not in ("ok", "long"):
                failed += 1
                print(sentence + "\n" + " ".join(f"--set '{name}={value}'" for name, value in settings.items()), flush=True)
    print(f"{len(scenes) - failed} passed, {failed} failed")
    return 1 if failed or not scenes else 0


if __name__ == "__main__":
    sys.exit(main())
