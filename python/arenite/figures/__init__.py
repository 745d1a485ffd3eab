"""Journal figures from stored results: `save_all(result, folder)`, or `python3 -m arenite.figures RESULT`.

Each file of this package draws one subject on axes that it is given (`draw_*(axes, data)`), so that your own figure needs
one call; `catalogue.figures` lists the figures that `save_all` draws of a result. Text is in DejaVu Sans, which comes with
Matplotlib, or in the fonts of your rcParams; it is embedded in PDF and kept as text in SVG.
"""

from .catalogue import figures, figures_of, save_all, study_figures
from .densities import draw_cavities, draw_densities
from .failure import draw_broken_bonds, draw_convergence, draw_energy_balance, draw_stress_strain
from .fields import draw_cracks, draw_field, draw_phases
from .film_forces import draw_against_simulation, draw_certainty, draw_ranked_forces, draw_ranked_stresses
from .films import draw_bad_pixels, draw_film_grains, draw_map, draw_phase, draw_simulated_grains
from .histories import draw_energies, draw_equilibrium, draw_travel, draw_wall_forces
from .loadings import draw_against_rate, draw_cycles, draw_friction, draw_pressure, draw_volume
from .packings import draw_forces, draw_packing
from .parts import State
from .samples import draw_coarse_field, draw_grains_against, draw_size_curve
from .saving import Figure, save
from .studies import (
    draw_study_figure,
    draw_study_map,
    draw_study_nodes,
    draw_study_plot,
    draw_study_rose,
    draw_study_sample,
    study_document,
)
from .style import column_width, journal_style, page_width
from .textures import (
    draw_contact_numbers,
    draw_coordination,
    draw_cumulative,
    draw_cumulative_sets,
    draw_density,
    draw_rev,
    draw_rose,
    draw_stress_path,
    draw_threshold,
)

__all__ = [name for name in dir() if name.startswith("draw_")] + [
    "Figure",
    "State",
    "column_width",
    "figures",
    "figures_of",
    "journal_style",
    "page_width",
    "save",
    "save_all",
    "study_document",
    "study_figures",
]

# Former names.
draw_course = draw_stress_path
draw_rest = draw_equilibrium
