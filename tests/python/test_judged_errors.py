"""The judge of told errors (validation/errors/judge.py) passes honest ones and none that are too small."""

import importlib.util
import pathlib

import numpy as np
import pytest

file = pathlib.Path(__file__).resolve().parents[2] / "validation" / "errors" / "judge.py"
spec = importlib.util.spec_from_file_location("judge", file)
judge = importlib.util.module_from_spec(spec)
spec.loader.exec_module(judge)


def results(told, numbers=40, seeds=12):
    """Numbers of deviation 1 whose errors are told as `told`, in the trees of results."""
    values = np.random.default_rng(4).normal(size=(seeds, numbers))
    return [{"z": {f"n{k}": {"value": value, "error": told} for k, value in enumerate(row)}} for row in values]


def test_honest_errors_hold_and_small_or_large_ones_do_not():
    assert judge.hold([judge.Study("isotropic", results(1.0))])
    for told in (0.4, 3.0):
        assert not judge.hold([judge.Study("isotropic", results(told))])


def test_one_number_above_two_is_enough():
    trees = results(1.0)
    for tree, value in zip(trees, np.random.default_rng(5).normal(size=12)):
        tree["z"]["n0"] = {"value": value, "error": 0.3}
    study = judge.Study("isotropic", trees)
    assert len(study.inside) >= 0.95 * len(study.numbers) and study.worst.name == "z.n0"
    assert not judge.hold([study])


def test_angles_are_compared_around_the_circle_and_unknown_errors_are_not_judged():
    stress = {"value": [[1, 2], [2, 3]], "error": None}
    trees = [{"theta_c_deg": {"value": v, "error": 2.0}, "stress": stress} for v in (179, 1, 178, 2, 0, 177)]
    study = judge.Study("isotropic", trees)
    assert [n.name for n in study.numbers] == ["theta_c_deg"]
    assert study.numbers[0].scatter == pytest.approx(2.07, abs=0.2)


def test_the_band_is_that_of_chi_square():
    low, high = judge.chi_band(11)
    assert low == pytest.approx(np.sqrt(2.6032 / 11), abs=0.01)
    assert high == pytest.approx(np.sqrt(26.757 / 11), abs=0.01)
