"""A figure that draws one stored state after another, with a curve beside it on which a mark moves."""

import matplotlib
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.cm import ScalarMappable
from matplotlib.colors import BoundaryNorm, Normalize
from matplotlib.figure import Figure as Canvas

from .. import _core, curves
from . import motion, packings, spheres
from .drawing import draw_panel
from .packings import material_key
from .style import bare, colours, length_bar, plain, scaled, strong

dots = 100  # pixels an inch
text_size = {"font.size": 9, "axes.labelsize": 9, "xtick.labelsize": 8, "ytick.labelsize": 8, "legend.fontsize": 8}


class Pictures:
    """The states of `shots`; common parts are laid out once. Options as in `arenite.animate.save`."""

    def __init__(self, shots, by, size, chains=False, colour_map=None, low=None, high=None, beside=None):
        self.shots, self.beside, self.drawn = shots, beside, []
        self.figure = Canvas(figsize=(size[0] / dots, size[1] / dots), dpi=dots, layout="constrained")
        FigureCanvasAgg(self.figure)
        self.figure.get_layout_engine().set(w_pad=0.1, h_pad=0.06)
        self.axes, side_axes = panels(self.figure, shots, beside)
        self.values, self.style = look(self.axes, shots, by, chains, colour_map, low, high)
        self.heading = self.axes.set_title(" ")
        if beside:
            beside.begin(side_axes, shots)
        self.image(len(shots) - 1)
        self.figure.set_layout_engine("none")  # laid out; for every state anew it would take longer than to draw

    def __len__(self):
        return len(self.shots)

    def image(self, k):
        """State k as bytes, (height, width, 4); the next one overwrites them."""
        for artist in self.drawn:
            artist.remove()
        shot = self.shots[k]
        self.drawn = motion.draw_shot(self.axes, shot, self.values[k], **self.style)
        self.heading.set_text(f"{plain(shot.stage.name)}, {plain(shot.snapshot.label)}, {shot.snapshot.time:.4g} s")
        if self.beside:
            self.beside.show(shot)
        self.figure.canvas.draw()
        return np.asarray(self.figure.canvas.buffer_rgba())


def panels(figure, shots, beside):
    """Axes of the picture, which hold the cell of every state, and those of the curve, or None."""
    axes, side = figure.subplots(1, 2, width_ratios=(1.5, 1)) if beside else (figure.subplots(), None)
    ends = np.array([(spheres if shot.in_space else packings).extent_of(shot.packing) for shot in shots])
    left, right, bottom, top = ends[:, 0].min(), ends[:, 1].max(), ends[:, 2].min(), ends[:, 3].max()
    margin = 0.02 * max(right - left, top - bottom)
    axes.set(xlim=(left - margin, right + margin), ylim=(bottom - 3 * margin, top + margin))
    length_bar(axes, right - left, left, bottom - 2.6 * margin)
    bare(axes)
    return axes, side


def look(axes, shots, by, chains, colour_map, low, high):
    """(`values` of each state for draw_shot, its other options); draws the legend or the colour bar."""
    style = {"spoked": by == "rotation"}
    if chains or by == "forces":
        style["mean"] = _core._mean_push([shot.contacts for shot in shots]) or None
    colouring = motion.colourings[by]
    if colouring is None:
        if by == "material":
            material_key(axes, shots[-1].packing)
        return [None if by == "forces" else by] * len(shots), style
    values = colouring.values(shots)
    colour_map = matplotlib.colormaps[colour_map] if colour_map else colouring.colour_map
    if by == "z":
        norm = whole_numbers(values, low, high)
    else:
        norm = Normalize(*motion.limits_of(colouring, values, low, high))
    bar(axes, colouring, norm, colour_map, by)
    return values, {**style, "norm": norm, "colour_map": colour_map}


def whole_numbers(values, low, high):
    """One colour per number."""
    low, high = int(low or 0), int(np.max(np.concatenate(values)) if high is None else high)
    return BoundaryNorm(np.arange(low, max(high, low + 1) + 2) - 0.5, 256)


def scale_of(unit, largest):
    """What numbers are divided by, and their unit; angles are in degrees."""
    if unit == "rad":
        return np.pi / 180, "°"
    return scaled(largest, unit)


def bar(axes, colouring, norm, colour_map, by):
    factor, unit = scale_of(colouring.unit, max(abs(norm.vmin), abs(norm.vmax)))
    shown = axes.figure.colorbar(
        ScalarMappable(norm, colour_map),
        ax=axes,
        label=f"{colouring.label}, {unit}" if unit else colouring.label,
        shrink=0.8,
        pad=0.02,
        extend="neither" if by == "z" else "both" if norm.vmin else "max",
    )
    if by == "z":
        shown.set_ticks(np.arange(norm.boundaries[0] + 0.5, norm.boundaries[-1]))
    else:
        shown.formatter = matplotlib.ticker.FuncFormatter(lambda value, _: f"{value / factor:.4g}")
        shown.locator = matplotlib.ticker.FixedLocator(
            factor * matplotlib.ticker.MaxNLocator(6).tick_values(norm.vmin / factor, norm.vmax / factor)
        )
        shown.update_ticks()


class Beside:
    """One curve of the stage of the state shown against another, with a mark at that state. `names`: of x and y, or
    "test"."""

    def __init__(self, result, names):
        self.result, self.names = result, ("test", "test") if names == "test" else names

    def begin(self, axes, shots):
        self.axes, self.stage, self.mark = axes, None, None
        stages = {shot.stage.name: shot.stage for shot in shots if curves.has_history(shot.stage)}
        panels = {name: self.panel_of(name) for name in stages}
        self.panels = {name: panel for name, panel in panels.items() if panel}
        if panels and not self.panels:
            raise ValueError(
                f"no stage ({', '.join(panels)}) is compressed along one axis or sheared, so there is no curve of a "
                "test beside the spheres; give two columns of the history, X,Y"
            )

    def panel_of(self, stage):
        in_space = [part for part in getattr(self.result, "spheres", []) if part.name == stage]
        if in_space:
            return _core._curve_of_stage(in_space[0], *self.names).get("panel")
        test = curves.find_test(self.result, stage)
        return _core._curve_of_stage(test.stage, test.before, *self.names)["panel"]

    def show(self, shot):
        if shot.stage.name != self.stage:
            self.change(shot.stage)
        if self.mark:
            now, place = self.panels[self.stage]["now"], place_of(shot)
            self.mark.set_data([now["x"][place]], [now["y"][place]])

    def change(self, stage):
        self.axes.clear()
        self.stage, self.mark = stage.name, None
        self.axes.set_visible(stage.name in self.panels)
        if stage.name in self.panels:
            draw_panel(self.axes, self.panels[stage.name])
            (self.mark,) = self.axes.plot([], [], "o", color=colours[1], markersize=7, markeredgecolor=strong)
            self.axes.set_box_aspect(1)


def place_of(shot):
    """Of a state among those of its stage."""
    return [snapshot.time for snapshot in shot.stage.snapshots].index(shot.snapshot.time)
