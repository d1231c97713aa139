"""matplotlib without a screen, or one line that says how to get it."""

import sys

try:
    import matplotlib
except ModuleNotFoundError:
    sys.exit("plots need matplotlib, which " + sys.executable + " does not have: on Debian, `apt install python3-matplotlib` "
             "and run the script by its name or with /usr/bin/python3")

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402, F401 (for those who import it from here)


def save(figure, path, dpi=150):
    """Writes a figure as .png, and beside it as .svg and .pdf, which have no pixels."""
    for ending in (".png", ".svg", ".pdf"):
        figure.savefig(path.with_suffix(ending), dpi=dpi)
