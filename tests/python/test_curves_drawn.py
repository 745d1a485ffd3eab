"""How curves of a test are drawn, and of which runs a study has them."""

import arenite.figures as figures
import numpy as np
import pytest
from arenite import _core, curves
from arenite.figures import runs
from made_stages import a_cyclic_stage, a_stage, alone

small = """[container]
width = "100 mm"
thickness = "10 mm"
[packing]
solid_fraction = 0.7
[materials.A]
density = "2500 kg/m^3"
stiffness = "1 kN/mm"
[[populations]]
material = "A"
count = 10
diameter = "10 mm"
"""


def a_study(folder, stages, friction=0.3):
    """Runs whose last stages are these lines of a recipe."""
    for k, lines in enumerate(stages):
        run = folder / "runs" / str(k)
        run.mkdir(parents=True, exist_ok=True)
        last = f'[contact]\nfriction = {friction}\n[[stages]]\nname = "test"\n{lines}\n'
        (run / "recipe.toml").write_text(small + last)
    return folder


def test_stages_of_a_study_that_strain_at_a_rate(tmp_path):
    def is_driven(name, *lines):
        return runs.figures_of_study(a_study(tmp_path / name, ["\n".join(lines)] * 2)) == ["rheology"]

    lasts = 'duration = "1 s"'
    assert is_driven("velocity", lasts, 'top = { velocity = "75 mm/s" }')
    assert is_driven("slide", lasts, 'slide = { top = "1 mm/s", left = "0 mm/s" }')
    assert not is_driven("still", 'top = { force = "1 kN" }', 'slide = { top = "0 mm/s" }', 'left = "fixed"')


def shown(stage, name):
    """The drawing of a figure of a stage that is made up."""
    (drawing,) = figures.describe(stage)[name]
    return drawing


def test_curves_that_fluctuate_are_drawn_under_their_running_mean_which_keeps_what_is_straight():
    rows = 1001
    width = np.linspace(4, 3.6, rows)
    press = {side: np.linspace(1, 2, rows) * 100 for side in ("left", "right", "bottom", "top")}
    press["bottom"] = press["top"] = 3 * press["top"] * (1 + 0.1 * (-1) ** np.arange(rows))
    stage = alone(a_stage(width[0] + 0 * width, width, press)).stages[0]
    every, mean = shown(stage, "test-curves")["panels"][1]["series"]
    assert every["silent"] and np.ptp(np.diff(every["y"])) > 0.02
    assert np.std(np.diff(mean["y"][50:-50])) < 0.2 * np.std(np.diff(every["y"]))
    assert mean["x"] == pytest.approx(list(100 * (1 - width / 4)))


def test_cycles_are_drawn_at_both_ends_of_the_load():
    (panel,) = shown(alone(a_cyclic_stage()).stages[0], "cycles")["panels"]
    assert [series["y"] for series in panel["series"]] == [pytest.approx([10, 12.5]), pytest.approx([5, 7.5])]
    assert panel["y"]["label"] == "axial strain" and panel["y"]["unit"] == "%"


def test_states_of_a_run_agree_with_its_history_and_its_texture(result):
    found, states = curves.along(result), curves.of_states(result)
    assert states["axial_strain"].values[-1] == pytest.approx(found["axial_strain"].values[-1], abs=1e-6)
    texture = result.stages[-1].texture
    assert states["z"].values[-1] == pytest.approx(texture["coordination"]["all"]["value"])
    assert states["z_error"].values[-1] == pytest.approx(texture["coordination"]["all"]["error"])
    assert states["p"].values[-1] == pytest.approx(found["p"].values[-1], rel=0.1)  # of the contacts, and of the sides
    assert all(len(curve.values) == len(found["time"].values) for curve in found.values())


def test_figures_of_a_test_show_its_curves(result):
    state = next(part for _, part in figures.figures_of(result))
    found = curves.along(result, state.stage.name)
    drawn = figures.describe(state)["test-curves"][0]["panels"] if "test-curves" in figures.describe(state) else None
    assert (drawn is None) == (np.max(np.abs(found["axial_strain"].values)) < 2e-3)
    panel = _core._curve_of_stage(*curves.find_test(result), "axial_strain", "q_over_p")["panel"]
    (line,) = [series for series in panel["series"] if "silent" not in series]
    assert line["x"] == pytest.approx(list(100 * found["axial_strain"].values))
    assert len(panel["now"]["x"]) == len(state.stage.snapshots)


def test_a_study_whose_runs_are_strained_at_a_rate_has_its_rheology(tmp_path, monkeypatch):
    (tmp_path / "runs.tsv").write_text("")
    friction, rate = {"slow": 0.3, "fast": 0.4}, {"slow": 0.1, "fast": 0.3}
    stage = '[[stages]]\nname = "test"\n{}\n'
    for name in [*friction, "later"]:
        (tmp_path / "runs" / name).mkdir(parents=True)
        (tmp_path / "runs" / name / "recipe.toml").write_text(
            small + stage.format('duration = "1 s"\nslide = { top = "2 mm/s" }')
        )

    def opened(path):
        name = path.rsplit("/", 1)[1]
        if name == "later":
            raise ValueError("not done yet")
        sides = {side: 40.0 for side in ("left", "right", "bottom", "top")}
        shear = {"bottom": 40 * friction[name], "top": -40 * friction[name]}
        return alone(a_stage([4.0] * 40, [4.0] * 40, sides, shear, shear_strain=rate[name] * np.arange(40)))

    monkeypatch.setattr(runs, "open_result", opened)
    for name in friction:
        (tmp_path / "runs" / name / "status").write_text("done")
    ((_, (drawing,)),) = runs.over_runs(tmp_path)
    assert drawing["panels"][0]["series"][0]["y"] == pytest.approx([0.3, 0.4])
    (path,) = figures.save_all(tmp_path, tmp_path / "figures", names="rheology")
    rate["fast"] = 0.1
    assert not list(runs.over_runs(tmp_path)), "runs of one rate say nothing of how friction follows from it"
    rate["fast"] = 0.3
    assert path.read_bytes().startswith(b"%PDF")
    (tmp_path / "runs" / "later" / "recipe.toml").write_text(small + stage.format('top = { force = "1 kN" }'))
    assert not runs.figures_of_study(tmp_path)
    with pytest.raises(ValueError, match="this study has no page yet"):
        figures.save_all(tmp_path, tmp_path / "figures")


def test_without_confinement_the_stress_is_drawn():
    press = {side: np.array([0, 1e3, 2e3]) for side in ("bottom", "top")}
    stage = alone(a_stage([0.1] * 3, [0.1, 0.0999, 0.0995], press)).stages[0]
    (panel,) = shown(stage, "test-curves")["panels"]
    assert panel["y"]["label"] == "stress along the axis" and panel["y"]["unit"] == "kPa"
    assert panel["series"][0]["y"][-1] > 0
