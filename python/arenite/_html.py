"""Display of results in a notebook: a line of text, the main numbers, and a picture."""

import base64
import html
import io

from . import _core


def _picture(name, *objects, **options):
    """The picture drawn by `arenite.figures.NAME`; empty without Matplotlib, so that the numbers are shown in any
    case."""
    try:
        from matplotlib.figure import Figure

        from . import figures
    except ImportError:
        return ""
    figure = Figure(figsize=(5, 5), layout="constrained")
    getattr(figures, name)(figure.add_subplot(), *objects, **options)
    store = io.BytesIO()
    figure.savefig(store, format="png", dpi=100)
    picture = base64.b64encode(store.getvalue()).decode()
    return f'<img alt="picture" style="max-width: 100%" src="data:image/png;base64,{picture}"/>'


def _table(rows):
    cells = "".join(
        f"<tr><th style='text-align: left'>{html.escape(name)}</th><td>{html.escape(value)}</td></tr>"
        for name, value in rows
    )
    return f"<table>{cells}</table>"


def _measured(statistic):
    if not statistic or statistic.get("value") is None:
        return "unknown"
    error = statistic.get("error")
    return _core._with_error(statistic["value"], float("nan") if error is None else error)


def packing(self):
    domain = self.domain
    rows = [
        ("grains", str(len(self))),
        ("contacts", str(len(self.contacts))),
        ("container", f"{1e3 * domain['width']:.4g} mm × {1e3 * domain['height']:.4g} mm"),
    ]
    return _table(rows) + _picture("draw_packing", self)


def stage(self):
    texture = self.texture
    rows = [("stage", self.name), ("outcome", self.outcome)]
    if texture:
        rows += [
            ("solid fraction", _measured(texture.get("solid_fraction"))),
            ("coordination", _measured(texture.get("coordination", {}).get("all"))),
        ]
    return _table(rows) + (_picture("draw_packing", self.packing) if self.snapshots else "")


def field(self):
    return _table([("result", self.name), ("outcome", self.outcome)]) + _picture(
        "draw_field" if self.loaded else "draw_phases", self
    )


def phase_map(self):
    return _table([("nodes", f"{self.width} × {self.height}"), ("spacing", f"{1e3 * self.dx:.4g} mm")]) + _picture(
        "draw_phases", self
    )


def lockin_maps(self):
    return _table([("frequency", f"{self.frequency:.6g} Hz"), ("frames", str(self.frames))]) + _picture(
        "draw_map", self.in_phase, label="signed amplitude"
    )


def film_result(self):
    return _table([("result", self.name), ("outcome", self.outcome)]) + _picture("draw_film_grains", self)


def result(self):
    rows = [("result", self.path), ("title", self.title)]
    rows += [(part.name, part.outcome) for part in [*self.stages, *self.fields, *self.films]]
    last = self.films[-1:] or self.fields[-1:] or self.stages[-1:]
    return _table(rows) + "".join(part._repr_html_() for part in last)


pictures = {
    "Packing": packing,
    "Stage": stage,
    "Field": field,
    "PhaseMap": phase_map,
    "LockinMaps": lockin_maps,
    "FilmResult": film_result,
    "Result": result,
}
