"""The figures that are made of a result; a new one is one more row."""

import dataclasses
import logging
import pathlib
import typing

import numpy as np
from matplotlib.figure import Figure as Canvas

from .._core import cavities as cavity_nodes, measure, open as open_result
from . import fields, films, histories, packings, studies, textures
from .style import column_width, journal_style, page_width


@dataclasses.dataclass
class Figure:
    """`draw(figure, part)` on an empty matplotlib figure; `part` is a Stage, Field or FilmResult, and `when(part)` says whether it can."""

    name: str
    kind: str
    draw: typing.Callable
    when: typing.Callable = lambda part: True
    height: float = 0.8  # over the width
    wide: bool = False


def one(draw, data, **options):
    """One drawing on the whole figure."""
    return lambda figure, part: draw(figure.add_subplot(), data(part), **options)


def with_bar(draw, data, label, **options):
    """The same with a colour bar."""
    def drawn(figure, part):
        axes = figure.add_subplot()
        figure.colorbar(draw(axes, data(part), **options), ax=axes, label=label, shrink=0.8, extend="max")
    return drawn


def texture(part):
    """Texture of a stage's last state, with its curves; measured once a part."""
    if id(part) not in _textures:
        _textures.clear()
        _textures[id(part)] = (part, measure(part.packing))
    return _textures[id(part)][1]


_textures = {}


def roses(figure, part):
    """All contacts, strong ones and each type."""
    fabric = texture(part)["fabric"]
    sets = [("all", fabric), *[(n, s) for n, s in fabric["sets"].items() if "sectors" in s and not n.endswith(("strong", "weak")) or n == "strong"]][:6]
    for k, (name, of) in enumerate(sets):
        axes = figure.add_subplot(1, len(sets), k + 1, projection="polar")
        textures.draw_rose(axes, of["sectors"], of)
        axes.set_title(f"{name} ({of['contacts']})")
        axes.set_xticklabels([])


def course(figure, part):
    states = [measure(frame.packing, curves=False) for frame in part.frames]
    for k, of in enumerate(["coordination", "anisotropy"]):
        textures.draw_course(figure.add_subplot(1, 2, k + 1), states, of)


def fields_side_by_side(figure, part):
    for k, component in enumerate(["sigma_yy", "sigma_xx", "sigma_xy"]):
        axes = figure.add_subplot(1, 3, k + 1)
        shown = fields.draw_field(axes, part, component)
        figure.colorbar(shown, ax=axes, shrink=0.7, extend="both", label=f"$\\{component.split('_')[0]}_{{{component.split('_')[1]}}}$ over its mean")


def densities(figure, part):
    statistics = part.statistics()
    for k, own in enumerate([False, True]):
        fields.draw_densities(figure.add_subplot(1, 2, k + 1), statistics, own=own)


def cavities(figure, part):
    axes = figure.add_subplot()
    for kind in ["pore", "void"]:
        nodes = cavity_nodes(part.map, kind)
        if len(nodes) > 10:
            fields.draw_cavities(axes, nodes / mean_grain_nodes(part.map), kind + "s")


def mean_grain_nodes(map):
    """Mean area of a grain (of the large ones, where there are classes), nodes."""
    size = np.bincount(map.grain[map.grain >= 0].ravel(), minlength=len(map.grain_class))
    large = np.asarray(map.grain_class) == 2
    return size[large].mean() if large.any() else size[size > 0].mean()


def film_maps(figure, part):
    maps = [("mean, K", part.picture), ("amplitude, mK", 1e3 * part.maps.amplitude), ("signed swing, mK", 1e3 * part.maps.in_phase),
                                         ("phase, rad", part.maps.phase), ("noise floor, mK", 1e3 * part.maps.noise_floor), ("residual, mK", 1e3 * part.maps.residual)]
    for k, (label, values) in enumerate([(label, values) for label, values in maps if values.size]):
        films.draw_map(figure.add_subplot(2, 3, k + 1), values, label)


def beside(figure, part):
    for k, (title, draw) in enumerate([("film", films.draw_film_grains), ("simulation, swing", films.draw_twin_grains)]):
        axes = figure.add_subplot(1, 2, k + 1)
        shown = draw(axes, part)
        axes.set_title(title)
    figure.colorbar(shown, ax=figure.axes, label=r"$\sigma_{norm}$", shrink=0.7, extend="max")


def film_tails(figure, part):
    """Film, and the swing and the state of the simulation beside it."""
    sets = [("film", part.sigma_hyd), *[(f"simulation, {name}", part.twin[name]) for name in ("swing", "state") if name in part.twin]]
    textures.draw_cumulative_sets(figure.add_subplot(), [(name, measure(part.packing, sigma_hyd=sigma).get("sigma_norm", {})) for name, sigma in sets])


def film_roses(figure, part):
    """Contacts whose force swings in the film, and those of the simulation beside it at the largest load, on one scale."""
    sets = [(name, part.numbers["directions"][key]) for key, name in [("film", "film"), ("twin", "simulation")] if key in part.numbers["directions"]]
    reach = max(max(of["sectors"]) * len(of["sectors"]) / of["contacts"] for _, of in sets)
    for k, (name, of) in enumerate(sets):
        axes = figure.add_subplot(1, len(sets), k + 1, projection="polar")
        textures.draw_rose(axes, of["sectors"], of)
        axes.set(xticks=np.radians([0, 90, 180, 270]), ylim=(0, 1.05 * reach))
        axes.set_title(f"{name} ({of['contacts']})")


def has_contacts(part):
    return len(part.frames) > 0 and len(part.packing.contacts) > 10


def has_time(*columns):
    return lambda part: len(part.history.get("time", [])) > 2 and any(c in part.history for c in columns)


def has_curve(part):
    return len(part.curve.get("strain", [])) > 1


figures = [
    Figure("packing", "stage", one(packings.draw_packing, lambda s: s.packing), lambda s: len(s.frames) > 0, 1.0),
    Figure("sigma-norm-map", "stage", with_bar(packings.draw_packing, lambda s: s.packing, r"$\sigma_{norm}$", by="sigma_norm"), has_contacts, 0.9),
    Figure("force-network", "stage", one(packings.draw_forces, lambda s: s.packing), has_contacts, 1.0),
    Figure("contact-directions", "stage", roses, has_contacts, 0.28, True),
    Figure("sigma-norm", "stage", one(textures.draw_cumulative, lambda s: texture(s)["sigma_norm"]), lambda s: has_contacts(s) and "cumulative" in texture(s).get("sigma_norm", {})),
    Figure("forces", "stage", one(textures.draw_density, lambda s: texture(s)["force"]), lambda s: has_contacts(s) and "pdf" in texture(s).get("force", {})),
    Figure("forces-cumulative", "stage", one(textures.draw_cumulative, lambda s: texture(s)["force"], label=r"$F_n/\langle F_n\rangle$", share="strong_share"),
           lambda s: has_contacts(s) and "cumulative" in texture(s).get("force", {})),
    Figure("coordination", "stage", one(textures.draw_coordination, lambda s: texture(s)["coordination"]), has_contacts),
    Figure("contact-numbers", "stage", one(textures.draw_contact_numbers, lambda s: texture(s)["coordination"]), has_contacts),
    Figure("rev", "stage", one(textures.draw_rev, texture), lambda s: has_contacts(s) and "rev" in texture(s)),
    Figure("threshold", "stage", one(textures.draw_threshold, lambda s: texture(s)["fabric"]["threshold"]), lambda s: has_contacts(s) and "threshold" in texture(s)["fabric"]),
    Figure("course", "stage", course, lambda s: has_contacts(s) and len(s.frames) > 2, 0.4, True),
    Figure("wall-forces", "stage", one(histories.draw_wall_forces, lambda s: s.history), has_time("bottom_force", "top_force", "left_force")),
    Figure("travel", "stage", one(histories.draw_travel, lambda s: s.history), has_time("bottom_position", "top_position")),
    Figure("energies", "stage", one(histories.draw_energies, lambda s: s.history), has_time("elastic")),
    Figure("rest", "stage", one(histories.draw_rest, lambda s: s.history), has_time("unbalanced_ratio")),
    Figure("phases", "field", one(fields.draw_phases, lambda f: f), height=1.0),
    Figure("stress", "field", fields_side_by_side, lambda f: f.loaded, 0.36, True),
    Figure("stress-pdf", "field", densities, lambda f: f.loaded, 0.4, True),
    Figure("cavities", "field", cavities, lambda f: not f.loaded),
    Figure("convergence", "field", one(fields.draw_convergence, lambda f: f.convergence), lambda f: len(f.convergence.get("residual", [])) > 1),
    Figure("stress-strain", "field", one(fields.draw_stress_strain, lambda f: f.curve), has_curve),
    Figure("cracks", "field", one(fields.draw_cracks, lambda f: f), has_curve, 1.05),
    Figure("broken-bonds", "field", one(fields.draw_broken_bonds, lambda f: f), lambda f: has_curve(f) and len(f.cracks["type"]) > 0),
    Figure("energy-balance", "field", one(fields.draw_energy_balance, lambda f: f.curve), has_curve),
    Figure("maps", "film", film_maps, height=0.55, wide=True),
    Figure("grains", "film", with_bar(films.draw_film_grains, lambda f: f, r"$\sigma_{norm}$"), lambda f: len(f.grains) > 0, 0.9),
    Figure("stresses", "film", one(films.draw_ranked_stresses, lambda f: f), lambda f: len(f.sigma_hyd) > 0),
    Figure("forces", "film", one(films.draw_ranked_forces, lambda f: f), lambda f: len(f.fn_error) > 0),
    Figure("certainty", "film", one(films.draw_certainty, lambda f: f), lambda f: len(f.fn_error) > 0),
    Figure("force-network", "film", one(packings.draw_forces, lambda f: f.packing), lambda f: len(f.fn_error) > 0, 1.0),
    Figure("beside-simulation", "film", beside, lambda f: len(f.twin) > 0, 0.5, True),
    Figure("against-simulation", "film", one(films.draw_against_twin, lambda f: f), lambda f: len(f.twin) > 0, 0.9),
    Figure("tails", "film", film_tails, lambda f: len(f.sigma_hyd) > 1),
    Figure("contact-directions", "film", film_roses, lambda f: "film" in f.numbers.get("directions", {}), 0.55),
]


def parts_of(result):
    """(kind, part) of everything in a result."""
    for stage in result.stages[-1:]:
        yield "stage", stage
    for field in result.fields:
        yield "field", field
    for film in result.films:
        yield "film", film


def figures_of(result):
    """(figure, part) of all that can be drawn of a result: of its last stage of loading, every field and film."""
    return [(figure, part) for kind, part in parts_of(result) for figure in figures if figure.kind == kind and figure.when(part)]


def save(figure, part, path, width=None, **style):
    """Draws one figure into a file; its ending (pdf, svg, png) decides the format. `width`: inches; one or two columns if not given."""
    with journal_style(**style):
        width = width or (page_width if figure.wide else column_width)
        canvas = Canvas(figsize=(width, width * figure.height), layout="constrained")
        figure.draw(canvas, part)
        logging.getLogger("fontTools").setLevel(logging.ERROR)  # it remarks on the dates of the fonts
        # Without a date the same result gives the same bytes.
        metadata = {"pdf": {"CreationDate": None}, "svg": {"Date": None}}.get(pathlib.Path(path).suffix[1:], {})
        canvas.savefig(path, metadata=metadata)


def study_figures(path):
    """(figure, part) of all that the page of a study shows and can be drawn yet."""
    return [(Figure(part["id"], "study", studies.draw_study_figure, height=studies.height_of(part)), part)
            for part in studies.study_document(path)["figures"] if studies.has_content(part)]


def save_all(result, folder, formats=("pdf",), names=None, width=None):
    """Every figure of a result or a study (a Result or its path) into a folder; gives the paths. `names`: only these figures."""
    is_path = isinstance(result, (str, pathlib.Path))
    of_study = is_path and studies.is_study(result)
    found = study_figures(result) if of_study else figures_of(open_result(str(result)) if is_path else result)
    known = {figure.name for figure, _ in found} if of_study else {figure.name for figure in figures}
    if unknown := set(names or []) - known:
        raise ValueError(f"there is no figure {', '.join(sorted(unknown))}; there are {', '.join(sorted(known))}")
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    for figure, part in found:
        if names and figure.name not in names:
            continue
        for form in formats:
            path = folder / (f"{figure.name}.{form}" if of_study else f"{part.name.replace(' ', '-')}-{figure.name}.{form}")
            save(figure, part, path, width)
            paths.append(path)
    return paths
