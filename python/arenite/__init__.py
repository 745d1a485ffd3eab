"""Micromechanics of composite and cemented granular materials.

Every stage of the four workflows is a function (`pack`, `load_stage`, `cement`, `rasterise`, `load`, `measure`,
`lock_in`, `find_grains`, `infer_forces`, `film`, ...), results are NumPy arrays that refer to the library's own memory.
Numbers are in SI units; stresses are positive in tension, contact forces in compression. Bad input raises ValueError
with the message that the program prints. `arenite.figures` draws.
"""

import importlib.util as _importlib_util
import sys as _sys

if not _importlib_util.find_spec(__name__ + "._core"):
    raise ImportError(
        "arenite: the compiled module _core is not built for this Python; `make build` in the source folder builds it "
        "(`make demo` does not) "
        "for /usr/bin/python3"
    )

from . import _core, _html
from ._core import *  # noqa: F401,F403
from ._core import __version__
from .studies import run_study

__all__ = [name for name in vars(_core) if not name.startswith("_")] + ["__version__", "run_study"]

for _class, _draw in _html.pictures.items():
    getattr(_core, _class)._repr_html_ = _draw

# As a program (`python3 -m arenite.figures`) figures must say in a sentence what they lack; their package cannot, since
# it is imported before its __main__. Python's argv[0] is "-m" as long as it looks for the module.
if (
    _sys.argv[:1] == ["-m"]
    and "arenite.figures" in getattr(_sys, "orig_argv", [])
    and not _importlib_util.find_spec("matplotlib")
):
    print(
        "arenite: figures need Matplotlib, which is not installed (Debian: apt-get install python3-matplotlib)",
        file=_sys.stderr,
    )
    _sys.exit(2)
