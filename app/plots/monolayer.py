"""Pictures of a monolayer run: see cells_cut.py."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import cells_cut  # noqa: E402


def main(directory):
    return cells_cut.main(directory, flat=True)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
