"""The picture of a cell_impact run: cell_impact.png."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from squeezed import pictures  # noqa: E402


def main(directory):
    """Paths of the pictures made."""
    return pictures(directory, "cell_impact", "A plate comes down on a cell")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
