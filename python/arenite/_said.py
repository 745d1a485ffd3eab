"""Messages of the commands, and how their process ends."""

import json
import os
import re
import signal
import sys


def printable(text):
    """For a terminal: control characters as their pictures, so that names from other people's files cannot speak to
    it."""
    return re.sub(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]", lambda m: chr(0x2400 + ord(m[0])) if m[0] < " " else "\ufffd", text)


def tell(text, stream=None):
    """Prints a line."""
    print(printable(text), file=stream or sys.stdout)


def said(sentence):
    """Prints the reason of a failure as the program does; returns the exit status of bad input."""
    tell(f"arenite: {sentence}", sys.stderr)
    return 2


def carry_out(main):
    """Ends the process with the status of a command, whose options are one JSON object on the command line. Whoever
    closes the pipe of its output ends it, as it ends other programs; output that cannot be written is told."""
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    try:
        status = main(**json.loads(sys.argv[1]))
        sys.stdout.flush()
    except KeyboardInterrupt:
        status = 130
    except OSError as error:
        status = said(f"the output could not be written ({error.strerror or error}); make room or write elsewhere")
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # or the interpreter would try once more
    sys.exit(status)
