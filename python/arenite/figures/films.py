"""Pictures of an infrared film: maps of its pixels, grains by their stress (T figures 3.7 to 3.10)."""

from textwrap import fill

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import ListedColormap, Normalize

from .. import _core
from .drawing import heads
from .packings import circles
from .style import (
    bare,
    cyclic_map,
    diverging_map,
    drawn,
    length_bar,
    most_stress,
    scale_maps,
    scaled,
    stress_map,
    strong,
)

bad_pixel = "#ff2d95"
beyond_pixels = drawn["beyond"]["pixels"]  # share of them beyond either end of a scale of colours, as on the page


def _of_companions():
    """{"peak_to_peak": "simulation, peak to peak"}: what the library calls the stresses of a companion simulation."""
    against = next(head for head in heads()["film"] if head["id"] == "film-simulation")
    options = next(choice["options"] for choice in against["choices"] if choice["key"] == "companion")
    return {value: f"simulation, {words.lower()}" for value, words, *_ in options}


simulation_names = _of_companions()


def _show(axes, values, pixel, **options):
    """A picture, top row first; with a scale bar below if the side of a pixel (m) is known."""
    height, width = values.shape[:2]
    side = pixel if pixel > 0 else 1
    shown = axes.imshow(
        values, extent=(0, width * side, 0, height * side), interpolation="nearest", rasterized=True, **options
    )
    bare(axes)
    if pixel > 0:
        axes.set_ylim(-0.12 * height * side, height * side)
        length_bar(axes, width * side, 0, -0.09 * height * side)
    return shown


def draw_map(axes, values, label=None, share=beyond_pixels, colour_map="inferno", about=None, pixel=0):
    """A map of pixels, top row first; the colour range excludes `share` of the pixels at each end and is symmetric
    about `about` if that is given; `label` adds a colour bar with a title, `pixel` (m) a scale bar."""
    low, high = _core._ends_of(np.ravel(values), share)
    if about is not None:
        reach = max(high - about, about - low) or 1.0
        low, high = about - reach, about + reach
    shown = _show(axes, values, pixel, vmin=low, vmax=high, cmap=colour_map)
    if label:
        axes.set_title(label)
        axes.figure.colorbar(shown, ax=axes, shrink=0.8)
    return shown


def draw_fit(figure, film):
    """The measured map, the map predicted from the contact forces, and their difference: peak to peak on one scale."""
    maps, said = _core._fit_maps(film), _core._film_maps(film)
    most = max(map(abs, _core._ends_of(np.ravel(maps["measured"][0]), beyond_pixels)))
    factor, unit = scaled(most, said["in_phase"]["unit"])
    reach = most / factor or 1
    labels = {"fitted": said["fitted"]["label"].lower(), "residual": said["fit_residual"]["label"].lower()}
    for k, name in enumerate(maps):
        axes = figure.add_subplot(1, 3, k + 1)
        values, spread = maps[name]
        shown = _show(axes, values / factor, film.pixel, vmin=-reach, vmax=reach, cmap=diverging_map)
        title = labels.get(name, name)
        axes.set_title(f"{title}, r.m.s. {spread / factor:.3g} {unit}" if np.isfinite(spread) else title)
    figure.colorbar(shown, ax=figure.axes, label=f"{in_small(said['in_phase']['title'])} ({unit})", shrink=0.8)


def draw_phase(axes, maps, pixel=0):
    """Phase relative to the load; pale where the amplitude is too few standard errors and the phase is meaningless."""
    said = _core._film_maps()["phase"]
    _phase(axes, {**said, "values": np.degrees(maps.phase_after_load)}, maps.amplitude, maps.standard_error, pixel)


def _phase(axes, said, amplitude, error, pixel):
    norm = Normalize(-180, 180)
    shown = cyclic_map(norm(said["values"]))
    if np.size(amplitude) and np.size(error):
        faint = np.asarray(amplitude) < _core._faint_below * np.asarray(error)
        shown[faint, :3] = 1 - 0.2 * (1 - shown[faint, :3])
    _show(axes, shown, pixel)
    axes.set_title(in_small(said["title"]))
    axes.figure.colorbar(ScalarMappable(norm, cyclic_map), ax=axes, shrink=0.8, ticks=[-180, -90, 0, 90, 180])


def draw_bad_pixels(axes, film):
    """The replaced pixels, on the image at the smallest load."""
    said = _core._film_maps()["bad"]
    draw_map(axes, film.picture, said["title"], colour_map=scale_maps[said["colours"]], pixel=film.pixel)
    bad = np.asarray(film.bad, bool)
    _show(axes, np.where(bad, 1.0, np.nan), film.pixel, cmap=ListedColormap([bad_pixel]))
    axes.set_title(f"{bad.sum()} pixels replaced")


def in_small(title):
    """A title as print has it: without a capital, and without what is set apart in brackets."""
    return title[0].lower() + title[1:].split(" (")[0]


def draw_film_map(axes, film, said):
    """One of `_film_maps`."""
    if said["marks"]:
        return draw_bad_pixels(axes, film)
    if said["cyclic"]:
        return _phase(axes, said, film.maps.amplitude, film.maps.standard_error, film.pixel)
    factor, unit = scaled(max(map(abs, said["ends"])), said["unit"])
    about = 0 if said["around"] == "zero" else None
    title = fill(f"{in_small(said['title'])}, {unit}", 34)
    return draw_map(
        axes, said["values"] / factor, title, colour_map=scale_maps[said["colours"]], about=about, pixel=film.pixel
    )


def map_panels(film):
    """[function of axes] that draw the maps of a film, in the order of the page."""
    return [lambda axes, said=said: draw_film_map(axes, film, said) for said in _core._film_maps(film).values()]


def uncertain(film):
    """One flag per contact: accepted as present, but possibly absent."""
    return _core._doubtful_contacts(film).astype(bool)


def _disks(axes, film, values, most):
    """Grains in metres, or in pixels if their size is not known."""
    grains, side = film.grains, film.pixel if film.pixel > 0 else 1
    x, y, radius = side * grains.x, -side * grains.y, side * grains.radius
    disks = circles(x, y, radius, linewidth=0.25, edgecolor=strong, cmap=stress_map)
    disks.set(array=values, clim=(0, most))
    axes.add_collection(disks)
    left, right, bottom, top = (x - radius).min(), (x + radius).max(), (y - radius).min(), (y + radius).max()
    bare(axes)
    axes.set(xlim=(left, right), ylim=(bottom - (0.12 * (top - bottom) if film.pixel > 0 else 0), top))
    if film.pixel > 0:
        length_bar(axes, right - left, left, bottom - 0.09 * (top - bottom))
    return disks


def draw_film_grains(axes, film, most=most_stress):
    """sigma_norm of every grain from the film."""
    return _disks(axes, film, _core._film_sigma_norm(film)["film"], most)


def draw_simulated_grains(axes, film, which="peak_to_peak", most=most_stress):
    """The same for the companion simulation, "peak_to_peak" or its "state"."""
    return _disks(axes, film, _core._film_sigma_norm(film)[f"simulation_{which}"], most)
