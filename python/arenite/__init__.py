"""Micromechanics of composite and cemented granular materials.

Every stage of the four roads as a function (`pack`, `load_stage`, `cement`, `rasterise`, `load`, `measure`, `lock_in`,
`find_grains`, `infer_forces`, `film`, ...), results as NumPy arrays that look into the library's own memory. Numbers are in
SI units; stresses are positive in tension, contact forces in compression. Bad input raises ValueError with the sentence
that the program prints. `arenite.figures` draws.
"""

from . import _core, _html
from ._core import *  # noqa: F401,F403
from ._core import __version__
from .studies import run_study

__all__ = [name for name in vars(_core) if not name.startswith("_")] + ["__version__", "run_study"]

for _class, _draw in _html.pictures.items():
    getattr(_core, _class)._repr_html_ = _draw
