"""Implements `arenite figures`. Its options are declared by the program and are passed as one JSON object."""

import pathlib
import sys
import warnings

from .._said import carry_out, said, tell
from .catalogue import save_all
from .studies import not_drawn


def main(result, formats=("pdf",), out=None, only=None, width=None):
    """`width`, m."""
    warnings.showwarning = lambda message, *_: tell(
        f"{message}", sys.stderr
    )  # notices of former names, without a line of code
    given, result = result, pathlib.Path(result)
    out = out or (result if result.is_dir() else result.parent) / "figures"
    try:
        paths = save_all(result, out, formats, only, width and width / 0.0254)
    except ValueError as error:
        return said(str(error))
    except (
        ArithmeticError,
        AttributeError,
        LookupError,
        MemoryError,
        RuntimeError,
        TypeError,
    ) as error:  # numbers of another shape than this version's
        return said(
            f"{given}: cannot be drawn ({type(error).__name__}: {error}); compute the result again with `arenite run`, "
            "and report this if it comes again"
        )
    except OSError as error:
        return said(
            f"{error.filename or out}: cannot be written ({error.strerror or error}); choose another folder with --out"
        )
    for path in paths:
        tell(f"{path}")
    for name, sentence in not_drawn(result).items():
        if not only or name in only:
            tell(f"{name}: {sentence}", sys.stderr)
    return 0 if paths else said(f"{given}: holds nothing to draw")


carry_out(main)
