"""Curves of a test against closed forms, on stages that are made up."""

import types

import arenite
import arenite.figures as figures
import numpy as np
import pytest
from arenite import curves
from arenite.figures import saving
from made_stages import a_box, a_cyclic_stage, a_stage, alone, density, thickness


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
        curves.along(types.SimpleNamespace(stages=[], spheres=[]))


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
