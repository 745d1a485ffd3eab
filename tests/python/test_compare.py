"""Two results side by side: numbers, verdicts, table and page."""

import csv
import math
import re
import types

import arenite
import pytest
from arenite import _compare_page, compare


def a_result(texture, name="load", title="a sample"):
    packing = arenite.Packing([1, 2, 3], [1, 1, 1], [0.5, 0.5, 0.5], width=4, height=2)
    stage = types.SimpleNamespace(
        name=name,
        texture=texture,
        packing=packing,
        history={},
        snapshots=[],
        provenance={"recipe": f'title = "{title}"\n[contact]\nfriction = 0.{len(title)}\n'},
    )
    return types.SimpleNamespace(stages=[stage], fields=[], films=[], path="", title=title)


def measured(value, error=None):
    return {"value": value, "error": error}


def test_a_tree_becomes_numbers_with_their_errors():
    tree = {
        "z": measured(3.0, 0.1),
        "phi": measured([[1, 2], [3, 4]], [[0.1, 0.2], [0.3, 0.4]]),
        "list": [7, 8],
        "count": 5,
        "ok": True,
        "text": "x",
        "none": None,
        "pdf": {"x": [1, 2], "y": [3, 4]},
        "provenance": {"seed": 1},
    }
    found = compare.flattened(tree)
    assert (
        found["z"] == (3, 0.1)
        and found["phi.1.0"] == (3, 0.3)
        and found["list.1"][0] == 8
        and math.isnan(found["count"][1])
    )
    assert set(found) == {"z", "phi.0.0", "phi.0.1", "phi.1.0", "phi.1.1", "list.0", "list.1", "count"}


def test_differences_count_beyond_two_standard_errors():
    def verdict(*numbers):
        return compare.Row("load", "z", *numbers).verdict

    assert verdict(1.0, 0.3, 2.01, 0.4) == compare.beyond and verdict(1.0, 0.3, 1.99, 0.4) == compare.within
    assert (
        verdict(1.0, 0.3, 2.0, math.nan) == compare.beyond and verdict(1.0, math.nan, 2.0, math.nan) == compare.unjudged
    )
    assert verdict(1.0, 0.0, 2.0, 0.0) == compare.unjudged and verdict(1.0, math.nan, 1.0, math.nan) == compare.equal
    assert verdict(1.0, 0.1, math.nan, math.nan) == compare.alone


def test_directions_differ_by_the_shorter_way():
    assert compare.Row("load", "fabric.theta_c_deg", 179, 5, 1, 5).difference == pytest.approx(2)
    assert compare.Row("load", "fabric.modes.6.phase_deg", 59, 5, 1, 5).difference == pytest.approx(2)
    assert compare.Row("load", "motion_deg", 179, 5, 1, 5).difference == -178


def test_parts_are_paired_by_name_and_others_by_their_place():
    one, other = a_result({"z": measured(3.0, 0.1)}), a_result({"z": measured(4.0, 0.1)}, "press")
    assert [name for name, *_ in compare.pairs_of(one, other)] == ["load / press"]
    (row,) = compare.rows(one, other)
    assert (row.part, row.name, row.difference) == ("load / press", "z", 1) and row.error == pytest.approx(0.02**0.5)
    nothing = types.SimpleNamespace(stages=[], fields=[], films=[])
    with pytest.raises(ValueError, match="nothing in common: one holds load, the other nothing measured"):
        compare.pairs_of(one, nothing)


def test_the_table_says_what_is_beyond(tmp_path):
    found = compare.rows(a_result({"z": measured(3.0, 0.1), "n": 5}), a_result({"z": measured(4.0, 0.1), "n": 6}))
    assert "1 of 1 numbers" in compare.summary(found) and "1 differ but have no error" in compare.summary(found)
    assert re.search(r"z +3 ± 0.1 +4 ± 0.1 +1 +\+7.1 +beyond errors", compare.text_table(found))
    compare.save_table(found, tmp_path / "t.csv")
    with open(tmp_path / "t.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert (
        [row["name"] for row in rows] == ["z", "n"] and float(rows[0]["difference"]) == 1 and rows[1]["a_error"] == ""
    )


def test_the_page_needs_no_other_file(tmp_path):
    one, other = a_result({"z": measured(3.0, 0.1)}, title="dense <1>"), a_result(
        {"z": measured(4.0, 0.1)}, title="loose"
    )
    path = compare.save_page(one, other, tmp_path / "deep" / "page.html", ["first", "second"])
    page = path.read_text(encoding="utf-8")
    assert (
        "dense &lt;1&gt;" in page
        and "<1>" not in page
        and "Settings that differ" in page
        and "contact.friction" in page
    )
    assert not re.search(r'(src|href)="(?!data:)', page) and 'class="beyond"' in page


def test_curves_of_both_are_drawn(result, tmp_path):
    pairs = compare.pairs_of(result, result)
    labels = [panel[:2] for name, one, other in pairs for panel in _compare_page.panels(one[0], one[3], other[3])]
    assert ("contacts per grain", "fraction of grains") in labels and any(y == "probability density" for _, y in labels)
    found = compare.rows(result, result)
    assert {row.verdict for row in found} <= {compare.equal, compare.alone} and len(found) > 100
    assert "data:image/svg+xml" in compare.save_page(result, result, tmp_path / "page.html").read_text(encoding="utf-8")


def test_the_command_prints_and_writes(result, tmp_path, capsys):
    assert compare.main(result.path, result.path, str(tmp_path / "page.html"), str(tmp_path / "t.csv")) == 0
    assert "0 of 0 numbers" in capsys.readouterr().out and (tmp_path / "t.csv").exists()
    assert compare.main(result.path, str(tmp_path)) == 2
    assert capsys.readouterr().err.count("\n") == 1
