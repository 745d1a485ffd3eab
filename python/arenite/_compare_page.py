"""The page of `arenite compare`: differences in the settings and numbers of two results, and the curves of both."""

import base64
import html
import io

import numpy as np

from . import _core, compare, curves
from ._core import measure

style = """
body { font: 15px/1.45 system-ui, sans-serif; margin: 2rem auto; max-width: 76rem; padding: 0 1rem }
body { color: #1a1a1a; background: #fff }
h1 { font-size: 1.4rem } h2 { font-size: 1.1rem; margin-top: 2rem } img { width: 100% }
table { border-collapse: collapse; font-variant-numeric: tabular-nums }
th, td { padding: .15rem .8rem .15rem 0; text-align: left; border-bottom: 1px solid #ddd; vertical-align: top }
td.n { text-align: right; white-space: nowrap } td code { overflow-wrap: anywhere }
section th { text-align: right } section th:first-child { text-align: left }
tr.beyond { background: #fdeadd } .a { color: #0072b2 } .b { color: #d55e00 } .wide { overflow-x: auto }
#only:checked ~ section tr.other { display: none }
"""


def page(a, b, names):
    """HTML of two results called `names`."""
    found = compare.rows(a, b)
    pairs = compare.pairs_of(a, b)
    marked = [
        f'<span class="{letter.lower()}">{letter}</span> {html.escape(name)}' for letter, name in zip("AB", names)
    ]
    parts = [
        f"<h1>{marked[0]} &nbsp; {marked[1]}</h1>",
        about(a, b),
        f"<p>{html.escape(compare.summary(found))}</p>",
        settings(pairs),
        figure(pairs),
        '<h2>Numbers</h2><input type="checkbox" id="only" checked> '
        '<label for="only">only differences beyond their errors</label>',
    ]
    parts += [section(name, [row for row in found if row.part == name]) for name, *_ in pairs]
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width">'
        f"<title>{html.escape(' and '.join(names))}</title><style>{style}</style></head><body>\n"
        + "\n".join(parts)
        + "\n</body></html>\n"
    )


def about(a, b):
    lines = [
        f"<li>{letter}: {html.escape(result.title or 'without a title')}</li>" for letter, result in zip("AB", (a, b))
    ]
    return f"<ul>{''.join(lines)}</ul>"


def table(head, body):
    cells = "".join(f"<th>{html.escape(text)}</th>" for text in head)
    return f'<div class="wide"><table><tr>{cells}</tr>{"".join(body)}</table></div>'


def settings(pairs):
    """Keys that differ between the recipes of the last parts compared."""
    recipes = [recipe_of(part[3]) for part in pairs[-1][1:]]
    differing = [key for key in {**recipes[0], **recipes[1]} if recipes[0].get(key) != recipes[1].get(key)]
    if not differing:
        return "<h2>Settings</h2><p>No setting differs.</p>" if any(recipes) else ""
    body = [
        f"<tr><td><code>{html.escape(key)}</code></td>"
        + "".join(f"<td>{html.escape(recipe.get(key, '-'))}</td>" for recipe in recipes)
        + "</tr>"
        for key in differing
    ]
    return "<h2>Settings that differ</h2>" + table(["key", "A", "B"], body)


def recipe_of(part):
    """{key: value} of the recipe of a part, as this version reads it; {} if the part has none."""
    return dict(_core.settings(part.provenance.get("recipe", ""))) if hasattr(part, "provenance") else {}


def section(name, found):
    counts = compare.counted(found)
    head = f"<h2>{html.escape(name)}</h2><p>{counts[compare.beyond]} beyond their errors, of {len(found)}.</p>"
    body = [numbers_of(row) for row in found]
    return "<section>" + head + table(["number", "A", "B", "B − A", "in standard errors", ""], body) + "</section>"


def numbers_of(row):
    cells = [
        compare.with_error(row.a, row.a_error),
        compare.with_error(row.b, row.b_error),
        compare.number(row.difference),
        compare.in_errors(row),
    ]
    numbers = "".join(f'<td class="n">{html.escape(cell)}</td>' for cell in cells)
    kind = "beyond" if row.verdict == compare.beyond else "other"
    name = f"<td><code>{html.escape(row.name)}</code></td>"
    return f'<tr class="{kind}">{name}{numbers}<td>{row.verdict}</td></tr>'


def figure(pairs):
    """Curves of both in one picture; nothing if there are none."""
    drawn = [(name, *panel) for name, one, other in pairs for panel in panels(one[0], one[3], other[3])]
    return f'<h2>Curves</h2><img alt="curves of both" src="{picture(drawn)}">' if drawn else ""


def panels(kind, a, b):
    """[(x label, y label, scales, [(x, y) of a, of b])] of what both parts have."""
    made = {"stage": stage_curves, "field": field_curves, "film": film_curves}[kind]
    one, other = made(a), made(b)
    return [(x, y, scales, [one[x, y, scales], other[x, y, scales]]) for x, y, scales in one if (x, y, scales) in other]


def stage_curves(stage):
    found = {}
    if curves.has_history(stage):
        path = curves.curves_of(curves.Test(stage, None))
        x, words = (
            ("shear_strain", "shear strain, %")
            if "mu" in path
            else ("axial_strain", "axial strain since the first row, %")
        )
        for name, label, factor in (
            ("mu", "$\\mu$", 1),
            ("q_over_p", "$q/p$", 1),
            ("p", "$p$, kPa", 1e3),
            ("volumetric_strain", "volumetric strain, %", 0.01),
        ):
            if name in path and np.ptp(path[x].values) > 1e-5:
                found[words, label, "linear"] = (100 * path[x].values, path[name].values / factor)
    return {**found, **texture_curves(measure(stage.packing))}


def texture_curves(texture):
    """Distributions of forces and stresses, contact orientations and numbers of contacts."""
    found = {}
    for name, label in (
        ("force", "$F_{\\mathrm{n}}/\\langle F_{\\mathrm{n}}\\rangle$"),
        ("sigma_norm", "$\\sigma_{\\mathrm{norm}}$"),
    ):
        if "cumulative" in texture.get(name, {}):
            found[label, "fraction above", "log"] = tuple(np.array(texture[name]["cumulative"][axis]) for axis in "xy")
    sectors = np.array(texture.get("fabric", {}).get("sectors", []), float)
    if sectors.sum() > 0:
        found["contact orientation, °", "fraction over isotropic", "linear"] = (
            180 * (np.arange(len(sectors)) + 0.5) / len(sectors),
            sectors / sectors.mean(),
        )
    histogram = np.array(texture.get("coordination", {}).get("histogram", []))
    if len(histogram) > 1:
        found["contacts per grain", "fraction of grains", "linear"] = (np.arange(len(histogram)), histogram)
    return found


def field_curves(field):
    found = {}
    if len(field.curve.get("strain", [])) > 1:
        found["strain, $10^{-3}$", "stress, MPa", "linear"] = (
            1e3 * field.curve["strain"],
            1e-6 * field.curve["stress"],
        )
    if field.loaded:
        statistics = field.statistics()
        for name, about in statistics.get("components", statistics).items():
            pdf = about["sets"]["all"].get("pdf") if isinstance(about, dict) and "sets" in about else None
            if pdf:
                found[f"{name} over its {about['normalised_by']}", "probability density", "log"] = tuple(
                    np.array(pdf[axis]) for axis in "xy"
                )
    for kind in ("pores", "voids"):
        pdf = field.numbers.get(kind, {}).get("pdf")
        if pdf and not field.loaded:
            edge = np.array(pdf["edge"])
            found[f"area of {kind} over that of a large grain", "probability density", "log log"] = (
                np.sqrt(edge[1:] * edge[:-1]),
                np.array(pdf["density"]),
            )
    return found


def film_curves(film):
    return texture_curves(measure(film.packing, sigma_hyd=film.sigma_hyd)) if len(film.sigma_hyd) > 0 else {}


def picture(drawn, columns=3):
    """A data URI of panels (part, x label, y label, scales, curves)."""
    from matplotlib.figure import Figure

    from .figures.style import colours, journal_style, plain

    with journal_style(**{"svg.fonttype": "path"}):
        across = -(-len(drawn) // columns)
        canvas = Figure(figsize=(2.9 * columns, 2.4 * across), layout="constrained")
        for k, (part, x_label, y_label, scales, both) in enumerate(drawn):
            axes = canvas.add_subplot(across, columns, k + 1)
            for letter, colour, (x, y) in zip("AB", colours, both):
                seen = np.isfinite(y) & ((y > 0) | (scales == "linear"))
                width = 2.0 if letter == "A" else 0.9  # equal ones are both seen
                axes.plot(x[seen], y[seen], color=colour, label=letter, linewidth=width)
            axes.set(
                title=plain(part),
                xlabel=x_label,
                ylabel=y_label,
                xscale="log" if scales == "log log" else "linear",
                yscale="linear" if scales == "linear" else "log",
            )
            axes.legend()
        store = io.BytesIO()
        canvas.savefig(store, format="svg", metadata={"Date": None})
    return f"data:image/svg+xml;base64,{base64.b64encode(store.getvalue()).decode()}"
