"""The judge of told errors (validation/errors/told_errors.py) passes honest ones and none that are too small."""

import importlib.util
import pathlib

import numpy as np
import pytest

file = pathlib.Path(__file__).resolve().parents[2] / "validation" / "errors" / "told_errors.py"
spec = importlib.util.spec_from_file_location("told_errors", file)
told_errors = importlib.util.module_from_spec(spec)
spec.loader.exec_module(told_errors)


def results(told, numbers=40, seeds=12):
    """Numbers of deviation 1 whose errors are told as `told`, in the trees of results."""
    values = np.random.default_rng(4).normal(size=(seeds, numbers))
    return [{"z": {f"n{k}": {"value": value, "error": told} for k, value in enumerate(row)}} for row in values]


def test_honest_errors_hold_and_small_or_large_ones_do_not():
    assert told_errors.hold([told_errors.Study("isotropic", results(1.0))])
    for told in (0.4, 3.0):
        assert not told_errors.hold([told_errors.Study("isotropic", results(told))])


def test_a_comparison_that_finds_more_than_chance_does_not_hold():
    assert told_errors.hold([told_errors.Study("isotropic", results(1.0), 0.05)])
    assert not told_errors.hold([told_errors.Study("isotropic", results(1.0), 0.2)])


def test_one_number_above_two_is_enough():
    trees = results(1.0)
    for tree, value in zip(trees, np.random.default_rng(5).normal(size=12)):
        tree["z"]["n0"] = {"value": value, "error": 0.3}
    study = told_errors.Study("isotropic", trees)
    assert len(study.inside) >= 0.95 * len(study.numbers) and study.worst.name == "z.n0"
    assert not told_errors.hold([study])


def test_angles_are_compared_around_the_circle_and_unknown_errors_are_not_judged():
    stress = {"value": [[1, 2], [2, 3]], "error": None}
    angles = [{"value": v, "error": 2.0, "period": 180} for v in (179, 1, 178, 2, 0, 177)]
    trees = [{"theta_c_deg": angle, "stress": stress} for angle in angles]
    study = told_errors.Study("isotropic", trees)
    assert [n.name for n in study.numbers] == ["theta_c_deg"]
    assert study.numbers[0].scatter == pytest.approx(2.07, abs=0.2)


def test_the_band_is_that_of_fishers_f():
    # Tables of F at 0.5 and 99.5 %; with errors that are known exactly it is chi square over its freedom.
    for told, expected in ((1e9, (0.4865, 1.5596)), (36, (0.4670, 1.7613)), (12, (0.4370, 2.2335))):
        assert told_errors.band_of_ratios(11, told) == pytest.approx(expected, abs=0.02)


def test_seeds_differ_by_chance_as_students_t_has_it():
    assert told_errors.beyond_by_chance(3) == pytest.approx(0.0924, abs=2e-4)
    assert told_errors.beyond_by_chance(200) == pytest.approx(0.0462, abs=2e-4)


def test_errors_from_few_blocks_are_honest_though_they_scatter():
    draw, freedom = np.random.default_rng(6), 3
    trees = results(1.0, numbers=200)
    for tree in trees:
        for number in tree["z"].values():
            number["error"] = np.sqrt(draw.chisquare(freedom) / freedom)
    study = told_errors.Study("isotropic", trees)
    assert told_errors.hold([study])
    assert study.chance == pytest.approx(told_errors.beyond_by_chance(freedom), abs=0.02)
