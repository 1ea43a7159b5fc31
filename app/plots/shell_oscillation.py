"""The picture of a shell_oscillation run: radius over time, and its spectrum with the closed form's lines."""
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, ALONG, INK, read_table, style  # noqa: E402


def main(directory):
    """Paths of the pictures made."""
    files = [os.path.join(directory, name + ".csv") for name in ("radius", "spectrum", "modes")]
    if not all(os.path.exists(file) for file in files):
        return []
    radius, spectrum, modes = [read_table(file) for file in files]
    figure = plt.figure(figsize=(11.0, 5.2), facecolor="white")
    axis = figure.add_axes([0.08, 0.13, 0.38, 0.80])
    t = radius["time [s]"] * 1e6
    periods = max(1.0, modes["closed_form [Hz]"][0] * radius["time [s]"][-1])
    shown = t <= t[-1] * min(1.0, 8 / periods)
    axis.plot(t[shown], radius["radial_speed [m/s]"][shown] * 1e3, color=ALONG, linewidth=1.2)
    axis.set_xlabel("time [µs]" + (" (the first eight periods)" if periods > 8.5 else ""), color=INK, fontsize=9)
    axis.set_ylabel("radial speed of wall and liquid [mm/s]", color=INK, fontsize=9)
    axis.axhline(0, color="#c8d0d6", linewidth=0.8)
    axis.set_xlim(0, t[shown][-1])
    style(axis)
    axis = figure.add_axes([0.56, 0.13, 0.41, 0.80])
    f = spectrum["frequency [Hz]"] / 1e6
    height = spectrum["amplitude [m/s]"] / spectrum["amplitude [m/s]"][8:].max()
    axis.semilogy(f, np.maximum(height, 1e-6), color=ALONG, linewidth=1.4, label="radial speed, Hann window")
    for k, line in enumerate(modes["found [Hz]"] / 1e6):
        axis.axvline(line, color=INK, linewidth=1.0, label="found by the harmonic fit" if k == 0 else None)
    for k, line in enumerate(modes["closed_form [Hz]"] / 1e6):
        axis.axvline(line, color=ACCENT, linewidth=1.0, linestyle=(0, (4, 3)), label="closed form" if k == 0 else None)
        deviation = modes["deviation [%]"][k]
        digits = 1 if abs(deviation) >= 0.1 else 3
        axis.text(line, 1.7, f" {deviation:+.{digits}f} %", color=ACCENT, fontsize=8, ha="left")
    axis.set_xlim(0, f[-1])
    axis.set_ylim(1e-4, 3)
    axis.set_xlabel("frequency [MHz]", color=INK, fontsize=9)
    axis.set_ylabel("amplitude over the largest", color=INK, fontsize=9)
    axis.legend(frameon=False, fontsize=9, loc="upper right", bbox_to_anchor=(1.0, 0.98))
    style(axis)
    figure.text(0.5, 1.0, "A filled shell that rings: radial speed over time, and its spectrum", fontsize=11, color=INK, ha="center", va="bottom")
    path = os.path.join(directory, "shell_oscillation.png")
    figure.savefig(path, dpi=150, bbox_inches="tight", pad_inches=0.08)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
