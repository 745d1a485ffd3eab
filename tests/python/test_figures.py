"""Figures in print: which there are, their files, and what they say."""

import html
import json
import logging
import os
import pathlib
import re
import subprocess
import sys

import arenite
import arenite.figures as figures
import pytest
from arenite.figures import bonds, catalogue, described, drawing, moving, packings, polar, runs, saving, style

# What the library says of every figure of the page, by kind and id; the names of the journal's.
heads = {(kind, head["id"]): head for kind, all in drawing.heads().items() for head in all if kind != "runs"}
cards = {key: (key[0], head["name"]) for key, head in heads.items()}
# What the page shows in its pictures and not on cards.
pictures = {
    ("stage", "packing"),
    ("stage", "sigma-norm-map"),
    ("stage", "force-network"),
    ("stage", "cracks"),
    ("field", "phases"),
    ("field", "stress"),
    ("field", "displacement"),
    ("field", "cracks"),
    ("film", "maps"),
    ("film", "grains"),
    ("film", "force-network"),
    ("voxels", "phases"),
    ("voxels", "stress"),
    ("voxels", "displacement"),
}
components = {("field", f"stress-pdf-{name}") for name in ("xx", "xy", "hyd")} | {("voxels", "stress-pdf-xz")}


def test_every_figure_that_the_library_lists_is_drawn_by_the_page_and_in_print():
    """The page makes a card for every head that it is given; those that it draws itself must be among them, as
    print's."""
    page = (pathlib.Path(__file__).resolve().parents[2] / "web/src/figures/index.js").read_text()
    own = set(re.findall(r'^  "([a-z-]+)": \w+,$', page, re.M))
    assert own == {*catalogue.stage_pictures, *catalogue.film_pictures} <= {name for _, name in heads}
    assert "describedFigure(head)" in page
    sections = pathlib.Path(__file__).resolve().parents[2].glob("web/src/**/*.js")
    kinds = {kind for path in sections for kind in re.findall(r"about\.figures\.(\w+)\)", path.read_text())}
    assert kinds == {kind for kind, _ in heads} == {figure.kind for figure in figures.figures}
    assert {(figure.kind, figure.name) for figure in figures.figures} == set(cards.values()) | pictures | components


def test_renderers_say_nothing_of_their_own():
    """No titles, captions and units of figures stand in the sources that draw what the library describes."""
    root = pathlib.Path(__file__).resolve().parents[2]
    names = ("described", "panel", "roses", "hemispheres", "outlines", "cells", "index")
    sources = [root / "web/src/figures" / f"{name}.js" for name in names] + [root / "web/src/study/figure.js"]
    modules = (drawing, described, polar, runs, moving)
    text = "".join(path.read_text() for path in (*sources, *(pathlib.Path(one.__file__) for one in modules)))
    for head in heads.values():
        assert head["title"] not in text or head["title"] == "Grains", head["id"]
        assert head["caption"] not in text
    assert not re.search(r'label="[a-z]|_caption|xlabel="', text)


def test_a_file_holds_its_title_and_caption(result, tmp_path):
    (path,) = figures.save_all(result, tmp_path, "svg", "coordination")
    content = html.unescape(path.read_text())
    assert "Coordination number z" in content and heads["stage", "coordination"]["caption"] in content


@pytest.fixture(scope="module")
def drawn(result, tmp_path_factory):
    """All figures of a run."""
    return figures.save_all(result, tmp_path_factory.mktemp("figures"), ("pdf", "svg"))


def test_every_figure_of_a_run_is_drawn_and_embeds_its_fonts(drawn):
    stage = {name for kind, name in set(cards.values()) | pictures if kind == "stage"} - {
        "stress-path",
        "cycles",
        "stress-strain",
        "discharge",
        "collapse",
        "surface-angle",
        "size-curve",
        "broken-bonds",
        "boundary-forces",
        "cracks",
    }
    field = {"stress", "displacement", "stress-pdf", "convergence"}
    expected = (
        {f"rest-{name}" for name in stage}
        | {"cement-phases", "cement-cavities"}
        | {f"tension-{name}" for name in field}
    )
    assert {p.stem for p in drawn} - {f"tension-{name}" for _, name in components} - {"rest-stress-path"} == expected
    for path in drawn:
        content = path.read_bytes()
        assert len(content) > 2000
        if path.suffix == ".pdf":
            assert content.startswith(b"%PDF") and (b"/FontFile2" in content or b"/Type /Font" not in content)
        else:
            assert not re.search("[\ue000-\uf8ff]", html.unescape(content.decode()))  # letters that only one font has


def test_formulas_in_an_svg_are_the_letters_that_are_meant(result, tmp_path):
    (path,) = figures.save_all(result, tmp_path, "svg", "sigma-norm")
    letters = "".join(re.findall(r"<tspan[^>]*>([^<]*)<", html.unescape(path.read_text())))
    assert "σ" in letters and "β" in letters and "norm" in letters


def test_former_names_of_figures_are_read_with_a_notice(result, tmp_path):
    with pytest.warns(FutureWarning, match="contact-directions is now called contact-orientations"):
        (path,) = figures.save_all(result, tmp_path, "svg", "contact-directions")
    assert path.stem == "rest-contact-orientations"


def test_the_same_result_gives_the_same_bytes(result, drawn, tmp_path):
    again = figures.save_all(
        result, tmp_path, ("pdf", "svg"), ["force-network", "contact-orientations", "cavities", "stress-pdf"]
    )
    first = {path.name: path for path in drawn}
    assert len(again) == 8 and all(path.read_bytes() == first[path.name].read_bytes() for path in again)


def test_widths_are_those_of_columns(result, tmp_path):
    (one,) = figures.save_all(result, tmp_path, ("svg",), ["coordination"])
    width = float(re.search(r'<svg [^>]*width="([\d.]+)pt"', one.read_text())[1])
    assert width / 72 * 25.4 == pytest.approx(85, abs=1e-4)  # mm


def test_the_command_draws(result, tmp_path):
    run = subprocess.run(
        [
            os.environ["ARENITE"],
            "figures",
            result.path,
            "--out",
            str(tmp_path),
            "--format",
            "png",
            "--only",
            "packing",
            "--width",
            "60 mm",
        ],
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stderr
    assert (tmp_path / "rest-packing.png").exists()


def test_files_of_the_current_folder_are_not_run(result, tmp_path):
    for name in ("json", "sitecustomize", "usercustomize", "re"):
        (tmp_path / f"{name}.py").write_text("import pathlib\npathlib.Path('ran').touch()\n")
    environment = {**os.environ, "PYTHONPATH": ":"}  # as PYTHONPATH=$PYTHONPATH: leaves it
    for line in (
        ["figures", result.path, "--out", "f", "--format", "png", "--only", "packing"],
        ["compare", result.path, result.path, "--out", "c.html"],
    ):
        run = subprocess.run(
            [os.environ["ARENITE"], *line], cwd=tmp_path, capture_output=True, text=True, env=environment
        )
        assert run.returncode == 0, run.stderr
    assert not (tmp_path / "ran").exists()


def test_files_are_whole_or_not_there(result, tmp_path):
    (tmp_path / "compare.html").write_text("before")
    for line in (
        f"figures {result.path} --out {tmp_path} --format png --only packing",
        f"compare {result.path} {result.path} --out {tmp_path}/compare.html",
    ):
        run = subprocess.run(
            ["bash", "-c", f"ulimit -f 1; exec {os.environ['ARENITE']} {line}"], capture_output=True, text=True
        )
        assert run.returncode == 2 and run.stderr.count("\n") == 1 and "cannot be written" in run.stderr, run.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["compare.html"] and (
        tmp_path / "compare.html"
    ).read_text() == "before"
    full = subprocess.run(
        [
            "bash",
            "-c",
            f"exec {os.environ['ARENITE']} compare {result.path} {result.path} --out {tmp_path}/c.html > /dev/full",
        ],
        capture_output=True,
        text=True,
    )
    assert full.returncode == 2 and full.stderr.count("\n") == 1, full.stderr


def test_names_are_no_formulas(tmp_path):
    packing = arenite.Packing(
        [1e-3, 3e-3],
        [1e-3, 1e-3],
        [1e-3, 1e-3],
        width=4e-3,
        height=2e-3,
        material=[0, 1],
        materials=[arenite.Material("$_{$"), arenite.Material("$a")],
    )
    figure = catalogue.Figure("key", "stage", lambda canvas, part: packings.material_key(canvas.add_subplot(), part))
    saving.save(figure, packing, tmp_path / "key.svg")
    assert (tmp_path / "key.svg").stat().st_size > 0


def test_bad_requests_are_refused_in_one_sentence(result, tmp_path):
    with pytest.raises(ValueError, match="no figure nothing; there are packing, "):
        figures.save_all(result, tmp_path, names=["nothing"])
    with pytest.raises(ValueError, match="this result has no figure tails; there are packing, ") as refused:
        figures.save_all(result, tmp_path, names="tails")
    assert "certainty" not in str(refused.value)
    with pytest.raises(ValueError, match="no stage nothing; there are packing, "):
        figures.save_all(result, tmp_path, stage="nothing")
    with pytest.raises(ValueError, match="no stored state 99; this result has"):
        figures.save_all(result, tmp_path, state=99)
    run = subprocess.run(
        [sys.executable, "-m", "arenite.figures", json.dumps({"result": str(tmp_path)})],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": os.environ["ARENITE_PYTHONPATH"]},
    )
    assert run.returncode == 2 and run.stderr.count("\n") == 1 and "Traceback" not in run.stderr


def test_any_stage_and_any_stored_state_may_be_asked_for(result):
    stage = result.stages[1]
    shown = figures.figures_of(result, stage=stage.name)
    assert {part.name for _, part in shown} == {stage.name}
    assert shown[0][1].packing.x == pytest.approx(stage.packing.x)
    first = [part for _, part in figures.figures_of(result, state=1) if isinstance(part, figures.State)]
    assert {part.name for part in first} == {f"{result.stages[0].name}-1"}
    assert first[0].packing.x == pytest.approx(result.stages[0].snapshots[0].packing.x)


def test_libraries_are_quiet_within_the_style_and_as_before_after_it():
    logger = logging.getLogger("fontTools")
    before = logger.level
    with figures.journal_style():
        assert not logger.isEnabledFor(logging.WARNING)
    assert logger.level == before


def test_print_has_the_errors_that_a_stage_is_stored_with(result):
    packing = result.stages[-1].packing
    wide = {"coordination": {"all": {"value": 4.0, "error": 0.75}}}
    stage = arenite.Stage("made", states=[(0.0, "first", packing), (1.0, "last", packing)], texture=wide)
    first, last = (
        figures.describe(figures.State("made", stage, snapshot, [stage]))["coordination"][0]["panels"][0]["series"][0]
        for snapshot in stage.snapshots
    )
    assert last["error"] == [0.75] and first["error"][0] < 0.7


def test_forces_of_a_state_are_told_apart_by_its_measured_mean(result):
    state = next(part for _, part in figures.figures_of(result) if isinstance(part, figures.State))
    assert state.mean_force == pytest.approx(state.stage.texture["force"]["mean_N"]["value"])


def test_materials_have_one_colour_in_all_figures(result):
    state = next(part for _, part in figures.figures_of(result))
    shown = figures.describe(state)
    roles = {(e["name"], e["colour"]) for name in ("sigma-norm", "forces") for e in shown[name][0]["key"]} | {
        (rose["name"], rose["colour"]) for rose in shown["fabric"][0]["roses"]
    }
    assert ("all", "strong") in roles and len({name for name, _ in roles}) == len(roles)
    assert [drawing.colour_of_role(role) for role in ("material 0", "material 1", "mixed 0", "strong")] == [
        *style.colours[:3],
        style.strong,
    ]


def test_bonds_that_broke_have_one_colour_in_the_curves_and_in_the_picture():
    for kind, (_, colour) in bonds.kinds.items():
        assert drawing.colour_of_role(f"broken {kind - 1}") == colour
