"""Journal figures from stored results: `save_all(result, folder)`, or `python3 -m arenite.figures RESULT`.

What a figure shows is described by the library, for the page and for print: `describe(part)` gives it by the figures'
ids, and `draw_panel`, `draw_rose`, `draw_outlines`, `draw_cells` and `draw_described` draw it, on axes of your own if
you like. Pictures of grains, maps and fields are drawn by functions of their own (`draw_*(axes, data)`);
`catalogue.figures` lists all figures that `save_all` draws of a result. Text is in DejaVu Sans, which comes with
Matplotlib, or in the fonts of your rcParams; it is embedded in PDF and kept as text in SVG.
"""

from .catalogue import figures, figures_of, save_all, study_figures
from .drawing import describe, draw_cells, draw_described, draw_panel
from .fields import draw_cracks, draw_field, draw_phases
from .films import draw_bad_pixels, draw_film_grains, draw_map, draw_phase, draw_simulated_grains
from .packings import draw_forces, draw_packing
from .parts import State
from .polar import draw_outlines, draw_rose
from .runs import draw_runs
from .samples import draw_coarse_field, draw_grains_against
from .saving import Figure, save
from .studies import draw_study_figure, draw_study_nodes, draw_study_sample, study_document
from .style import column_width, journal_style, page_width

__all__ = [name for name in dir() if name.startswith("draw_")] + [
    "Figure",
    "State",
    "column_width",
    "describe",
    "figures",
    "figures_of",
    "journal_style",
    "page_width",
    "save",
    "save_all",
    "study_document",
    "study_figures",
]
