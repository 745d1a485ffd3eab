"""The figures of a result; a new one is one more row."""

import pathlib
import warnings

from .. import _core
from .._core import open as open_result
from . import bonds, fields, films, packings, panels, runs, samples, studies, volumes
from .described import all_described
from .parts import parts_of, same_map
from .saving import Canvas, Figure, listed, save
from .style import sigma_norm


def one(draw, data, **options):
    """One drawing on the whole figure."""
    return lambda figure, part: draw(figure.add_subplot(), data(part), **options)


def with_bar(draw, data, label, **options):
    """The same with a colour bar."""

    def drawn(figure, part):
        axes = figure.add_subplot()
        figure.colorbar(draw(axes, data(part), **options), ax=axes, label=label, shrink=0.8, extend="max")

    return drawn


def of_components(*names):
    return lambda figure, field: panels.components(figure, field, names)


def force_network(figure, state):
    packings.draw_forces(figure.add_subplot(), state.packing, state.mean_force)


def film_network(figure, film):
    packings.draw_forces(figure.add_subplot(), film.packing, _core._force_scale(film)[0], films.uncertain(film))


def has_contacts(state):
    return len(state.packing.contacts) > 10


def has_cracks(field):
    return len(field.curve.get("strain", [])) > 1


def has_forces(film):
    return len(film.fn_error) > 0


def has_simulation(film):
    return len(film.simulation) > 0


def of_packing(part):
    return packings.height_of(part.packing)


def of_field(part):
    return fields.height_of(part)


def of_components_height(rows):
    return lambda field: rows * 0.25 * field.map.height / field.map.width + 0.02


# Pictures of the page's cards have renderers of their own.
stage_pictures = {
    "grain-scatter": Figure("grain-scatter", "stage", samples.grain_scatter, samples.scatter_of),
    "coarse-fields": Figure(
        "coarse-fields", "stage", samples.coarse_fields, samples.has_box, samples.fields_height, True
    ),
}
sphere_pictures = {
    "grain-scatter": Figure("grain-scatter", "spheres", samples.grain_scatter, samples.scatter_of),
    "coarse-fields": Figure(
        "coarse-fields", "spheres", samples.coarse_slices, samples.are_in_a_box, samples.slices_height, True
    ),
}
film_pictures = {
    "film-maps": Figure("beside-simulation", "film", panels.beside, has_simulation, 0.38, True),
    "film-fit": Figure("film-fit", "film", films.draw_fit, lambda f: has_forces(f) and f.fitted.size > 0, 0.4, True),
}

figures = [
    Figure("packing", "stage", one(packings.draw_packing, lambda s: s.packing), height=of_packing),
    Figure(
        "sigma-norm-map",
        "stage",
        with_bar(packings.draw_packing, lambda s: s.packing, sigma_norm, by="sigma_norm"),
        has_contacts,
        lambda s: 0.85 * of_packing(s),
    ),
    Figure("force-network", "stage", force_network, has_contacts, of_packing),
    *all_described("stage", stage_pictures),
    Figure(
        "cracks",
        "stage",
        one(bonds.draw_cracks, lambda s: s.packing),
        lambda s: bonds.has_broken(s.history),
        of_packing,
    ),
    Figure("phases", "field", one(fields.draw_phases, lambda f: f), height=of_field, of_map=True),
    Figure(
        "stress",
        "field",
        of_components("sigma_yy", "sigma_xx", "sigma_xy", "sigma_hyd", "sigma_1", "sigma_2"),
        lambda f: f.loaded,
        of_components_height(2),
        True,
    ),
    Figure("displacement", "field", of_components("ux", "uy", "u"), lambda f: f.loaded, of_components_height(1), True),
    *all_described("field", {}),
    Figure("cracks", "field", one(fields.draw_cracks, lambda f: f), has_cracks, of_field),
    Figure("maps", "film", panels.film_maps, height=0.46, wide=True),
    Figure(
        "grains", "film", with_bar(films.draw_film_grains, lambda f: f, sigma_norm), lambda f: len(f.sigma_hyd) > 0, 0.9
    ),
    *all_described("film", film_pictures),
    Figure("force-network", "film", film_network, has_forces, of_packing),
    Figure("phases", "voxels", volumes.draw_phases, height=volumes.height_of_rows(1, 0.06), wide=True, of_map=True),
    Figure("stress", "voxels", volumes.of_stress, volumes.is_loaded, volumes.height_of_rows(volumes.stresses), True),
    Figure("displacement", "voxels", volumes.of_displacement, volumes.is_loaded, volumes.height_of_rows(1), True),
    *all_described("voxels", {}),
    *all_described("spheres", sphere_pictures),
]


former_names = {"course": "stress-path", "contact-directions": "contact-orientations", "rest": "equilibrium"}


def figures_of(result, stage=None, state=None):
    """(figure, part) of everything that can be drawn of a result: every field, film and sample in space, and the last
    state of its stages. `stage`: only this stage, load or film, by name; `state`: the stored state of this number,
    counted as in the figure `stress-path`.
    """
    parts, found = list(parts_of(result, stage, state)), []
    for k, (kind, part) in enumerate(parts):
        again = kind in ("field", "voxels") and any(
            before == kind and same_map(other.map, part.map) for before, other in parts[:k]
        )
        found += [
            (figure, part)
            for figure in figures
            if figure.kind == kind and not (figure.of_map and again) and figure.when(part)
        ]
    return found


def study_figures(path):
    """(figure, part) of everything on the page of a study that can be drawn so far, and those over the runs of studies
    that are strained at a rate, discharge, collapse, fill a silo or reach the critical state, with or without a
    page."""
    over_runs = list(runs.over_runs(path))
    parts = studies.study_document(path)["figures"] if studies.has_page(path) or not over_runs else []
    on_page = {part["id"] for part in parts}
    found = [
        (
            Figure(
                part["id"],
                "study",
                studies.draw_study_figure,
                height=studies.height_of(part),
                wide=part.get("wide", False),
                head=part,
            ),
            part,
        )
        for part in parts
        if studies.has_content(part)
    ]
    return found + [(figure, drawings) for figure, drawings in over_runs if figure.name not in on_page]


def save_all(result, folder, formats=("pdf",), names=None, width=None, stage=None, state=None):
    """Saves every figure of a result or a study (a Result or its path) in a folder; returns the paths. `stage` and
    `state` as in `figures_of`; the width in inches."""
    is_path = isinstance(result, (str, pathlib.Path))
    of_study = is_path and studies.is_study(result)
    found = (
        study_figures(result) if of_study else figures_of(open_result(str(result)) if is_path else result, stage, state)
    )
    there = [figure.name for figure, _ in found]
    names = None if names is None else [name if name in there else name_now(name) for name in listed(names)]
    refuse_unknown(names or [], there)
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    for figure, part in found:
        if names and figure.name not in names:
            continue
        stem = figure.name if of_study else f"{part.name.replace(' ', '-')}-{figure.name}"
        new = [folder / f"{stem}.{form}" for form in listed(formats)]
        save(figure, part, new, width)
        paths += new
    return paths


# The library says of each what its key says, to a line.
save_all.__doc__ += "\n\n" + "\n".join(f"`{name}`: {words}" for name, words in _core._print_words.items())


def name_now(name):
    if name in former_names:
        warnings.warn(
            f"the figure {name} is now called {former_names[name]}; the former name is still read",
            FutureWarning,
            stacklevel=3,
        )
    return former_names.get(name, name)


def refuse_unknown(names, there):
    missing, there = [name for name in names if name not in there], list(dict.fromkeys(there))
    if not missing:
        return
    elsewhere = [name for name in missing if name in {figure.name for figure in figures}]
    what = (
        f"this result has no figure {', '.join(elsewhere)}"
        if elsewhere == missing
        else f"there is no figure {', '.join(missing)}"
    )
    raise ValueError(f"{what}; there are {', '.join(there)}" if there else f"{what}, nor any other")
