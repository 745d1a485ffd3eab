"""Two results side by side: `rows(a, b)`, `save_page(a, b, "compare.html")`, or `python3 -m arenite.compare A B`.

What one asks first (peak and critical state, strength, stresses in grains), then every number of both, with
its standard error if the result has one. A difference is significant beyond two of its standard errors; differences of
numbers without errors are listed but not judged. The numbers are the library's.
"""

import csv
import dataclasses
import functools
import math
import os
import pathlib

from . import _core
from ._core import open as open_result
from ._said import carry_out, said, tell
from ._written import written_whole

beyond, within, equal, unjudged, alone = _core._verdicts
sure = _core._least_told  # standard errors of the difference


@dataclasses.dataclass
class Row:
    """A number of both results: `part` is the stage, sample, load or film, `name` its path with dots; NaN where one has
    none. `words` of what one asks first, `period` of an angle, degrees."""

    part: str
    name: str
    a: float
    a_error: float
    b: float
    b_error: float
    words: str = ""
    period: float = 0.0

    @property
    def difference(self):
        """b - a; the shorter difference for angles."""
        return self._told[0]

    @property
    def error(self):
        """Standard error of the difference; that of one of the two if the other has none, NaN if neither has."""
        return self._told[1]

    @property
    def in_errors(self):
        """The difference over its error; NaN where one of them is not known."""
        return self._told[2]

    @property
    def verdict(self):
        return self._told[3]

    @functools.cached_property
    def _told(self):
        return _core._difference(self.a, self.a_error, self.b, self.b_error, self.period)


classes = {
    "stage": _core.Stage,
    "field": _core.Field,
    "voxels": _core.VoxelResult,
    "spheres": _core.SphereStage,
    "film": _core.FilmResult,
}


def is_of_the_library(part):
    """Whether the library describes what a part shows; else it is an object of somebody's own with numbers."""
    return isinstance(part[3], classes[part[0]])


def parts_of(result):
    """[(kind, name, numbers, part, stages of the result)]: every stage, sample, load and film with its numbers."""
    stages = list(result.stages)
    found = [
        ("stage", part.name, {**part.texture, **test_of(part, stages[:k])["numbers"]}, part, stages)
        for k, part in enumerate(stages)
        if len(part.texture) > 0
    ]
    return found + [
        (kind, part.name, part.numbers, part, stages)
        for kind, parts in (
            ("field", result.fields),
            ("voxels", result.voxels),
            ("spheres", result.spheres),
            ("film", result.films),
        )
        for part in parts
    ]


def test_of(stage, earlier):
    """What a stage says as a test, and which of it one asks first; nothing of other objects than stages of results."""
    if not isinstance(stage, classes["stage"]):
        return {"numbers": {}, "headlines": []}
    before = [part.snapshots[-1].packing for part in earlier if len(part.snapshots) > 0]
    return _core._test_of_stage(stage, before[-1] if before else None)


def headlines_of(part):
    """{dotted name: words} of what one asks of a part first."""
    kind, _, _, of, stages = part
    if not is_of_the_library(part):
        return {}
    first = test_of(of, stages[: stages.index(of)]) if kind == "stage" else _core._headlines(of)
    named = [one for one in first["headlines"] if isinstance(one, list)]
    return {name: " ".join(filter(None, [words, symbol])) for words, symbol, name, _ in named}


def pairs_of(a, b):
    """[(name, part of a, part of b)], as parts_of gives them: parts of the same name, otherwise the last of each kind.
    Raises ValueError if the two have nothing in common."""
    parts, others = parts_of(a), parts_of(b)
    pairs = [(one[1], one, other) for one in parts for other in others if one[:2] == other[:2]]
    for kind in classes:
        left, right = (
            [part for part in every if part[0] == kind and not any(part in pair[1:] for pair in pairs)]
            for every in (parts, others)
        )
        if left and right:
            pairs.append((f"{left[-1][1]} / {right[-1][1]}", left[-1], right[-1]))
    if not pairs:
        raise ValueError(f"the results have nothing in common: one holds {listed(parts)}, the other {listed(others)}")
    return pairs


def listed(parts):
    return ", ".join(name for _, name, *_ in parts) or "nothing measured"


def rows(a, b):
    """[Row] of all numbers of two results (Results or paths), part after part, what one asks of a test first before the
    rest. Numbers that only repeat one before them are left out, as those of the only material. Raises ValueError if
    they have no part in common."""
    found, unknown = [], (math.nan, math.nan)
    for name, one, other in pairs_of(opened(a), opened(b)):
        left, right = _core._flat_numbers(one[2]), _core._flat_numbers(other[2])
        words = {**headlines_of(one), **headlines_of(other)}
        periods = {**_core._periods(one[3]), **_core._periods(other[3])}
        names = [key for key in words if key in left or key in right]
        names += [key for key in {**left, **right} if key not in words]
        seen = set()
        for key in names:
            both = (*left.get(key, unknown), *right.get(key, unknown))
            row = Row(name, key, *both, words.get(key, ""), periods.get(key, 0.0))
            if repeated(row) not in seen:
                found.append(row)
            seen.add(repeated(row))
    return found


def repeated(row):
    """Equal for numbers that say the same: whole ones only if their names end alike, because small counts are often
    equal."""
    values = (row.a, row.a_error, row.b, row.b_error)
    if any(math.isnan(value) for value in (row.a, row.b)):
        return row.name
    is_whole = row.a == round(row.a) and row.b == round(row.b)
    digits = tuple(f"{value:.10g}" for value in values)
    return (row.name.rsplit(".", 1)[-1], *digits) if is_whole else digits


def opened(result):
    return open_result(os.fspath(result)) if isinstance(result, (str, os.PathLike)) else result


def counted(found):
    """{verdict: how many rows}."""
    return {
        verdict: sum(row.verdict == verdict for row in found) for verdict in (beyond, within, equal, unjudged, alone)
    }


def summary(found):
    """A summary in a sentence or two, with the number expected by chance, because among many numbers some always
    differ."""
    counts = counted(found)
    known = counts[beyond] + counts[within]
    text = (
        f"{counts[beyond]} of {known} numbers with errors that differ are beyond {sure:g} standard errors of the "
        "difference"
    )
    if known:
        by_chance = max(1, round(_core._beyond_by_chance(known)))
        text += f"; equal samples would give about {by_chance}, and numbers of one sample are correlated"
    return (
        f"{text}. {counts[equal]} are equal, {counts[unjudged]} differ but have no error, {counts[alone]} are in one "
        "result only."
    )


def text_table(found):
    """The rows as text in columns."""
    shown = [("part", "number", "A", "B", "B - A", "standard errors", "")]
    shown += [
        (
            r.part,
            r.words or r.name,
            with_error(r.a, r.a_error),
            with_error(r.b, r.b_error),
            number(r.difference),
            in_errors(r),
            r.verdict,
        )
        for r in found
    ]
    widths = [max(len(row[k]) for row in shown) for k in range(len(shown[0]))]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in shown)


def number(value):
    return "-" if math.isnan(value) else f"{value + 0.0:.4g}"  # -0 is 0


def with_error(value, error):
    return number(value) if math.isnan(value) else _core._with_error(value, error)


def in_errors(row):
    return "" if math.isnan(row.in_errors) else f"{row.in_errors:+.1f}"


def plain(name):
    """A name as a cell that no spreadsheet takes for a formula: behind an apostrophe if it begins like one."""
    return "'" + name if name.startswith(("=", "@", "\t", "\r")) else name


def save_table(found, path):
    """The rows as CSV."""
    with written_whole(path) as beside, open(beside, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(["part", "name", "a", "a_error", "b", "b_error", "difference", "difference_error", "verdict"])
        for row in found:
            cells = (row.a, row.a_error, row.b, row.b_error, row.difference, row.error)
            table.writerow(
                [
                    plain(row.part),
                    plain(row.name),
                    *("" if math.isnan(v) else repr(float(v)) for v in cells),
                    row.verdict,
                ]
            )


def save_page(a, b, path, names=None):
    """A self-contained page in the manner of the results' own: what one asks first, the figures with the curves of
    both, the settings that differ and all numbers. `names` of the two results; their paths if not given. Returns the
    path, which must end in .html; raises ValueError."""
    from ._compare_page import page

    path = pathlib.Path(path)
    if path.suffix not in (".html", ".htm"):
        raise ValueError(f"{path}: give the page a name that ends in .html")
    one, other = opened(a), opened(b)
    path.parent.mkdir(parents=True, exist_ok=True)
    text = page(one, other, names or [name_of(one, a), name_of(other, b)])
    with written_whole(path) as beside:
        beside.write_text(text, encoding="utf-8")
    return path


def name_of(result, given):
    return os.fspath(given) if isinstance(given, (str, os.PathLike)) else result.path or result.title or "a result"


def main(a, b, out="compare.html", csv=None, all=False):
    """Implements `arenite compare`, whose options are declared by the program: prints the differences; status 2 and a
    message on stderr for bad input."""
    try:
        one, other = opened(a), opened(b)
        found = rows(one, other)
        written = save_page(one, other, out, [a, b])
        if csv:
            save_table(found, csv)
    except ValueError as error:
        return said(str(error))
    except OSError as error:
        return said(
            f"{error.filename or out}: cannot be written ({error.strerror or error}); choose another file with --out "
            "or --csv"
        )
    shown = found if all else [row for row in found if row.words or row.verdict == beyond]
    if shown:
        tell(text_table(shown))
    tell(summary(found))
    tell(f"page:    {written}   (open it in a browser)")
    return 0


if __name__ == "__main__":
    carry_out(main)
