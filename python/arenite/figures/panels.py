"""Figures of several drawings, each on an empty matplotlib figure."""

from .._core import measure
from . import densities, fields, film_forces, films, textures
from .style import colours, sigma_norm, strong, weak


def side_by_side(figure, draws):
    for k, draw in enumerate(draws):
        draw(figure.add_subplot(1, len(draws), k + 1))


def names_of(packing):
    return [material.name for material in packing.materials]


def sigma_norm_tails(figure, state):
    about, names = state.texture["sigma_norm"], names_of(state.packing)
    side_by_side(
        figure,
        [
            lambda axes, log=log: textures.draw_cumulative(axes, about, materials=names, log=log)
            for log in (False, True)
        ],
    )
    figure.axes[1].get_legend().remove()  # the linear one has room for it


def forces(figure, state):
    """Density with its fits, and survival function."""
    about, names = state.texture["force"], names_of(state.packing)
    side_by_side(
        figure,
        [
            lambda axes: textures.draw_density(axes, about, names),
            lambda axes: textures.draw_cumulative(axes, about, textures.over_mean, "strong_share", names),
        ],
    )


def rose_sets(fabric, materials):
    """(name, set, its strong contacts or none, colour): all, by strength, by type."""
    sets = fabric.get("sets", {})
    found = [
        ("all", fabric, sets.get("strong"), strong),
        ("strong", sets.get("strong"), sets.get("strong"), strong),
        ("weak", sets.get("weak"), None, weak),
    ]
    types = [name for name in sets if not name.endswith(("strong", "weak"))]
    found += [
        (textures.name_of(name), sets[name], sets.get(f"{name} strong"), textures.colour_of(name, materials))
        for name in types
    ]
    return [entry for entry in found if entry[1] and entry[1].get("contacts", 0) > 0 and "sectors" in entry[1]]


def draw_roses(figure, sets, load_axis=None, reach=None, columns=3):
    rows = -(-len(sets) // columns)
    if figure.get_layout_engine():  # room for the words above and below, which are wider than the circles are apart
        figure.get_layout_engine().set(w_pad=0.035 * figure.get_figwidth())
    for k, (name, of, inner, colour) in enumerate(sets):
        axes = figure.add_subplot(rows, min(columns, len(sets)), k + 1, projection="polar")
        textures.draw_rose(axes, of["sectors"], of, inner and inner["sectors"], colour, reach, load_axis)
        axes.set_title(f"{name} ({of['contacts']})", pad=12)
        axes.set_xlabel(textures.rose_numbers(of), labelpad=3)


def roses(figure, state):
    fabric = state.texture["fabric"]
    draw_roses(figure, rose_sets(fabric, names_of(state.packing)), fabric.get("load_axis_deg"))


def roses_height(state):
    return 0.38 * -(-len(rose_sets(state.texture["fabric"], names_of(state.packing))) // 3)


def film_rose_sets(film):
    names = [("film", "film", strong), ("simulation", "simulation", colours[1])]
    found = film.numbers["contact_orientations"]
    return [(name, found[key], None, colour) for key, name, colour in names if "sectors" in found.get(key, {})]


def film_roses(figure, film):
    """Contacts whose force changes in the film, and those of the simulation at the largest load, on one scale."""
    sets = film_rose_sets(film)
    draw_roses(figure, sets, reach=max(textures.reach_of(of) for _, of, _, _ in sets), columns=2)


def stress_path(figure, state):
    """Over all stored states of the run that have contacts, numbered from the first."""
    measured = [
        (k, measure(snapshot.packing, curves=False))
        for k, snapshot in enumerate(state.snapshots, 1)
        if len(snapshot.packing.contacts) > 0
    ]
    known = [(k, texture) for k, texture in measured if "a_c" in texture.get("fabric", {})]
    side_by_side(
        figure,
        [
            lambda axes, of=of: textures.draw_stress_path(
                axes, [texture for _, texture in known], of, [k for k, _ in known]
            )
            for of in ("coordination", "anisotropy")
        ],
    )


def components(figure, field, names, columns=3):
    for k, name in enumerate(names):
        axes = figure.add_subplot(-(-len(names) // columns), columns, k + 1)
        shown = fields.draw_field(axes, field, name)
        figure.colorbar(shown, ax=axes, shrink=0.75, extend="both", label=shown.get_label())


def density_panels(figure, field, component):
    """Over the sample's mean and, if each phase has one, over its own with the fits; linear and logarithmic."""
    rows = density_rows(field, component)
    for row, own in enumerate(rows):
        for column, log in enumerate([False, True]):
            densities.draw_densities(
                figure.add_subplot(len(rows), 2, 2 * row + column + 1), statistics_of(field), component, own, log
            )


def density_rows(field, component):
    about = statistics_of(field).get(component)
    return [own for own in (False, True) if about and densities.sets_of(about, own)]


def statistics_of(field):
    """With curves; measured once per field."""
    if id(field) not in _statistics:
        _statistics.clear()
        _statistics[id(field)] = (field, fields.statistics_of(field))
    return _statistics[id(field)][1]


_statistics = {}


def film_maps(figure, film):
    draws = films.map_panels(film)
    for k, draw in enumerate(draws):
        draw(figure.add_subplot(-(-len(draws) // 4), 4, k + 1))


def beside(figure, film):
    names = [name for name in film_forces.simulation_names if name in film.simulation]
    draws = [("film", films.draw_film_grains)] + [
        (film_forces.simulation_names[name], lambda axes, f, name=name: films.draw_simulated_grains(axes, f, name))
        for name in names
    ]
    for k, (title, draw) in enumerate(draws):
        axes = figure.add_subplot(1, len(draws), k + 1)
        shown = draw(axes, film)
        axes.set_title(title)
    figure.colorbar(shown, ax=figure.axes, label=sigma_norm, shrink=0.8, extend="max")


def against(figure, film):
    side_by_side(
        figure,
        [
            lambda axes, name=name: film_forces.draw_against_simulation(axes, film, name)
            for name in film_forces.simulation_names
            if name in film.simulation
        ],
    )


def film_tails(figure, film):
    """Film, and the peak-to-peak stress and the state of its companion simulation."""
    sets = [("film", film.sigma_hyd, strong)] + [
        (film_forces.simulation_names[name], film.simulation[name], colour)
        for name, colour in (("peak_to_peak", colours[1]), ("state", colours[2]))
        if name in film.simulation
    ]
    textures.draw_cumulative_sets(
        figure.add_subplot(),
        [(name, measure(film.packing, sigma_hyd=sigma).get("sigma_norm", {}), colour) for name, sigma, colour in sets],
    )


def ranked_forces(figure, film):
    side_by_side(
        figure,
        [
            lambda axes, c=c: film_forces.draw_ranked_forces(axes, film, c)
            for c in ("fn", "ft")
            if len(getattr(film, f"{c}_error"))
        ],
    )
