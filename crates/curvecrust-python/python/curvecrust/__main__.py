"""`python -m curvecrust` is the program `curvecrust`."""

import sys

from ._curvecrust import run

if __name__ == "__main__":
    again = [sys.executable, "-m", "curvecrust"] if sys.executable else []
    sys.exit(run(["curvecrust", *sys.argv[1:]], again))
