"""Spheres in space as the page shows them: seen from a side, without perspective, lit from above."""

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

from .. import _core
from .packings import bars, kind_colours, kinds_of
from .style import drawn as shared, strong, weak, widths_of_forces

azimuth, elevation = (
    np.radians(shared["look"][angle]) for angle in ("azimuth", "elevation")
)  # from where the page shows a sample in the beginning
light = np.array(shared["light"])
batch = 4096  # spheres that are drawn at a time
wide = 12  # pixels; a sphere of a larger radius is drawn on its own
fineness = 1.5  # pixels that are drawn for one that is shown
sides = ("left", "right", "bottom", "top", "back", "front")


def frame():
    """Rows: the directions to the right of the picture, up in it and towards the viewer; y is upright."""
    (ca, sa), (ce, se) = ((np.cos(angle), np.sin(angle)) for angle in (azimuth, elevation))
    return np.array([[ca, 0, -sa], [-sa * se, ce, -ca * se], [sa * ce, se, ca * ce]])


def seen(points):
    """Points of space as the picture's x and y and their depth towards the viewer."""
    return np.asarray(points, float) @ frame().T


def corners(packing):
    """The corners of the container, by which side along x, y and z they lie on; (2, 2, 2, 3)."""
    d = packing.domain
    ends = [[d[sides[2 * axis + k]]["position"] for k in (0, 1)] for axis in range(3)]
    at = np.stack(np.meshgrid(*ends, indexing="ij"), axis=-1)
    at[:, 1, :, 0] += d["tilt"]
    return at


def extent_of(packing):
    """(left, right, bottom, top) of a picture: the container and the spheres that lie out of it."""
    box, balls, r = seen(corners(packing).reshape(-1, 3)), seen(packing.position), packing.radius
    low, high = ((balls[:, :2].T + sign * r).T for sign in (-1, 1))
    (left, bottom), (right, top) = np.vstack([box[:, :2], low]).min(axis=0), np.vstack([box[:, :2], high]).max(axis=0)
    return left, right, bottom, top


class Raster:
    """An image of so many pixels across of a part of the picture, with the nearest sphere in each."""

    def __init__(self, extent, across, packing):
        self.extent, self.places, self.radius = extent, seen(packing.position), packing.radius
        self.pixel = (extent[1] - extent[0]) / across
        self.rows, self.columns = max(1, round((extent[3] - extent[2]) / self.pixel)), across
        self.depth = np.full((self.rows, self.columns), -np.inf)
        self.nearest = np.full((self.rows, self.columns), -1)
        # The middle of each pixel.
        self.x = extent[0] + (np.arange(self.columns) + 0.5) * self.pixel
        self.y = extent[2] + (np.arange(self.rows) + 0.5) * self.pixel
        front = self.places[:, 2] + self.radius
        order = np.argsort(-front, kind="stable")  # so that what others hide is left out soon
        for start in range(0, len(order), batch):
            part = order[start : start + batch]
            part = part[~self._hidden(part)]
            width = np.ceil(self.radius[part] / self.pixel).astype(int) + 1
            for sphere in part[width > wide]:
                self._draw_large(sphere)
            for w in np.unique(width[width <= wide]):
                self._draw_small(part[width == w], w)

    def _pixel_of(self, x, y):
        """Row and column of places."""
        column, row = (x - self.extent[0]) / self.pixel, (y - self.extent[2]) / self.pixel
        return np.floor(row).astype(int), np.floor(column).astype(int)

    def _hidden(self, part):
        """Whether nearer spheres lie over the middle of each and eight points of its rim."""
        (x, y, z), r = self.places[part].T, self.radius[part]
        hidden = np.ones(len(part), bool)
        for dx, dy in [(0, 0), *((np.cos(turn), np.sin(turn)) for turn in np.arange(8) * np.pi / 4)]:
            row, column = self._pixel_of(x + 0.98 * dx * r, y + 0.98 * dy * r)
            inside = (column >= 0) & (column < self.columns) & (row >= 0) & (row < self.rows)
            hidden &= inside & (self.depth[np.where(inside, row, 0), np.where(inside, column, 0)] > z + r)
        return hidden

    def _draw_large(self, sphere):
        (x, y, z), r = self.places[sphere], self.radius[sphere]
        (low, left), (high, right) = self._pixel_of(x - r, y - r), self._pixel_of(x + r, y + r)
        rows, columns = slice(max(0, low), high + 1), slice(max(0, left), right + 1)
        ahead = r * r - (self.y[rows, None] - y) ** 2 - (self.x[columns] - x) ** 2
        depth = np.where(ahead > 0, z + np.sqrt(np.maximum(0, ahead)), -np.inf)
        nearer = depth > self.depth[rows, columns]
        self.depth[rows, columns][nearer] = depth[nearer]
        self.nearest[rows, columns][nearer] = sphere

    def _draw_small(self, part, w):
        """Spheres of like size together."""
        (x, y, z), r = self.places[part].T, self.radius[part]
        row, column = self._pixel_of(x, y)
        step = np.arange(-w, w + 1)
        rows, columns = row[:, None] + step, column[:, None] + step
        there = ((rows >= 0) & (rows < self.rows))[:, :, None] & ((columns >= 0) & (columns < self.columns))[:, None]
        rows, columns = np.clip(rows, 0, self.rows - 1), np.clip(columns, 0, self.columns - 1)
        ahead = (r * r)[:, None, None] - ((self.y[rows] - y[:, None]) ** 2)[:, :, None]
        ahead = ahead - ((self.x[columns] - x[:, None]) ** 2)[:, None]
        which = np.nonzero(there & (ahead > 0))
        depth = z[which[0]] + np.sqrt(ahead[which])
        pixel = rows[which[0], which[1]] * self.columns + columns[which[0], which[2]]
        nearer = np.flatnonzero(depth > self.depth.ravel()[pixel])
        nearer = nearer[np.argsort(depth[nearer], kind="stable")]  # of several in a pixel the nearest comes last
        self.depth.ravel()[pixel[nearer]] = depth[nearer]
        self.nearest.ravel()[pixel[nearer]] = part[which[0][nearer]]

    def image(self, colours):
        """RGBA, the lowest row first, of spheres in these colours, (N, 3) from 0 to 1."""
        image = np.zeros((self.rows, self.columns, 4), np.float32)
        row, column = np.nonzero(self.nearest >= 0)
        sphere = self.nearest[row, column]
        off = np.stack([self.x[column], self.y[row], self.depth[row, column]]) - self.places[sphere].T
        image[row, column, :3] = shaded(colours[sphere], off / self.radius[sphere])
        image[row, column, 3] = 1
        return image


def shaded(colours, normal):
    """Colours of surfaces by their normals (3, N), as the page's."""
    bright = np.minimum(1, 0.5 + 0.58 * np.maximum(light @ normal, 0))
    rim = np.clip(normal[2] / 0.45, 0, 1)
    return colours * (bright * (0.66 + 0.34 * rim * rim * (3 - 2 * rim)))[:, None]


def edges(packing):
    """(lines behind the spheres, lines before them) of the container: those at its corner nearest to the viewer lie
    before."""
    at, places = corners(packing), seen(corners(packing))[..., :2]
    nearest = np.unravel_index(np.argmax(seen(at)[..., 2]), (2, 2, 2))
    behind, before = [], []
    for axis in range(3):
        for others in np.ndindex(2, 2):
            ends = [list(np.insert(others, axis, k)) for k in (0, 1)]
            meets = sum(a == b for a, b in zip(others, np.delete(nearest, axis)))
            (behind if meets == 0 else before).append([places[tuple(end)] for end in ends])
    return behind, before


def faces(packing):
    """Edges of the faces of boundaries that are there."""
    lines = []
    for boundary in packing.domain["boundaries"]:
        points = seen(boundary["points"])[:, :2]
        for start, count in zip(np.cumsum(boundary["corners"]) - boundary["corners"], boundary["corners"]):
            face = points[start : start + count]
            lines += [np.vstack([face, face[:1]])] if boundary["present"] else []
    return lines


def force_bars(axes, packing, mean, scale):
    """Normal forces between spheres as bars from centre to centre, as wide as strong, the nearest last; half a bar at
    either end where they cross a periodic side."""
    spheres = packing.contact_j >= 0
    i, j, fn = packing.contact_i[spheres], packing.contact_j[spheres], packing.fn[spheres]
    way = packing.normal[spheres] * (packing.radius[i] + packing.radius[j])[:, None]
    across = np.linalg.norm(packing.position[i] - packing.position[j] - way, axis=1) > packing.radius[i]
    reach = np.where(across, 0.5, 1)[:, None] * way
    start = np.concatenate([packing.position[i], packing.position[j[across]]])
    end = np.concatenate([packing.position[i] - reach, packing.position[j[across]] + reach[across]])
    fn = np.concatenate([fn, fn[across]])
    order = np.argsort(seen(start + end)[:, 2], kind="stable")
    start, end, fn = seen(start[order])[:, :2], seen(end[order])[:, :2], fn[order]
    kinds = kinds_of(fn, scale, np.zeros(len(fn), bool))
    width = widths_of_forces(fn, mean, _core._mean_radius(packing))
    colours = [kind_colours[kind] for kind in kinds]
    return axes.add_collection(
        PolyCollection(bars(start, end, width), facecolor=colours, edgecolor="white", linewidth=0.15), autolim=False
    )


def draw_state(axes, shot, colours, mean=None):
    """One state on axes that keep their limits; returns what is drawn. `colours` of spheres, (N, 3), or None: no
    spheres; `mean`: forces over it, before spheres that are pale."""
    packing, (left, right) = shot.packing, axes.get_xlim()
    behind, before = edges(packing)
    style = {"linewidths": 0.6, "capstyle": "round"}
    drawn = [axes.add_collection(LineCollection(behind, colors=weak, zorder=0, **style), autolim=False)]
    if colours is not None:
        extent = (left, right, *axes.get_ylim())
        image = Raster(extent, round(fineness * axes.get_window_extent().width), packing).image(colours)
        drawn.append(axes.imshow(image, origin="lower", extent=extent, zorder=1, alpha=0.3 if mean else 1))
    drawn.append(axes.add_collection(LineCollection(faces(packing), colors=strong, zorder=3, **style), autolim=False))
    drawn.append(axes.add_collection(LineCollection(before, colors=weak, zorder=3, **style), autolim=False))
    if mean and len(packing.contact_i) > 0:
        drawn.append(force_bars(axes, packing, mean, _core._force_scale(shot.stage, shot.snapshot)))
    return drawn
