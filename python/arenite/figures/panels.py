"""Figures of several drawings, each on an empty matplotlib figure."""

from . import fields, films
from .style import sigma_norm


def components(figure, field, names, columns=3):
    for k, name in enumerate(names):
        axes = figure.add_subplot(-(-len(names) // columns), columns, k + 1)
        shown = fields.draw_field(axes, field, name)
        figure.colorbar(shown, ax=axes, shrink=0.75, extend="both", label=shown.get_label())


def film_maps(figure, film):
    draws = films.map_panels(film)
    for k, draw in enumerate(draws):
        axes = figure.add_subplot(-(-len(draws) // 4), 4, k + 1)
        draw(axes)
        axes.title.set_fontsize("small")  # four in a row


def beside(figure, film):
    names = [name for name in films.simulation_names if name in film.simulation]
    draws = [("film", films.draw_film_grains)] + [
        (films.simulation_names[name], lambda axes, f, name=name: films.draw_simulated_grains(axes, f, name))
        for name in names
    ]
    for k, (title, draw) in enumerate(draws):
        axes = figure.add_subplot(1, len(draws), k + 1)
        shown = draw(axes, film)
        axes.set_title(title)
    figure.colorbar(shown, ax=figure.axes, label=sigma_norm, shrink=0.8, extend="max")
