"""`python -m curvecrust` is the program `curvecrust`."""

import sys

from ._curvecrust import run

if __name__ == "__main__":
    sys.exit(run(["curvecrust", *sys.argv[1:]]))
