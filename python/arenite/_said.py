"""What a command says of its own accord."""

import sys


def said(sentence):
    """Tells why nothing came of it, as the program does; gives the exit status of bad input."""
    print(f"arenite: {sentence}", file=sys.stderr)
    return 2
