"""The figures of a result; a new one is one more row."""

import pathlib
import warnings

from .._core import open as open_result
from . import (
    bonds,
    densities,
    failure,
    fields,
    film_forces,
    films,
    flows,
    histories,
    loadings,
    packings,
    panels,
    samples,
    studies,
    textures,
)
from .parts import parts_of, same_map
from .saving import Canvas, Figure, listed, save
from .style import sigma_norm


def one(draw, data, **options):
    """One drawing on the whole figure."""
    return lambda figure, part: draw(figure.add_subplot(), data(part), **options)


def of_history(draw):
    """A drawing of the history of a stage."""
    return lambda figure, state: draw(figure.add_subplot(), state.history, units=state.stage.history_units)


def of_curve(draw):
    """A drawing of a test to failure."""
    return lambda figure, field: draw(figure.add_subplot(), field.curve, units=field.curve_units)


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
    packings.draw_forces(figure.add_subplot(), film.packing, uncertain=film_forces.uncertain(film))


def materials(state):
    return panels.names_of(state.packing)


def coordination(figure, state):
    textures.draw_coordination(figure.add_subplot(), state.texture["coordination"], materials(state))


def travel(figure, state):
    histories.draw_travel(figure.add_subplot(), state.history, state.stage.snapshots, state.stage.history_units)


def has_contacts(state):
    return len(state.packing.contacts) > 10


def has(*path):
    """Whether the texture of a state with contacts holds this."""

    def found(state):
        about = state.texture if has_contacts(state) else {}
        for name in path:
            about = about.get(name, {})
        return len(about) > 0

    return found


def has_time(*columns):
    return lambda state: len(state.history.get("time", [])) > 1 and any(c in state.history for c in columns)


def has_curve(field):
    return len(field.curve.get("strain", [])) > 1


def has_forces(film):
    return len(film.fn_error) > 0


def has_simulation(film):
    return len(film.simulation) > 0


def density_figure(component, name):
    return Figure(
        name,
        "field",
        lambda figure, field: panels.density_panels(figure, field, component),
        lambda f: f.loaded and bool(panels.density_rows(f, component)),
        lambda f: 0.4 * len(panels.density_rows(f, component)),
        True,
    )


def of_packing(part):
    return packings.height_of(part.packing)


def of_field(part):
    return fields.height_of(part)


def of_components_height(rows):
    return lambda field: rows * 0.25 * field.map.height / field.map.width + 0.02


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
    Figure("contact-orientations", "stage", panels.roses, has("fabric", "sectors"), panels.roses_height, True),
    Figure("sigma-norm", "stage", panels.sigma_norm_tails, has("sigma_norm", "cumulative"), 0.45, True),
    Figure("forces", "stage", panels.forces, has("force", "pdf"), 0.46, True),
    Figure("grain-scatter", "stage", samples.grain_scatter, has_contacts),
    Figure("size-curve", "stage", samples.size_curves, lambda s: samples.asked_sizes(s) is not None),
    Figure("coarse-fields", "stage", samples.coarse_fields, samples.has_box, samples.fields_height, True),
    Figure("coordination", "stage", coordination, has("coordination", "all")),
    Figure(
        "contact-numbers",
        "stage",
        one(textures.draw_contact_numbers, lambda s: s.texture["coordination"]),
        has("coordination", "histogram"),
    ),
    Figure("rev", "stage", one(textures.draw_rev, lambda s: s.texture), has("rev")),
    Figure(
        "threshold",
        "stage",
        one(textures.draw_threshold, lambda s: s.texture["fabric"]["threshold"]),
        has("fabric", "threshold"),
    ),
    Figure(
        "stress-path",
        "stage",
        panels.stress_path,
        lambda s: sum(len(snapshot.packing.contacts) > 10 for snapshot in s.snapshots) > 2,
        0.4,
        True,
    ),
    Figure(
        "wall-forces",
        "stage",
        of_history(histories.draw_wall_forces),
        has_time(*(f"{side}_force" for side in histories.sides)),
    ),
    Figure("travel", "stage", travel, lambda s: histories.moving_wall(s.history) is not None),
    Figure("energies", "stage", of_history(histories.draw_energies), has_time("elastic")),
    Figure("stress-strain", "stage", loadings.stress_strain, loadings.has_test, 1.1),
    Figure("cycles", "stage", loadings.cycles, loadings.has_cycles),
    Figure("broken-bonds", "stage", of_history(bonds.draw_broken_bonds), lambda s: bonds.has_broken(s.history)),
    Figure(
        "cracks",
        "stage",
        one(bonds.draw_cracks, lambda s: s.packing),
        lambda s: bonds.has_broken(s.history),
        of_packing,
    ),
    Figure("discharge", "stage", one(histories.draw_discharge, lambda s: s.history), has_time("passed_mass")),
    Figure("equilibrium", "stage", one(histories.draw_equilibrium, lambda s: s.history), has_time("unbalanced_ratio")),
    Figure("phases", "field", one(fields.draw_phases, lambda f: f), height=of_field, of_map=True),
    Figure(
        "cavities",
        "field",
        one(densities.draw_cavities, lambda f: f.numbers),
        lambda f: densities.has_cavities(f.numbers),
        of_map=True,
    ),
    Figure(
        "stress",
        "field",
        of_components("sigma_yy", "sigma_xx", "sigma_xy", "sigma_hyd", "sigma_1", "sigma_2"),
        lambda f: f.loaded,
        of_components_height(2),
        True,
    ),
    Figure("displacement", "field", of_components("ux", "uy", "u"), lambda f: f.loaded, of_components_height(1), True),
    density_figure("sigma_yy", "stress-pdf"),
    density_figure("sigma_xx", "stress-pdf-xx"),
    density_figure("sigma_xy", "stress-pdf-xy"),
    density_figure("sigma_hyd", "stress-pdf-hyd"),
    Figure(
        "convergence",
        "field",
        one(failure.draw_convergence, lambda f: f.convergence),
        lambda f: len(f.convergence.get("residual", [])) > 1,
    ),
    Figure("stress-strain", "field", of_curve(failure.draw_stress_strain), has_curve),
    Figure("cracks", "field", one(fields.draw_cracks, lambda f: f), has_curve, of_field),
    Figure(
        "broken-bonds",
        "field",
        one(failure.draw_broken_bonds, lambda f: f),
        lambda f: has_curve(f) and len(f.cracks["type"]) > 0,
    ),
    Figure("energy-balance", "field", of_curve(failure.draw_energy_balance), has_curve),
    Figure("maps", "film", panels.film_maps, height=0.46, wide=True),
    Figure("film-fit", "film", films.draw_fit, lambda f: has_forces(f) and f.fitted.size > 0, 0.4, True),
    Figure(
        "grains", "film", with_bar(films.draw_film_grains, lambda f: f, sigma_norm), lambda f: len(f.sigma_hyd) > 0, 0.9
    ),
    Figure("stresses", "film", one(film_forces.draw_ranked_stresses, lambda f: f), lambda f: len(f.sigma_hyd) > 0),
    Figure("forces", "film", panels.ranked_forces, has_forces, 0.4, True),
    Figure("certainty", "film", one(film_forces.draw_certainty, lambda f: f), has_forces),
    Figure("force-network", "film", film_network, has_forces, of_packing),
    Figure("beside-simulation", "film", panels.beside, has_simulation, 0.38, True),
    Figure("against-simulation", "film", panels.against, has_simulation, 0.48, True),
    Figure("tails", "film", panels.film_tails, lambda f: len(f.sigma_hyd) > 1),
    Figure(
        "contact-orientations",
        "film",
        panels.film_roses,
        lambda f: "film" in f.numbers.get("contact_orientations", {}),
        lambda f: 0.68 if len(panels.film_rose_sets(f)) > 1 else 1.1,
    ),
]


former_names = {"course": "stress-path", "contact-directions": "contact-orientations", "rest": "equilibrium"}


def figures_of(result, stage=None, state=None):
    """(figure, part) of everything that can be drawn of a result: every field and film, and the last state of its stages. `stage`: only
    this stage, load or film, by name; `state`: the stored state of this number, counted as in the figure `stress-path`.
    """
    parts, found = list(parts_of(result, stage, state)), []
    for k, (kind, part) in enumerate(parts):
        again = kind == "field" and any(
            before == "field" and same_map(other.map, part.map) for before, other in parts[:k]
        )
        found += [
            (figure, part)
            for figure in figures
            if figure.kind == kind and not (figure.of_map and again) and figure.when(part)
        ]
    return found


def study_figures(path):
    """(figure, part) of everything on the page of a study that can be drawn so far, `rheology` if its runs are strained at a rate, and the
    figures of `flows` for discharges, collapses, silos and critical states, with or without a page."""
    runs, flow = loadings.driven_runs(path), flows.kind_of(path)
    parts = studies.study_document(path)["figures"] if studies.has_page(path) or not (runs or flow) else []
    found = [
        (Figure(part["id"], "study", studies.draw_study_figure, height=studies.height_of(part)), part)
        for part in parts
        if studies.has_content(part)
    ]
    if flow:
        found.append(
            (
                Figure(
                    flow,
                    "study",
                    flows.drawings[flow],
                    height=0.42 if flow == "critical-state" else 0.7,
                    wide=flow == "critical-state",
                ),
                path,
            )
        )
    return found + [(Figure("rheology", "study", loadings.rheology, height=0.42, wide=True), runs)] * bool(
        runs and flow in (None, "critical-state")
    )


def save_all(result, folder, formats=("pdf",), names=None, width=None, stage=None, state=None):
    """Saves every figure of a result or a study (a Result or its path) in a folder; returns the paths. `formats`: pdf, svg, png;
    `names`: only these figures; `stage` and `state` as in `figures_of`."""
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
