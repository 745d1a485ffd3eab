"""python3 -m arenite.figures RESULT [--out DIR] [--format pdf svg png] [--only NAME ...] [--width MM]"""

import argparse
import pathlib
import sys
import warnings

from .._said import said
from .catalogue import save_all
from .studies import not_drawn


def main():
    parser = argparse.ArgumentParser(prog="arenite figures", description="Journal figures of a result or a study: PDF, SVG or PNG in column width, fonts embedded.")
    parser.add_argument("result", help="folder of a run or a study, or a file of it")
    parser.add_argument("--out", help="folder to write to (default: figures in the result's folder)")
    parser.add_argument("--format", nargs="+", choices=["pdf", "svg", "png"], default=["pdf"])
    parser.add_argument("--only", nargs="+", metavar="NAME", help="names of figures; all if not given")
    parser.add_argument("--width", type=float, metavar="MM", help="width in millimetres (default: 85 for one column, 175 for two)")
    a = parser.parse_args()
    warnings.showwarning = lambda message, *_: print(message, file=sys.stderr)  # notices of former names, without a line of code
    result = pathlib.Path(a.result)
    out = a.out or (result if result.is_dir() else result.parent) / "figures"
    try:
        paths = save_all(result, out, a.format, a.only, a.width and a.width / 25.4)
    except ValueError as error:
        sys.exit(said(str(error)))
    except (ArithmeticError, AttributeError, LookupError, MemoryError, RuntimeError, TypeError) as error:  # numbers of another shape than this version's
        sys.exit(said(f"{a.result}: holds what these figures cannot draw ({type(error).__name__}: {error}); compute the result again with `arenite run`"))
    except OSError as error:
        sys.exit(said(f"{error.filename or out}: cannot be written ({error.strerror or error}); choose another folder with --out"))
    for path in paths:
        print(path)
    for name, sentence in not_drawn(result).items():
        if not a.only or name in a.only:
            print(f"{name}: {sentence}", file=sys.stderr)
    if not paths:
        sys.exit(said(f"{a.result}: holds nothing that these figures show"))


main()
