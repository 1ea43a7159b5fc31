"""The picture of a tissue_compression run: see aggregate.py."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from aggregate import pictures  # noqa: E402


def main(directory):
    """Paths of the pictures made."""
    return pictures(directory, "tissue_compression")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
