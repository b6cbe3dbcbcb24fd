"""The program ``assur``, also as ``python -m assur``."""

from __future__ import annotations

import signal
import sys

from . import _assur


def main() -> int:
    """Runs the program with the arguments of the command line; gives its exit status."""
    # the program handles signals itself
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _assur.program(["assur", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
