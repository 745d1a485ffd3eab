"""The page of `arenite compare`: the program's page with its figures, each with the curves of both results."""

from . import _core, compare

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
    """What one asks first, of the parts one after the other."""
    first = [row for row in found if row.words]
    several = len({row.part for row in first}) > 1
    rows = [cells(row, f"{row.part}: {row.words}" if several else row.words) for row in first]
    return [{"title": "First numbers", "heads": ["", *columns], "rows": rows}] * bool(first)


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
            if figure := _core._compared(head, *(part.get(head["id"], []) for part in drawn)):
                found.append(figure)
    return found


def drawable(part):
    return compare.is_of_the_library(part) and (part[0] != "stage" or len(part[3].snapshots) > 0)


def shown_of(part):
    """{id: drawings} of the last state of a stage, of a field, a sample in space or a film."""
    of, stages = part[3:]
    if isinstance(of, _core.Stage):
        return _core._figures_of_state(of, of.snapshots[-1], [of], stages)
    return _core._figures_of_part(of)
