"""Two results side by side: `rows(a, b)`, `save_page(a, b, "compare.html")`, or `python3 -m arenite.compare A B`.

Every number of both, with its standard error if the result has one. A difference is significant beyond two of its
standard errors; differences of numbers without errors are listed but not judged.
"""

import csv
import dataclasses
import math
import os
import pathlib
import re

from ._core import open as open_result
from ._said import carry_out, said, tell
from ._written import written_whole

beyond, within, equal, unjudged, alone = "beyond errors", "within errors", "equal", "no errors given", "in one only"
sure = 2  # standard errors of the difference


@dataclasses.dataclass
class Row:
    """A number of both results: `part` is the stage, sample, load or film, `name` its path with dots; NaN where one has
    none."""

    part: str
    name: str
    a: float
    a_error: float
    b: float
    b_error: float

    @property
    def difference(self):
        """b - a; the shorter difference for angles."""
        turn = turn_of(self.name)
        return (self.b - self.a + turn / 2) % turn - turn / 2 if turn else self.b - self.a

    @property
    def error(self):
        """Standard error of the difference; that of one of the two if the other has none, NaN if neither has."""
        known = [e for e in (self.a_error, self.b_error) if not math.isnan(e)]
        return math.hypot(*known) if known else math.nan

    @property
    def verdict(self):
        if math.isnan(self.a) or math.isnan(self.b):
            return alone
        if self.a == self.b:
            return equal
        if not self.error > 0:
            return unjudged
        return beyond if abs(self.difference) > sure * self.error else within


def turn_of(name):
    """Period of an angle in degrees: half a turn for axes, an n-th of a turn for n-fold symmetry; None for other
    numbers."""
    folds = re.search(r"modes\.(\d+)\.phase_deg$", name)
    if folds:
        return 360 / int(folds[1])
    return 180 if re.search(r"(theta_\w*|axis\w*)_deg$", name) else None


def parts_of(result):
    """[(kind, name, numbers, part)]: texture of every stage, numbers of every sample, load and film."""
    found = [("stage", part.name, part.texture, part) for part in result.stages if len(part.texture) > 0]
    return found + [
        (kind, part.name, part.numbers, part)
        for kind, parts in (("field", result.fields), ("film", result.films))
        for part in parts
    ]


def pairs_of(a, b):
    """[(name, part of a, part of b)], as parts_of gives them: parts of the same name, otherwise the last of each kind.
    Raises ValueError if the two have nothing in common."""
    parts, others = parts_of(a), parts_of(b)
    pairs = [(one[1], one, other) for one in parts for other in others if one[:2] == other[:2]]
    for kind in ("stage", "field", "film"):
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


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def flattened(numbers, path=""):
    """{"coordination.all": (value, error)} of a tree of numbers; NaN for an unknown error. Items of lists are counted
    from 0; densities and other curves (groups of lists) are left to the figure."""
    if is_number(numbers):
        return {path: (float(numbers), math.nan)}
    if isinstance(numbers, dict) and is_curve(numbers):
        return {}
    if isinstance(numbers, (list, tuple)):
        numbers = dict(enumerate(numbers))
    if not isinstance(numbers, dict):
        return {}
    if "value" in numbers:
        values, errors = flattened(numbers["value"], path), flattened(numbers.get("error"), path)
        return {name: (value, errors.get(name, (math.nan,))[0]) for name, (value, _) in values.items()}
    found = {}
    for name, value in numbers.items():
        if name != "provenance":
            found.update(flattened(value, f"{path}.{name}" if path else str(name)))
    return found


def is_curve(numbers):
    lists = [
        value
        for value in numbers.values()
        if isinstance(value, (list, tuple)) and all(is_number(v) or v is None for v in value)
    ]
    return len(lists) > 1 and "value" not in numbers


def rows(a, b):
    """[Row] of all numbers of two results (Results or paths), part after part. Raises ValueError if they have no part
    in common."""
    found = []
    for name, one, other in pairs_of(opened(a), opened(b)):
        left, right = flattened(one[2]), flattened(other[2])
        unknown = (math.nan, math.nan)
        found += [Row(name, key, *left.get(key, unknown), *right.get(key, unknown)) for key in {**left, **right}]
    return found


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
        f"{counts[beyond]} of {known} numbers with errors that differ are beyond {sure} standard errors of the "
        "difference"
    )
    if known:
        text += (
            f"; equal samples would give about {max(1, round(0.0455 * known))}, and numbers of one sample are "
            "correlated"
        )
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
            r.name,
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
    return "-" if math.isnan(value) else f"{value:.4g}"


def with_error(value, error):
    return number(value) if math.isnan(error) or math.isnan(value) else f"{value:.4g} ± {error:.2g}"


def in_errors(row):
    """The difference over its error."""
    return f"{row.difference / row.error:+.1f}" if row.error > 0 and not math.isnan(row.difference) else ""


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
    """A self-contained page: the summary, the curves of both in one figure, and the table. `names` of the two results;
    their paths if not given. Returns the path."""
    from ._compare_page import page

    one, other = opened(a), opened(b)
    path = pathlib.Path(path)
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
    except ImportError as error:
        return said(f"the page's curves need Matplotlib (Debian: apt-get install python3-matplotlib): {error}")
    except OSError as error:
        return said(
            f"{error.filename or out}: cannot be written ({error.strerror or error}); choose another file with --out "
            "or --csv"
        )
    shown = found if all else [row for row in found if row.verdict == beyond]
    if shown:
        tell(text_table(shown))
    tell(summary(found))
    tell(f"page:    {written}   (open it in a browser)")
    return 0


if __name__ == "__main__":
    carry_out(main)
