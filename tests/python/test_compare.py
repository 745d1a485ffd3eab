"""Two results side by side: numbers, verdicts, table and page."""

import csv
import json
import math
import os
import re
import subprocess
import types
import warnings

import arenite
import pytest
from arenite import _core, compare


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
    return types.SimpleNamespace(stages=[stage], fields=[], films=[], voxels=[], spheres=[], path="", title=title)


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
        "pdf": {"x": [1, 2, 3, 4, 5], "y": [3, 4, 5, 6, 7]},
        "provenance": {"seed": 1},
    }
    found = _core._flat_numbers(tree)
    assert (
        found["z"] == (3, 0.1)
        and found["phi.1.0"] == (3, 0.3)
        and found["list.1"][0] == 8
        and math.isnan(found["count"][1])
    )
    assert set(found) == {"z", "phi.0.0", "phi.0.1", "phi.1.0", "phi.1.1", "list.0", "list.1", "count", "ok"}


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
    assert compare.Row("load", "fabric.theta_c_deg", 179, 5, 1, 5, period=180).difference == pytest.approx(2)
    assert compare.Row("load", "fabric.modes.6.phase_deg", 59, 5, 1, 5, period=60).difference == pytest.approx(2)
    assert compare.Row("load", "motion_deg", 179, 5, 1, 5).difference == -178


def test_directions_say_their_periods(result, tmp_path):
    def periods(of):
        return {row.name: row.period for row in compare.rows(of, of) if row.period}

    found = periods(result)
    assert found["fabric.theta_c_deg"] == found["fabric.load_axis_deg"] == 180
    assert found["fabric.modes.4.phase_deg"] == 90 and found["fabric.modes.6.phase_deg"] == 60
    assert not [name for name in found if not name.endswith("_deg")]
    arenite.save(arenite.open(result.path), tmp_path)
    assert periods(str(tmp_path)) == found


def test_parts_are_paired_by_name_and_others_by_their_place():
    one, other = a_result({"z": measured(3.0, 0.1)}), a_result({"z": measured(4.0, 0.1)}, "press")
    assert [name for name, *_ in compare.pairs_of(one, other)] == ["load / press"]
    (row,) = compare.rows(one, other)
    assert (row.part, row.name, row.difference) == ("load / press", "z", 1) and row.error == pytest.approx(0.02**0.5)
    nothing = types.SimpleNamespace(stages=[], fields=[], films=[], voxels=[], spheres=[])
    with pytest.raises(ValueError, match="nothing in common: one holds load, the other nothing measured"):
        compare.pairs_of(one, nothing)


def test_the_table_says_what_is_beyond(tmp_path):
    found = compare.rows(a_result({"z": measured(3.0, 0.1), "n": 5}), a_result({"z": measured(4.0, 0.1), "n": 6}))
    assert "1 of 1 numbers" in compare.summary(found) and "1 differ but have no error" in compare.summary(found)
    assert re.search(r"z +3.00 ± 0.10 +4.00 ± 0.10 +1 +\+7.1 +beyond errors", compare.text_table(found))
    compare.save_table(found, tmp_path / "t.csv")
    with open(tmp_path / "t.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert (
        [row["name"] for row in rows] == ["z", "n"] and float(rows[0]["difference"]) == 1 and rows[1]["a_error"] == ""
    )


def document_of(path):
    page = path.read_text(encoding="utf-8")
    assert not re.search(r'(src|href)="(?!data:)', page)
    return json.loads(page.split('id="figures">')[1].split("</script>")[0])


def test_the_page_says_which_settings_differ_and_marks_what_is_beyond(tmp_path):
    one = a_result({"z": measured(3.0, 0.1), "n": 5}, title="dense <1>")
    other = a_result({"z": measured(4.0, 0.1), "n": 6}, title="loose")
    document = document_of(
        compare.save_page(one, other, tmp_path / "deep" / "page.html", ["first </script>", "second"])
    )
    assert document["title"] == "first </script> and second"
    settings, load = document["tables"]
    assert ["contact.friction", "0.9", "0.5"] in [row["cells"] for row in settings["rows"]]
    assert [row["cells"][0] for row in load["rows"]] == ["z"] and load["rows"][0]["marked"]
    assert [row["cells"][0] for row in load["more"]] == ["n"]


def test_numbers_of_the_only_material_are_not_said_twice():
    texture = {
        "coordination": {"all": measured(2.33, 0.1), "glass-glass": measured(2.33, 0.1)},
        "grains": 200,
        "considered": {"grains": 200, "walls": 200},
    }
    names = [row.name for row in compare.rows(a_result(texture), a_result(texture))]
    assert names == ["coordination.all", "grains", "considered.walls"]


def test_figures_hold_both_in_the_units_of_the_first():
    def panel(unit, high):
        series = [{"x": [1, 2], "y": [3, None], "colour": "strong"}, {"x": [0], "y": [0], "silent": True}]
        return {"panels": [{"x": {"label": "t"}, "y": {"label": "p", "unit": unit, "high": high}, "series": series}]}

    head = {"id": "p", "caption": "At 1. 2 m of water. Of one alone.", "shown": "At 1. 2 m of water."}
    figure = _core._compared(head, [panel("kPa", 5)], [panel("MPa", 4)])
    (shown,) = figure["drawing"]["panels"]
    assert figure["caption"] == head["shown"]
    assert [(series["name"], series["y"]) for series in shown["series"]] == [("A", [3, None]), ("B", [3000, None])]
    assert shown["y"]["high"] == 4000
    assert _core._compared(head, [panel("kPa", 5)], []) == {}


def test_a_result_compared_with_itself_has_its_figures_and_no_difference(result, tmp_path):
    found = compare.rows(result, result)
    assert {row.verdict for row in found} <= {compare.equal, compare.alone} and len(found) > 50
    words = {row.words for row in found}
    assert {"coordination z", "grains ρ_{p}", "apparent modulus E"} <= words, words  # as tiles of the page have them
    document = document_of(compare.save_page(result, result, tmp_path / "page.html"))
    shown = {figure["id"]: figure["drawing"] for figure in document["figures"]}
    assert "contact-numbers" in shown, list(shown)
    for drawing in shown.values():
        for panel in drawing["panels"]:
            by_name = {letter: [s["y"] for s in panel["series"] if s["name"] == letter] for letter in ("A", "B")}
            assert by_name["A"] == by_name["B"]


def test_tests_begin_with_what_one_asks_of_them(tmp_path):
    recipe = subprocess.run([os.environ["ARENITE"], "init", "shear"], capture_output=True, text=True, check=True).stdout
    recipe = recipe.replace("24*d", "8*d").replace("count = 500", "count = 60").replace("I = 0.01", "I = 0.3")
    (tmp_path / "shear.toml").write_text(recipe)
    for friction in ("0.1", "0.5"):
        subprocess.run(
            [os.environ["ARENITE"], "run", "shear.toml", "--set", f"contact.friction={friction}", "--out", friction]
            + ["--quiet"],
            cwd=tmp_path,
            check=True,
            capture_output=True,
        )
    one, other = str(tmp_path / "0.1"), str(tmp_path / "0.5")
    words = [row.words for row in compare.rows(one, other) if row.words]
    assert "peak μ" in words and words.count("peak μ") == 1
    document = document_of(compare.save_page(one, other, tmp_path / "cmp.html"))
    named = [row["cells"][0] for row in document["first"][0]["rows"]]
    assert named[0] == f"packing: {words[0]}" and any(name == "shear: peak μ" for name in named)
    assert len(set(named)) == len(named)
    curve = document["figures"][0]["drawing"]["panels"][0]
    assert {series["name"] for series in curve["series"]} == {"A", "B"} and "strain" in curve["x"]["label"]
    packing = arenite.open(one).stages[-1].snapshots[-1].packing
    with pytest.warns(UserWarning, match="give tilt_rate"):
        arenite.coarse_grained(packing, "30 mm")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        arenite.coarse_grained(packing, "30 mm", tilt_rate=0.1)


def test_the_command_prints_and_writes(result, tmp_path, capsys):
    assert compare.main(result.path, result.path, str(tmp_path / "page.html"), str(tmp_path / "t.csv")) == 0
    assert "0 of 0 numbers" in capsys.readouterr().out and (tmp_path / "t.csv").exists()
    assert compare.main(result.path, str(tmp_path)) == 2
    assert capsys.readouterr().err.count("\n") == 1
    assert compare.main(result.path, result.path, str(tmp_path / "page")) == 2
    assert "ends in .html" in capsys.readouterr().err
