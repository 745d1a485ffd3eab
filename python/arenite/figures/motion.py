"""Fast drawing of stored states one after another: grains coloured by a quantity, force chains, walls and periodic
images."""

import dataclasses
import typing

import matplotlib
import numpy as np
from matplotlib.collections import EllipseCollection, LineCollection, PolyCollection
from matplotlib.patches import Rectangle

from .. import _core
from . import spheres
from .packings import bars, boundaries_of, kind_colours, kinds_of, segments, sides_of
from .style import colours, label, pale, scale_maps, strong, tension, weak, widths_of_forces


def mobilisation(shot):
    """Mean |F_t|/(mu F_n) of a grain's pressed contacts; |F_t|/F_n if mu is not known."""
    return _core.mobilisation(shot.packing, shot.stage.asked.get("friction"))


def by_stage(of):
    """What `of` makes of the states of each stage, one after another."""
    return lambda shots: [
        value
        for stage in dict.fromkeys(shot.stage.name for shot in shots)
        for value in of([shot for shot in shots if shot.stage.name == stage])
    ]


@by_stage
def displacements(shots):
    """How far grains have gone since the first state of the stage, m, for each; without the shear of a cell."""
    return _core._sizes_of_displacements([shot.packing for shot in shots], [shot.sheared for shot in shots])


@by_stage
def rotations(shots):
    """Rotations of grains since the first state of the stage, rad. Raises ValueError for spheres, of which states have
    none."""
    if shots[0].in_space:
        raise ValueError("spheres in space have no rotation that a colour could tell; choose another colouring")
    return _core._rotations([shot.packing for shot in shots])


@dataclasses.dataclass
class Colouring:
    """A colouring of grains by a quantity of the library, whose label, unit and colours it has: `values(shots)` gives
    one array per state, in SI units."""

    quantity: str
    values: typing.Callable
    low: typing.Any = None  # None: from the states
    high: typing.Any = None

    @property
    def label(self):
        return label(_core._grain_quantities()[self.quantity][0])

    @property
    def unit(self):
        return _core._grain_quantities()[self.quantity][2]

    @property
    def scale(self):
        return _core._grain_quantities()[self.quantity][4]

    @property
    def colour_map(self):
        return scale_maps[self.scale]

    @property
    def symmetric(self):
        return self.scale == "diverging"


def each(of):
    return lambda shots: [of(shot) for shot in shots]


def by_quantity(name, low=None):
    """A colouring by a number that a state alone gives."""
    return Colouring(name, each(lambda shot: _core.grain_values(shot.packing, name)), low)


colourings = {
    "material": None,
    "forces": None,
    "pressure": by_quantity("pressure", 0.0),
    "deviator": by_quantity("deviator", 0.0),
    "z": by_quantity("coordination"),
    "velocity": by_quantity("speed", 0.0),
    "displacement": Colouring("displacement", displacements, low=0.0),
    "rotation": Colouring("rotation", rotations),
    "mobilisation": Colouring("mobilisation", each(mobilisation), low=0.0, high=1.0),
}


def limits_of(colouring, values, low=None, high=None):
    """(lowest, highest) of the colour scale of all states, in SI units: as given, else the range without one per cent
    of the values at either end."""
    every = np.concatenate(values)
    every = every[np.isfinite(every)] if np.any(np.isfinite(every)) else np.zeros(1)
    found = np.percentile(every, [1, 99])
    if colouring.symmetric and low is None and high is None:
        high = max(np.percentile(np.abs(every), 99), 1e-12)
        low = -high
    low = next(v for v in (low, colouring.low, found[0]) if v is not None)
    high = next(v for v in (high, colouring.high, found[1]) if v is not None)
    return low, high if high > low else low + max(abs(low), 1e-9)


def with_images(packing):
    """(place among the grains, x, y) of grains and of their images across periodic sides that reach into the cell."""
    d = packing.domain
    index, x, y = np.arange(len(packing)), packing.x, packing.y
    if d["periodic_y"]:
        low, high, r = d["bottom"]["position"], d["top"]["position"], packing.radius
        below, above = np.flatnonzero(y < low + r), np.flatnonzero(y > high - r)
        index = np.concatenate([index, below, above])
        x = np.concatenate([x, x[below] + d["tilt"], x[above] - d["tilt"]])
        y = np.concatenate([y, y[below] + d["height"], y[above] - d["height"]])
    if d["periodic_x"]:
        low, width = d["left"]["position"], d["width"]
        x = low + np.mod(x - low, width)  # images of a sheared cell lie anywhere along it
        r = packing.radius[index]
        left, right = np.flatnonzero(x < low + r), np.flatnonzero(x > low + width - r)
        index, y = np.concatenate([index, index[left], index[right]]), np.concatenate([y, y[left], y[right]])
        x = np.concatenate([x, x[left] + width, x[right] - width])
    return index, x, y


def disks(axes, packing, **options):
    """(collection, place of each of its disks among the grains), periodic images too."""
    index, x, y = with_images(packing)
    diameter = 2 * packing.radius[index]
    drawn = EllipseCollection(
        diameter,
        diameter,
        np.zeros(len(index)),
        units="xy",
        offsets=np.column_stack([x, y]),
        offset_transform=axes.transData,
        **options,
    )
    axes.add_collection(drawn, autolim=False)
    return drawn, index


def spokes(axes, packing):
    """A radius on every grain, which shows its rotation."""
    index, x, y = with_images(packing)
    r, angle = 0.9 * packing.radius[index], packing.angle[index]
    ends = np.column_stack([x + r * np.cos(angle), y + r * np.sin(angle)])
    return axes.add_collection(
        LineCollection(np.stack([np.column_stack([x, y]), ends], axis=1), colors=strong, linewidths=0.6), autolim=False
    )


def chains(axes, packing, mean, scale):
    """Forces as bars with a width in proportion to force over `mean`; strong ones, above the mean of this state, dark,
    tensile ones red, by its `scale`. White rims distinguish them from dark grains."""
    c = packing.contacts
    kinds = kinds_of(c.fn, scale, np.zeros(len(c), bool))
    width = widths_of_forces(c.fn, mean, _core._mean_radius(packing))
    drawn = []
    for kind in ("weak", "strong", "tension"):
        of = kinds == kind
        shapes = np.concatenate([bars(start[of], end[of], width[of]) for start, end in segments(packing)])
        drawn.append(
            axes.add_collection(
                PolyCollection(
                    shapes, facecolor=kind_colours[kind], edgecolor="white", linewidth=0 if kind == "weak" else 0.3
                ),
                autolim=False,
            )
        )
    return drawn


def sides(axes, packing):
    """Walls as thick lines, boundaries and membranes, edges of a periodic cell dashed, and the shear displacement of a
    sheared cell; nothing where a wall was removed."""
    d = packing.domain
    left, right, bottom, top = (d[side]["position"] for side in ("left", "right", "bottom", "top"))
    lines = sides_of(packing)
    walls = [line for side, line in lines.items() if d[side]["present"]]
    edges = [line for side, line in lines.items() if d["periodic_x" if side in ("left", "right") else "periodic_y"]]
    drawn = [
        LineCollection(walls, colors=strong, linewidths=1.8, capstyle="projecting"),
        LineCollection(boundaries_of(packing), colors=strong, linewidths=1.4, zorder=3),
        LineCollection(edges, colors=weak, linewidths=0.7, linestyles="--"),
    ]
    if d["tilt"]:
        drawn.append(
            LineCollection(
                [((left, bottom), (left + d["tilt"], top)), ((right, bottom), (right + d["tilt"], top))],
                colors=tension,
                linewidths=1.5,
                linestyles=":",
                zorder=3,
            )
        )
    return [axes.add_collection(collection, autolim=False) for collection in drawn]


def clip(axes, packing, drawn):
    """Clips drawings at the edges of a periodic cell."""
    d = packing.domain
    if d["periodic_x"] or d["periodic_y"]:
        reach = 0.0 if d["periodic_x"] and d["periodic_y"] else np.max(packing.radius)
        x, y = (reach * (not d[f"periodic_{axis}"]) for axis in "xy")
        cell = Rectangle(
            (d["left"]["position"] - x, d["bottom"]["position"] - y),
            d["width"] + 2 * x,
            d["height"] + 2 * y,
            transform=axes.transData,
        )
        for artist in drawn:
            artist.set_clip_path(cell)


def draw_shot(axes, shot, values=None, norm=None, colour_map=None, mean=None, spoked=False):
    """One state on axes that keep their limits, of disks or of spheres; the options are those of `draw_disks`."""
    if not shot.in_space:
        return draw_disks(axes, shot, values, norm, colour_map, mean, spoked)
    if values is None:
        shades = None
    elif isinstance(values, str):
        names = matplotlib.colors.to_rgba_array(colours)[:, :3]
        shades = names[shot.packing.material % len(colours)]
    else:
        shades = matplotlib.colormaps.get_cmap(colour_map)(norm(values))[:, :3]
    return spheres.draw_state(axes, shot, shades, mean)


def draw_disks(axes, shot, values=None, norm=None, colour_map=None, mean=None, spoked=False):
    """One state on axes that keep their limits; returns what is drawn, to be removed before the next. `values`: one
    number per grain with `norm` and `colour_map`, "material", or None for outlines; `mean`: force chains over this
    force; `spoked`: rotation is shown.
    """
    packing = shot.packing
    of_material = isinstance(values, str)
    style = (
        {"linewidth": 0.25, "edgecolor": strong}
        if values is not None
        else {"linewidth": 0.4, "edgecolor": pale, "facecolor": "none"}
    )
    grains, index = disks(axes, packing, **style)
    if of_material:
        grains.set_facecolor([colours[m % len(colours)] + "bf" for m in packing.material[index]])
    elif values is not None:
        grains.set(array=values[index], norm=norm, cmap=colour_map)
    drawn = [grains]
    if spoked:
        drawn.append(spokes(axes, packing))
    if mean and len(packing.contacts) > 0:
        drawn += chains(axes, packing, mean, _core._force_scale(shot.stage, shot.snapshot))
    clip(axes, packing, drawn)
    return drawn + sides(axes, packing)
