"""The picture of a cell_compression run: cell_compression.png."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from squeezed import pictures  # noqa: E402


def main(directory):
    """Paths of the pictures made."""
    return pictures(directory, "cell_compression", "A cell squeezed between two plates")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
