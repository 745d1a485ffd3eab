"""Implements `arenite figures`. Its options are declared by the program and are passed as one JSON object."""

import json
import pathlib
import sys
import warnings

from .._said import said
from .catalogue import save_all
from .studies import not_drawn


def main(result, formats=("pdf",), out=None, only=None, width=None):
    """`width`, m."""
    warnings.showwarning = lambda message, *_: print(message, file=sys.stderr)  # notices of former names, without a line of code
    given, result = result, pathlib.Path(result)
    out = out or (result if result.is_dir() else result.parent) / "figures"
    try:
        paths = save_all(result, out, formats, only, width and width / 0.0254)
    except ValueError as error:
        sys.exit(said(str(error)))
    except (ArithmeticError, AttributeError, LookupError, MemoryError, RuntimeError, TypeError) as error:  # numbers of another shape than this version's
        sys.exit(said(f"{given}: cannot be drawn ({type(error).__name__}: {error}); compute the result again with `arenite run`"))
    except OSError as error:
        sys.exit(said(f"{error.filename or out}: cannot be written ({error.strerror or error}); choose another folder with --out"))
    for path in paths:
        print(path)
    for name, sentence in not_drawn(result).items():
        if not only or name in only:
            print(f"{name}: {sentence}", file=sys.stderr)
    if not paths:
        sys.exit(said(f"{given}: holds nothing to draw"))


main(**json.loads(sys.argv[1]))
