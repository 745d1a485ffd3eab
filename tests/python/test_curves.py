"""Curves of a test against closed forms, on stages that are made up, and on a small sheared sample."""

import types

import arenite
import arenite.figures as figures
import numpy as np
import pytest
from arenite import _core, curves
from arenite.figures import runs, saving

density, thickness = 1000.0, 0.1


def a_stage(width, height, forces=None, shear=None, name="test", labels=None, asked=None, texture=None, **columns):
    """A stage whose box has this `width` and `height` in time 0, 1, 2, ...; `forces` and `shear` of its sides, N."""
    n = len(height)
    history = {
        "time": np.arange(n, dtype=float),
        "left_position": np.zeros(n),
        "right_position": np.array(width, float),
        "bottom_position": np.zeros(n),
        "top_position": np.array(height, float),
    }
    for side in ("left", "right", "bottom", "top"):
        history[f"{side}_force"] = np.broadcast_to((forces or {}).get(side, 0.0), n).astype(float)
        history[f"{side}_shear_force"] = np.broadcast_to((shear or {}).get(side, 0.0), n).astype(float)
    history.update({key: np.array(values, float) for key, values in columns.items()})
    states = [(float(k), (labels or ["state"] * n)[k], a_box(width[k], height[k])) for k in range(n)]
    return arenite.Stage(name, history=history, states=states, asked=asked or {}, texture=texture or {})


def a_box(width, height):
    """Four disks that a box of this size holds, however small it is."""
    middle = [0.5 * width, 0.5 * height]
    return arenite.Packing(
        [middle[0]] * 4,
        [middle[1]] * 4,
        [1, 1, 1, 1],
        materials=[arenite.Material("clay", density=density)],
        width=width,
        height=height,
        thickness=thickness,
    )


def alone(stage, *before):
    return types.SimpleNamespace(stages=[*before, stage])


def test_strains_are_those_since_the_state_before():
    before = arenite.Stage("packing", states=[(-1.0, "start", a_box(4, 4))])
    found = curves.along(alone(a_stage([4.0, 4.2, 4.4], [4.0, 3.8, 3.6]), before))
    assert found["axial_strain"].values == pytest.approx([0, 0.05, 0.1])
    assert found["strain_x"].values == pytest.approx([0, -0.05, -0.1])
    assert found["shear_strain"].values == pytest.approx([0, 0.1, 0.2])
    assert found["volumetric_strain"].values == pytest.approx([0, 1 - 1.05 * 0.95, 1 - 1.1 * 0.9])
    assert found["solid_fraction"].values == pytest.approx(4 * np.pi / np.array([16, 4.2 * 3.8, 4.4 * 3.6]))
    assert found["axial_strain"].unit == "1" and found["time"].unit == "s"
    assert "p" not in found and "mu" not in found and "dissipated_energy" not in found


def test_the_axis_is_the_one_that_shortens():
    found = curves.along(alone(a_stage([4.0, 3.6], [4.0, 4.2])))
    assert found["axial_strain"].values == pytest.approx([0, 0.1])


def test_stresses_follow_from_the_forces_on_the_sides():
    found = curves.along(
        alone(a_stage([4.0] * 3, [4.0, 3.9, 3.8], {"left": 30.0, "right": 50.0, "bottom": 120.0, "top": 120.0}))
    )
    height = np.array([4.0, 3.9, 3.8])
    xx, yy = 40 / (height * thickness), 120 / (4 * thickness) * np.ones(3)
    assert found["sigma_xx"].values == pytest.approx(xx) and found["sigma_yy"].values == pytest.approx(yy)
    assert found["q_over_p"].values == pytest.approx((yy - xx) / (yy + xx))
    rate = np.gradient(found["shear_strain"].values)
    assert found["inertial_number"].values == pytest.approx(rate * 2 * np.sqrt(density / found["p"].values))


def test_ratios_are_unknown_where_nothing_presses():
    found = curves.along(
        alone(
            a_stage(
                [4.0] * 3,
                [4.0, 3.9, 3.8],
                {side: np.array([0.0, 1e-3, 100.0]) for side in ("left", "right", "bottom", "top")},
            )
        )
    )
    assert list(np.isnan(found["q_over_p"].values)) == [True, True, False]


def test_a_sheared_cell_tells_its_friction():
    stage = a_stage(
        [4.0] * 3,
        [4.0] * 3,
        {"left": 40.0, "right": 40.0, "bottom": 40.0, "top": 40.0},
        {"bottom": 12.0, "top": -12.0},
        shear_strain=[1.0, 1.5, 2.0],
    )
    found = curves.along(alone(stage))
    assert found["shear_strain"].values == pytest.approx([0, 0.5, 1]) and found["mu"].values == pytest.approx([0.3] * 3)
    assert found["q_over_p"].values == pytest.approx([0.3] * 3)
    assert found["inertial_number"].values == pytest.approx([0.5 * 2 * np.sqrt(density / 100)] * 3)


def test_walls_that_slide_shear_the_sample():
    stage = a_stage(
        [4.0] * 3,
        [4.0, 4.0, 2.0],
        {"bottom": 40.0, "top": 40.0},
        {"bottom": 8.0, "top": -8.0},
        asked={"slide": {"top": 0.05, "bottom": -0.15}},
        top_slid=[0, 0.05, 0.1],
        bottom_slid=[0, -0.15, -0.3],
    )
    found = curves.along(alone(stage))
    assert found["shear_strain"].values == pytest.approx([0, 0.05, 0.05 + 0.075])
    assert found["mu"].values == pytest.approx([0.2] * 3) and found["tau"].values == pytest.approx([20.0] * 3)
    assert curves.slides(stage) == {"top": pytest.approx(0.05), "bottom": pytest.approx(-0.15)}


def test_energies_are_counted_from_the_first_row():
    stage = a_stage(
        [4.0] * 2, [4.0] * 2, dissipated_normal=[1.0, 2.0], dissipated_friction=[1.0, 5.0], work_walls=[0.0, 7.0]
    )
    found = curves.along(alone(stage))
    assert found["dissipated_energy"] == (pytest.approx([0, 5]), "J") and found["work"].values == pytest.approx([0, 7])


def a_cyclic_stage():
    labels = [
        "equilibrium",
        "cycle 1 maximum",
        "cycle 1 minimum",
        "cycle 2 maximum",
        "cycle 2 minimum",
        "cycle 3 maximum",
    ]
    return a_stage([4.0] * 6, [4.0, 3.6, 3.8, 3.5, 3.7, 3.4], labels=labels, dissipated_friction=[0, 1, 3, 4, 5, 9])


def test_cycles_are_whole_ones():
    found = curves.of_cycles(alone(a_cyclic_stage()))
    assert list(found["cycle"].values) == [1, 2]
    assert found["axial_strain_maximum"].values == pytest.approx([0.1, 0.125]) and found[
        "axial_strain_minimum"
    ].values == pytest.approx([0.05, 0.075])
    assert found["strain_amplitude"].values == pytest.approx([0.05, 0.05]) and found[
        "accumulated_strain"
    ].values == pytest.approx([0, 0.025])
    assert found["dissipated_energy"].values == pytest.approx([3, 2])
    with pytest.raises(ValueError, match="the stage test has no complete load cycle"):
        curves.of_cycles(alone(a_stage([4.0] * 2, [4.0, 3.9])))


def test_what_is_not_there_is_one_sentence():
    with pytest.raises(ValueError, match="there is no stage other with a history; there are test"):
        curves.along(alone(a_stage([4.0] * 2, [4.0, 3.9])), "other")
    with pytest.raises(ValueError, match="holds no loading stage"):
        curves.along(types.SimpleNamespace(stages=[]))


def test_rheology_is_in_the_order_of_the_rate():
    def run(rate, friction):
        time = np.arange(40)
        return alone(
            a_stage(
                [4.0] * 40,
                [4.0] * 40,
                {side: 40.0 for side in ("left", "right", "bottom", "top")},
                {"bottom": 40 * friction, "top": -40 * friction},
                shear_strain=rate * time,
            )
        )

    found = curves.rheology([run(0.4, 0.5), run(0.1, 0.3)])
    assert found["mu"].values == pytest.approx([0.3, 0.5]) and found["mu_error"].values == pytest.approx(
        [0, 0], abs=1e-12
    )
    assert found["inertial_number"].values == pytest.approx(np.array([0.1, 0.4]) * 2 * np.sqrt(density / 100))
    canvas = saving.Canvas()
    figures.draw_runs(canvas, "rheology", [run(0.4, 0.5), run(0.1, 0.3)])
    of_mu, of_phi = canvas.axes
    assert of_mu.get_xscale() == "log" and of_phi.get_xlabel() == "inertial number I"
    assert of_mu.lines[-1].get_ydata() == pytest.approx(found["mu"].values)
    assert of_phi.lines[-1].get_ydata() == pytest.approx(found["solid_fraction"].values)


def test_a_ratio_is_that_of_the_means():
    rng = np.random.default_rng(3)
    normal = 100 * (1 + 0.2 * rng.normal(size=4000))
    shear = 30 - 0.1 * (normal - 100)
    ratio, error = curves.steady_ratio(shear, normal)
    assert ratio == pytest.approx(0.3, abs=4 * error) and error < 0.003
    assert np.mean(shear / normal) > ratio + 0.01  # the mean of ratios is another number


def test_errors_of_steady_means_respect_what_goes_together():
    rng = np.random.default_rng(1)
    slow = np.repeat(rng.normal(size=40), 50)
    assert curves.steady(slow)[1] > 3 * np.std(slow[1000:]) / np.sqrt(1000)


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
