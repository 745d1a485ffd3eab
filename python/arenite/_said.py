"""Messages of the commands."""

import sys


def said(sentence):
    """Prints the reason of a failure as the program does; returns the exit status of bad input."""
    print(f"arenite: {sentence}", file=sys.stderr)
    return 2
