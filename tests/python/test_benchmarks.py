"""Benchmarks (validation/benchmarks, docs/benchmarks.md) in small: a ball thrown into a bed, spheres that just bear."""

import pathlib

import numpy as np
import pytest

import arenite

BENCHMARKS = pathlib.Path(__file__).resolve().parents[2] / "validation" / "benchmarks"
RECIPE = BENCHMARKS / "penetration.toml"
SMALL = {
    "variables.D": "8 mm",
    "variables.fall": "130 mm",
    "container.width": "16 mm",
    "container.depth": "16 mm",
    "packing.area.top": "11 mm",
    "populations.0.count": 350,
    "boundaries.0.ball.x": "8 mm",
    "boundaries.0.ball.z": "8 mm",
    "integration.track_energy": True,
    "stages.0.duration": "20 ms",
    "stages.1.duration": "3 ms",
}


@pytest.fixture(scope="module")
def thrown(tmp_path_factory):
    """The stages of the bed and of the ball."""
    return arenite.run(arenite.Recipe(RECIPE, SMALL), tmp_path_factory.mktemp("ball") / "out").spheres[1:]


def test_the_ball_falls_freely_until_it_meets_the_bed_and_stops_in_it(thrown):
    bed, flight = thrown
    time = flight.history["time"] - bed.history["time"][-1]
    height, force = flight.history["ball_y"], flight.history["ball_force_y"]
    start = bed.history["ball_y"][-1]
    assert start == pytest.approx(0.150 - 0.130)
    speed = np.sqrt(5**2 + 2 * 9.81 * 0.130)
    touches = np.argmax(force != 0)
    assert touches > 2
    # Velocity Verlet is exact under a constant force.
    assert height[:touches] == pytest.approx(start - speed * time[:touches] - 4.905 * time[:touches] ** 2, abs=1e-12)
    surface = bed.states[-1].position[:, 1].max() + 0.001
    assert 0 < height[-1] - 0.004 < surface - 0.001
    assert abs(height[-1] - height[-2]) / (time[-1] - time[-2]) < 0.1 * speed


def test_energy_of_ball_and_bed_is_in_balance(thrown):
    bed, flight = thrown
    energy = flight.numbers["energy_balance"]
    mass = 7200 * np.pi / 6 * 0.008**3
    thrown_with = 0.5 * mass * (5**2 + 2 * 9.81 * 0.130)
    assert flight.history["kinetic"][0] == pytest.approx(thrown_with, rel=0.05)
    assert abs(energy["open"]) < 1e-3
    assert flight.history["kinetic"][-1] < 0.7 * thrown_with


def test_frictionless_spheres_under_little_pressure_have_hardly_more_than_six_contacts(tmp_path):
    small = {"packing.grains": 200, "container.width": "5.85*d", "container.depth": "5.85*d", "variables.root": 0.01}
    result = arenite.run(arenite.Recipe(BENCHMARKS / "isostatic" / "recipe.toml", small), tmp_path / "out")
    numbers = result.spheres[-1].numbers
    z, phi = numbers["coordination"]["without_rattlers"]["value"], numbers["solid_fraction"]["value"]
    # Spheres and three lengths of the cell, less three shifts of all, are held by as many contacts at least.
    assert z >= 6
    # LAMMPS has 6.24 +- 0.04 for 1000 spheres at P d/k = 4e-4, where the root of the pressure is twice as much: 6.12 +-
    # 0.09 for 200.
    assert z < 6.3
    # And 0.638 +- 0.002 there: four errors for 200.
    assert phi == pytest.approx(0.638, abs=0.018)
