"""Fits of flows under weight against laws they are made with, and a silo that is made up."""

import types

import arenite
import arenite.figures as figures
import numpy as np
import pytest
from arenite import curves, flows
from arenite.figures import runs


small = """[container]
width = "100 mm"
thickness = "10 mm"
[packing]
solid_fraction = 0.3
[materials.A]
density = "2500 kg/m^3"
stiffness = "1 kN/mm"
[[populations]]
material = "A"
count = 10
diameter = "10 mm"
"""
periodic = "periodic_x = true\nperiodic_y = true\n[packing]"


def points(x, y, error, names, units):
    return {
        name: curves.Curve(np.array(values, float), unit) for name, values, unit in zip(names, (x, y, error), units)
    }


def a_run(**parts):
    return types.SimpleNamespace(stages=[arenite.Stage("last", texture=parts)])


def test_beverloos_law_is_found_again():
    opening = np.array([0.03, 0.04, 0.055, 0.075, 0.1])
    rate = 33 * (opening - 0.0096) ** 1.5
    runs = [
        a_run(discharge={"opening_m": d, "rate_kg_s": {"value": w, "error": 0.01 * w}}) for d, w in zip(opening, rate)
    ]
    found = flows.discharges([runs[k] for k in (3, 0, 4, 1, 2)] + [a_run()])
    assert found["opening"].values == pytest.approx(opening) and found["rate"].unit == "kg/s"
    law = flows.fit_beverloo(found)
    assert law["exponent"][0] == pytest.approx(1.5, abs=1e-4) and law["lost_width"][0] == pytest.approx(
        0.0096, abs=1e-5
    )
    assert 0.02 < law["exponent"][1] < 0.2
    assert flows.fit_beverloo(found, exponent=1.5)["factor"][0] == pytest.approx(33, rel=1e-6)


def test_tables_of_no_results_have_the_columns_of_some():
    some = flows.discharges([a_run(discharge={"opening_m": 0.1, "rate_kg_s": {"value": 1.0, "error": 0.1}})])
    nothing = flows.discharges([])
    assert list(nothing) == list(some) == ["opening", "rate", "rate_error"]
    assert all(len(curve.values) == 0 and curve.unit == some[name].unit for name, curve in nothing.items())
    for empty in (flows.runouts([]), flows.silos([]), flows.critical_states([]), curves.rheology([])):
        assert any(name.endswith("_error") for name in empty)


def test_the_law_of_beverloo_is_drawn_through_the_rates():
    opening = np.array([0.03, 0.04, 0.055, 0.075, 0.1])
    rate = 33 * (opening - 0.0096) ** 1.5
    results = [
        a_run(discharge={"opening_m": d, "rate_kg_s": {"value": w, "error": 0.01 * w}}) for d, w in zip(opening, rate)
    ]
    (drawing,) = runs.drawings_of_runs("beverloo", results)
    points, law = drawing["panels"][0]["series"]
    assert points["x"] == pytest.approx(list(1e3 * opening)) and points["y"] == pytest.approx(list(rate ** (2 / 3)))
    assert points["error"] == pytest.approx(list(2 / 3 * 0.01 * rate ** (2 / 3)))
    assert np.interp(points["x"], law["x"], law["y"]) == pytest.approx(points["y"], rel=1e-3)
    ((symbol, lost, _),) = drawing["key"][0]["numbers"]
    assert symbol == "w/mm" and float(lost) == pytest.approx(9.6, abs=0.1)
    canvas = figures.saving.Canvas()
    figures.draw_runs(canvas, "beverloo", results)
    assert "W^" in canvas.axes[-1].get_ylabel() or "W^" in canvas.axes[0].get_ylabel()


def runs_of_collapses(aspect):
    surface = [
        {"aspect_ratio_before": a, "runout_over_width": {"value": 2 * a, "error": 0.02}, "height_over_width": 1.0}
        for a in aspect
    ]
    return [a_run(surface=one) for one in surface]


def test_a_law_that_is_not_drawn_says_how_many_runs_are_missing():
    rates = [a_run(discharge={"opening_m": d, "rate_kg_s": {"value": d, "error": 0.01}}) for d in (0.03, 0.05, 0.08)]
    (drawing,) = runs.drawings_of_runs("beverloo", rates)
    assert len(drawing["panels"][0]["series"]) == 2 and "note" not in drawing
    (drawing,) = runs.drawings_of_runs("beverloo", rates[:2])
    assert len(drawing["panels"][0]["series"]) == 1
    assert drawing["note"] == "Beverloo\u2019s law is fitted to 3 runs or more, and there are 2."
    (drawing,) = runs.drawings_of_runs("runout", runs_of_collapses([0.5, 1, 2, 3]))
    assert len(drawing["panels"][0]["series"]) == 2
    assert drawing["note"] == "A power law is fitted to 3 runs or more of unlike a; of a \u2265 2.5 there is 1."
    (drawing,) = runs.drawings_of_runs("runout", runs_of_collapses([0.5, 1, 2]))
    assert drawing["note"].endswith("; of a \u2265 2.5 there is none.")
    canvas = figures.saving.Canvas()
    figures.draw_runs(canvas, "runout", runs_of_collapses([0.5, 4]))
    words = "".join(text.get_text() for text in canvas.texts)
    assert "there is 1" in words and "2.5" in words


def test_errors_of_fits_are_those_of_many_samples():
    generator = np.random.default_rng(1)
    x = np.array([1.0, 2, 3, 5, 8, 13])
    fits = [
        flows.fit_power(x, 2 * x**0.7 * (1 + 0.05 * generator.normal(size=6)), 0.05 * 2 * x**0.7)["exponent"]
        for _ in range(300)
    ]
    values, errors = np.array(fits).T
    assert np.mean(values) == pytest.approx(0.7, abs=0.01)
    assert np.mean(errors) == pytest.approx(np.std(values), rel=0.35)


def test_both_regimes_of_run_out_are_found_again():
    aspect = np.array([0.5, 0.8, 1.3, 2, 3, 4.5, 7, 11, 17])
    way = np.where(aspect < 2.5, 2 * aspect, 2 * 2.5 ** (1 / 3) * aspect ** (2 / 3))
    surface = [
        {"aspect_ratio_before": a, "runout_over_width": {"value": r, "error": 0.02}, "height_over_width": 1.0}
        for a, r in zip(aspect, way)
    ]
    laws = flows.fit_runout(flows.runouts([a_run(surface=s) for s in surface]))
    assert laws["low"]["exponent"][0] == pytest.approx(1, abs=1e-4) and laws["high"]["exponent"][0] == pytest.approx(
        2 / 3, abs=1e-4
    )


def test_janssens_law_is_found_again():
    height = np.array([0.05, 0.1, 0.2, 0.3, 0.5, 0.8])
    found = {
        "height": curves.Curve(height, "m"),
        "pressure": curves.Curve(900 * -np.expm1(-height / 0.12), "Pa"),
        "pressure_error": curves.Curve(np.full(6, 5.0), "Pa"),
    }
    found.update(
        hydrostatic=curves.Curve(7500 * height, "Pa"),
        wall_friction=curves.Curve(np.full(6, 0.4), "1"),
        ratio=curves.Curve(np.full(6, 0.8), "1"),
        width=curves.Curve(np.full(6, 0.08), "m"),
    )
    law = flows.fit_janssen(found)
    assert law["saturation"][0] == pytest.approx(900, rel=1e-4) and law["length"][0] == pytest.approx(0.12, rel=1e-4)
    assert law["length_by_stresses"][0] == pytest.approx(0.08 / 0.64)


def test_a_silo_tells_what_its_walls_carry():
    x, y = np.meshgrid(np.arange(4) + 0.5, np.arange(6) + 0.5)
    material = arenite.Material("clay", density=1000.0)
    packing = arenite.Packing(
        0.01 * x.ravel(),
        0.01 * y.ravel(),
        np.full(24, 0.005),
        materials=[material],
        width=0.04,
        height=0.1,
        thickness=0.1,
    )
    weight = 1.62 * 1000 * 0.1 * 24 * np.pi * 0.005**2  # on the moon
    history = {
        "bottom_force": 0.6 * weight + 1e-3 * np.cos(np.arange(200.0) * 2.1),
        "left_force": np.full(200, 0.5 * weight),
        "right_force": np.full(200, 0.5 * weight),
    }
    stage = arenite.Stage("sink", history=history, states=[(1.0, "end", packing)], asked={"gravity": (0, -1.62)})
    found = flows.silos([types.SimpleNamespace(stages=[stage])])
    assert np.isnan(found["ratio"].values)  # no contact tells the ratio of stresses
    assert found["height"].values == pytest.approx([0.06], rel=1e-6)
    assert found["pressure"].values == pytest.approx([0.6 * weight / 0.004], rel=1e-3)
    assert found["wall_friction"].values == pytest.approx([0.4], rel=1e-3)


def a_resting_run(tmp_path, *lines):
    """The last stage of a small run with these lines; a few grains in free fall."""
    text = small + '[contact]\nfriction = 0.25\n[[stages]]\nname = "fall"\ngravity = true\n' + "\n".join(lines)
    return arenite.run(arenite.Recipe.from_text(text), str(tmp_path / str(len(text)))).stages[-1]


def test_gravity_is_that_of_the_recipe(tmp_path):
    lasts = 'duration = "5 ms"'
    still = a_resting_run(tmp_path, lasts)
    assert flows.gravity_of(still) == 9.81 and "gravity_y" not in still.history
    assert flows.friction_of(types.SimpleNamespace(stages=[still])) == 0.25
    assert flows.gravity_of(a_resting_run(tmp_path, lasts, 'gravity_size = "1.62 m/s^2"')) == 1.62
    growing = 'programmes = [{ of = "gravity_size", table = [["0 s", "2 m/s^2"], ["10 ms", "6 m/s^2"]] }]'
    stage = a_resting_run(tmp_path, lasts, growing)
    assert flows.gravity_of(stage) == pytest.approx(4) and stage.history["gravity_y"][-1] == pytest.approx(-4)
    assert np.isnan(flows.gravity_of(arenite.Stage("made up")))


def test_a_plateau_is_told_with_its_error_whether_it_is_sure_or_not():
    generator = np.random.default_rng(2)
    noise = 0.01 * generator.normal(size=(2, 4000))
    drift = np.linspace(0, 1, 4000)
    for change, reached in ((0, 1), (0.2, 0)):
        normal = 100 * (1 + noise[1])  # fluctuates as the shear stress does not
        shear = 100 * (-0.26 - noise[0])
        solid = 0.81 + noise[1] + change * drift
        packing = arenite.Packing([0.5], [0.5], [0.1], width=1, height=1, thickness=1)
        height = np.pi * 0.01 / solid
        history = {"time": np.arange(4000.0), "shear_strain": 0.001 * np.arange(4000)}
        for side, place in (("left", 0), ("right", 1), ("bottom", 0), ("top", height)):
            history[f"{side}_position"] = np.zeros(4000) + place
            history[f"{side}_force"] = normal if side in ("bottom", "top") else np.zeros(4000)
        history.update(bottom_shear_force=shear, top_shear_force=-shear)
        stage = arenite.Stage("shear", history=history, states=[(0.0, "end", packing)], asked={"friction": 0.4})
        states = flows.critical_states([types.SimpleNamespace(stages=[stage])])
        assert states["reached"].values == [reached] and states["friction"].values == [0.4]
        assert abs(states["mu"].values[0] - 0.26) < 4 * states["mu_error"].values[0] < 0.004
        assert (
            states["solid_fraction"].values[0] == pytest.approx(0.81 + 0.75 * change, abs=2e-3)
            and states["solid_fraction_error"].values[0] > 1e-4
        )


def test_figures_know_which_study_is_which(tmp_path):
    stages = {
        "beverloo": 'gravity = true\ncount_below = "1 mm"',
        "runout": "gravity = true\nopen = { right = true }",
        "janssen": 'gravity = true\nbottom = { velocity = "-5 mm/s" }',
        "critical-state": 'shear_rate = "1 1/s"',
    }
    for kind, stage in stages.items():
        for k in range(3):
            run = tmp_path / kind / "runs" / str(k)
            run.mkdir(parents=True)
            start = small.replace("[packing]", periodic if kind == "critical-state" else "[packing]")
            stages = f'[[stages]]\nname = "test"\nduration = "1 s"\n{stage}\n'
            (run / "recipe.toml").write_text(f"{start}[contact]\nfriction = 0.{k}\n{stages}")
        assert runs.figures_of_study(tmp_path / kind)[0] == kind
    assert not runs.figures_of_study(tmp_path / "none")
