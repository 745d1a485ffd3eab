"""Every function of the module with arguments of all kinds: it answers or refuses, and the interpreter lives."""

import os
import random
import signal
import sys

import arenite
import numpy as np
import pytest

attempts = 60
refusals = (ValueError, TypeError, KeyError, OSError, IndexError, OverflowError, RuntimeError, MemoryError)


def grains(n):
    x, y = np.meshgrid(2e-3 * np.arange(n) + 1e-3, 2e-3 * np.arange(n) + 1e-3)
    return arenite.Packing(x.ravel(), y.ravel(), np.full(n * n, 1e-3), width=2e-3 * n, height=2e-3 * n)


def film():
    t, phase = np.arange(60) / 30.0, np.linspace(0, 1, 48).reshape(1, 6, 8)
    return (
        300
        + 0.1 * phase * np.cos(2 * np.pi * 3 * t)[:, None, None]
        + 0.001 * np.sin(np.arange(60 * 48).reshape(60, 6, 8) ** 1.5)
    )


def small_recipe():
    return arenite.Recipe.template(
        "composite", {"populations.0.count": 6, "populations.1.count": 6, "container.width": "60 mm"}
    )


def things(folder):
    """What a user may have at hand, right and wrong."""
    maps = arenite.lock_in(film(), 3.0, frame_rate=30.0)
    phase = np.full((12, 12), 1)
    phase[4:8, 4:8] = 2
    return [
        None,
        True,
        -1,
        0,
        1,
        7,
        2**31,
        -(2**63),
        0.5,
        1e-3,
        1e300,
        float("nan"),
        float("inf"),
        "",
        "x",
        "1 mm",
        "3 Hz",
        "\x00",
        "a" * 300,
        b"bytes",
        [],
        [1.0, 2.0],
        [[1.0], [2.0]],
        {},
        {"a": 1},
        (0, 0),
        object(),
        np.zeros(0),
        np.eye(4),
        np.full((6, 8), np.nan),
        np.zeros((2, 3, 4)),
        film(),
        grains(1),
        grains(5),
        maps,
        maps.mean,
        arenite.PhaseMap(phase, dx=1e-3),
        small_recipe(),
        os.fspath(folder),
        os.fspath(folder / "none.h5"),
        lambda *_: None,
    ]


def functions():
    names = [name for name in dir(arenite._core) if not name.startswith("_") and callable(getattr(arenite._core, name))]
    return [
        name
        for name in names
        if not isinstance(getattr(arenite._core, name), type)
        or not issubclass(getattr(arenite._core, name), BaseException)
    ]


@pytest.mark.parametrize("name", functions())
def test_it_answers_or_refuses(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    given = things(tmp_path)
    called = getattr(arenite._core, name)
    child = os.fork()  # a fault ends this process alone
    if child == 0:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stderr.fileno())
        signal.alarm(120)
        status = 0
        choose = random.Random(name)
        for _ in range(attempts):
            try:
                called(*(choose.choice(given) for _ in range(choose.randrange(5))))
            except refusals:
                pass
            except BaseException:
                status = 3
        os._exit(status)
    _, ended = os.waitpid(child, 0)
    assert not os.WIFSIGNALED(ended), f"{name} ended the interpreter by signal {os.WTERMSIG(ended)}"
    assert os.WEXITSTATUS(ended) == 0, f"{name} raised what is no refusal"


def test_a_field_between_points_of_a_given_spacing():
    field = arenite.coarse_grained(grains(5), 0.002, 0.001)
    assert field["solid_fraction"].shape == (len(field["y"]), len(field["x"]))
