import json
import os
import re
import shutil
import subprocess

import arenite.figures as figures
import pytest

recipe = """
title = "small study"
seed = 3
[materials.POM]
density = "1410 kg/m^3"
stiffness = "27.35 kN/mm"
[[populations]]
material = "POM"
count = 60
size = { law = "uniform", min = "10 mm", max = "16 mm" }
[container]
width = "100 mm"
thickness = "60 mm"
[packing]
method = "random"
solid_fraction = 0.7
[contact]
friction_law = "cundall_strack"
[[stages]]
name = "prepare"
top = { force = "100 N" }
[cement]
kind = "bridges"
[grid]
nodes = 64
[[loads]]
name = "tension"
[[loads]]
name = "break"
failure = true
[sweep]
replicates = 2
[sweep.grid]
"cement.width" = [0.2, 0.3, 0.4]
"""

declared = """
[[figures]]
id = "saturation"
title = "Saturation"
x = "cement.width"
x_label = "η"
y = ["S_m", "solid_fraction"]
names = ["S_{m}", "ρ_{p}"]
spread = "deviation"
beside = [{ name = "beside", x = "0.3", y = "S_m", where = { "cement.width" = 0.2 } }]
source_points = [{ name = "source", part = 1, x = [0.2, 0.4], y = [0.5, 0.6] }]
references = [
  { y = 0.5, label = "half" },
  { x = 0.3, label = "here" },
  { slope = 1 },
  { x = 0.3, y = 0.5, label = "point" },
]

[[figures]]
id = "density"
title = "Stress"
curves = ["stress.sigma_yy.sets.all.histogram"]
fits = ["stress.sigma_yy.sets.all.tail"]
y_log = true
y_low = 1e-3
by = "cement.width"

[[figures]]
id = "rose"
title = "Directions"
kind = "rose"
curves = ["fabric.sectors"]
by = "cement.width"

[[figures]]
id = "counts"
title = "Contacts"
kind = "rose"
counts = true
sectors = 12
curves = ["fabric.sectors"]

[[figures]]
id = "window"
title = "Windows"
curves = ["window.solid_fraction"]
curve_x = "window.place"
window = 0.72

[[figures]]
id = "map"
title = "Map"
kind = "map"
x = "solid_fraction"
y = ["S_m"]
by = "cement.width"
""" + "".join(
    f"""
[[figures]]
id = "{kind}"
title = "One run"
kind = "{kind}"
{'stage = "break"' if kind == "cracks" else ""}
"""
    for kind in ["grains", "forces", "stresses", "phases", "zoom", "cracks", "film"]
)


@pytest.fixture(scope="module")
def study(tmp_path_factory):
    folder = tmp_path_factory.mktemp("study")
    (folder / "small.toml").write_text(recipe)
    (folder / "figures.toml").write_text(declared)
    subprocess.run(
        [os.environ["ARENITE"], "study", "run", "small.toml", "--out", "out", "--quiet"],
        cwd=folder,
        check=True,
        capture_output=True,
    )
    return folder / "out"


drawn = {
    "saturation",
    "density",
    "rose",
    "counts",
    "window",
    "map",
    "grains",
    "forces",
    "stresses",
    "phases",
    "zoom",
    "cracks",
}


def test_every_figure_of_the_page_is_drawn_in_column_width_with_its_fonts(study, tmp_path):
    paths = figures.save_all(study, tmp_path, ("pdf", "svg", "png"))
    assert {p.stem for p in paths} == drawn and len(paths) == 3 * len(drawn)
    for path in paths:
        bytes = path.read_bytes()
        assert len(bytes) > 2000
        if path.suffix == ".pdf":
            assert bytes.startswith(b"%PDF") and (b"/FontFile2" in bytes or b"/Type /Font" not in bytes)
        if path.suffix == ".svg":
            width = float(re.search(r'<svg [^>]*width="([\d.]+)pt"', path.read_text())[1])
            assert width / 72 * 25.4 == pytest.approx(85, abs=1e-4)  # mm


def test_the_same_study_gives_the_same_bytes(study, tmp_path):
    for form in ("pdf", "svg", "png"):
        first, second = (
            figures.save_all(study, tmp_path / turn, (form,), ["density", "zoom", "forces"]) for turn in "ab"
        )
        assert [p.read_bytes() for p in first] == [p.read_bytes() for p in second]


def test_numbers_are_those_of_the_page(study):
    document = figures.study_document(study)
    assert document == figures.study_document(study / "study.html")
    page = json.loads(
        (study / "study.html")
        .read_text()
        .split('<script type="application/json" id="figures">')[1]
        .split("</script>")[0]
    )
    assert document == {name: page[name] for name in ("title", "figures")}
    (shown,) = [f for f in document["figures"] if f["id"] == "saturation"]
    (panel,) = shown["drawing"]["panels"]
    assert [series["name"] for series in panel["series"]] == ["S_{m}", "ρ_{p}", "beside", "source"]
    assert [series.get("mark") for series in panel["series"]] == [None, None, "diamond", "times"]
    assert panel["references"][0] == {"y": 0.5, "label": "half", "colour": "source", "line": "dashed"}
    canvas = figures.catalogue.Canvas()
    figures.draw_described(canvas, [shown["drawing"]])
    axes, key = canvas.axes
    assert [text.get_text() for text in key.get_legend().get_texts()][:2] == ["$S_\\mathrm{m}$", "$ρ_\\mathrm{p}$"]
    bars, beside, _ = axes.containers
    drawn = [line.get_xydata().tolist() for line in axes.lines if len(line.get_xydata()) == 3]
    assert [list(point) for point in zip(panel["series"][0]["x"], panel["series"][0]["y"])] in drawn
    assert "diamond" not in axes.get_xlabel() and axes.get_xlabel() == "η"


def test_bands_and_ticks_show_the_scatter_over_samples(study):
    shown = {figure["id"]: figure for figure in figures.study_document(study)["figures"]}
    axes = figures.catalogue.Canvas().add_subplot()
    figures.draw_panel(axes, shown["density"]["drawing"]["panels"][0])
    bands = [type(part).__name__ for part in axes.collections]
    assert sum(name in ("PolyCollection", "FillBetweenPolyCollection") for name in bands) == 3
    axes = figures.catalogue.Canvas().add_subplot(projection="polar")
    figures.draw_outlines(axes, shown["counts"]["drawing"]["outlines"])
    assert len(axes.collections) == 2
    assert len(shown["counts"]["drawing"]["outlines"]["series"][0]["y"]) == 12
    fractions = shown["window"]["drawing"]["panels"][0]["series"][0]["y"]
    assert len(fractions) == 50 and all(0.5 < y < 1 for y in fractions)
    assert shown["saturation"]["caption"].endswith("Bars: standard deviation over 2 samples.")
    cells = shown["map"]["drawing"]["cells"]
    assert len(cells["values"]) == len(cells["x"]["names"]) * len(cells["y"]["names"])


def test_the_command_draws_and_tells_what_it_cannot(study, tmp_path):
    run = subprocess.run(
        [os.environ["ARENITE"], "figures", str(study), "--out", str(tmp_path)], capture_output=True, text=True
    )
    assert run.returncode == 0, run.stderr
    assert len(run.stdout.splitlines()) == len(drawn)
    assert (
        run.stderr == "film: Not drawn: no film of this run was made; arenite verify thesis without --small makes it.\n"
    )


def test_wrong_requests_are_refused_in_one_sentence(study, tmp_path):
    with pytest.raises(ValueError, match="no figure"):
        figures.save_all(study, tmp_path, names=["nothing"])
    (tmp_path / "runs.tsv").write_text("")
    run = subprocess.run([os.environ["ARENITE"], "figures", str(tmp_path)], capture_output=True, text=True)
    assert (
        run.returncode == 2
        and run.stderr.count("\n") == 1
        and "this study has no page yet; `arenite study page" in run.stderr
    )
    shutil.copy(study / "study.html", tmp_path)
    for page_alone in (tmp_path / "study.html", tmp_path):
        with pytest.raises(ValueError, match="study.hdf5, are missing beside it; give the study's folder"):
            figures.save_all(page_alone, tmp_path / "out")
