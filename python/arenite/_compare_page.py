"""The page of `arenite compare`: the program's page with its figures, each with the curves of both results."""

from . import _core, compare

colours = {"A": "line 0", "B": "line 1"}
prefixes = {"G": 1e9, "M": 1e6, "k": 1e3, "": 1.0, "m": 1e-3, "µ": 1e-6, "n": 1e-9}
columns = ["A", "B", "B − A", "standard errors", ""]


def page(a, b, names):
    """HTML of two results called `names`."""
    found, pairs = compare.rows(a, b), compare.pairs_of(a, b)
    about = [f"{letter}: {name}" for letter, name in zip("AB", names)]
    return _core._page_of_figures(
        {
            "title": " and ".join(names),
            "runs": f"{'; '.join(about)}. {compare.summary(found)}",
            "made": f"Arenite {_core.__version__}",
            "notation": _core._notation,
            "first": first_tables(found),
            "figures": figures(pairs),
            "tables": [settings(pairs), *(numbers_of(name, found) for name, *_ in pairs)],
        }
    )


def cells(row, name):
    return {
        "cells": [
            name,
            compare.with_error(row.a, row.a_error),
            compare.with_error(row.b, row.b_error),
            compare.number(row.difference),
            compare.in_errors(row),
            row.verdict,
        ],
        "marked": row.verdict == compare.beyond,
    }


def first_tables(found):
    """What one asks of the tests first."""
    first = [row for row in found if row.words]
    return [{"title": "Tests", "heads": ["", *columns], "rows": [cells(row, row.words) for row in first]}] * bool(first)


def numbers_of(part, found):
    """All numbers of a part, those beyond their errors first."""
    rows = [row for row in found if row.part == part]
    marked = [cells(row, row.name) for row in rows if row.verdict == compare.beyond]
    others = [cells(row, row.name) for row in rows if row.verdict != compare.beyond]
    return {
        "title": part,
        "heads": ["number", *columns],
        "rows": marked,
        "more": others,
        "caption": f"{len(marked)} of {len(rows)} numbers are beyond their errors.",
    }


def settings(pairs):
    """Keys that differ between the recipes of the last parts compared."""
    one, other = (recipe_of(part[3]) for part in pairs[-1][1:])
    keys = [key for key in {**one, **other} if one.get(key) != other.get(key)]
    return {
        "title": "Settings that differ",
        "heads": ["key", "A", "B"],
        "rows": [{"cells": [key, one.get(key, "–"), other.get(key, "–")]} for key in keys],
        "caption": "" if keys else "No setting differs.",
    }


def recipe_of(part):
    """{key: value} of the recipe of a part, as this version reads it; {} if the part has none."""
    return dict(_core.settings(part.provenance.get("recipe", ""))) if hasattr(part, "provenance") else {}


def figures(pairs):
    """What the page shows of the last part of each kind, with both results in one drawing."""
    last = {one[0]: (one, other) for _, one, other in pairs if drawable(one) and drawable(other)}
    found = []
    for kind, (one, other) in last.items():
        drawn = [shown_of(part) for part in (one, other)]
        for head in _core._figure_heads()[kind]:
            drawing = together(*(part.get(head["id"]) for part in drawn))
            if drawing:
                found.append({**head, "caption": head["caption"].split(". ")[0], "drawing": drawing})
    return found


def drawable(part):
    """Whether the library describes figures of it."""
    return isinstance(part[3], (_core.Stage, _core.Field, _core.FilmResult)) and (
        part[0] != "stage" or len(part[3].snapshots) > 0
    )


def shown_of(part):
    """{id: drawings} of the last state of a stage, of a field or a film."""
    of, stages = part[3:]
    if isinstance(of, _core.Stage):
        return _core._figures_of_state(of, of.snapshots[-1], [of], stages)
    return (_core._figures_of_field if isinstance(of, _core.Field) else _core._figures_of_film)(of)


def together(one, other):
    """The first drawings of a figure with the series of both in each panel; None if there are no panels of one kind."""
    if not one or not other:
        return None
    both = [one[0].get("panels", []), other[0].get("panels", [])]
    panels = [joined(*pair) for pair in zip(*both)]
    if not panels or None in panels or len(both[0]) != len(both[1]):
        return None
    return {"panels": panels, "key": [{"name": letter, "colour": colour} for letter, colour in colours.items()]}


def joined(one, other):
    """A panel with the series of both that the pointer reads, in the units of the first; None for other axes."""
    panel = {"x": dict(one["x"]), "y": dict(one["y"]), "near": True, "series": []}
    for axis in "xy":
        if one[axis].get("label") != other[axis].get("label") or "names" in one[axis]:
            return None
    for letter, part in zip("AB", (one, other)):
        scale = {axis: factor(part[axis].get("unit", ""), panel[axis].get("unit", "")) for axis in "xy"}
        panel["series"] += [
            {**scaled(series, scale), "name": letter, "colour": colours[letter]}
            for series in part["series"]
            if "silent" not in series
        ]
    for axis in "xy":
        scale = factor(other[axis].get("unit", ""), panel[axis].get("unit", ""))
        for end, outer in (("low", min), ("high", max)):
            if end in one[axis] and end in other[axis]:
                panel[axis][end] = outer(one[axis][end], scale * other[axis][end])
            else:
                panel[axis].pop(end, None)
    return panel


def factor(unit, wanted):
    """From one prefix of a unit to another: kPa to MPa."""
    for prefix, power in prefixes.items():
        for other, of_other in prefixes.items():
            if unit == prefix + wanted[len(other) :] and wanted.startswith(other):
                return power / of_other
    return 1.0


def scaled(series, scale):
    def times(values, by):
        return values if by == 1 else [None if value is None else by * value for value in values]

    of = {"x": "x", "y": "y", "error": "y", "low": "y", "high": "y"}
    return {name: times(value, scale[of[name]]) if name in of else value for name, value in series.items()}
