"""Films of stored states: what is drawn of each, and the files."""

import os
import stat
import types

import arenite
import numpy as np
import pytest
from arenite import animate
from arenite.figures import motion, moving, saving
from arenite.figures.shots import shots_of

PIL = pytest.importorskip("PIL.Image")


def a_packing(shift=0.0, tilt=0.0, periodic="", omega=0.0):
    """Three grains in a row, pressed, in a box of 4 by 4; `shift` moves them to the right."""
    own = arenite.Packing(
        [0.5 + shift, 1.5 + shift, 2.5 + shift],
        [1, 1, 3.8],
        [0.5, 0.5, 0.4],
        width=4,
        height=4,
        thickness=0.1,
        periodic=periodic,
        contacts={"i": [0], "j": [1], "fn": [10.0], "ft": [3.0]},
    )
    names = ("x", "y", "radius", "material", "materials", "contacts", "vx", "vy")
    told = {name: getattr(own, name) for name in names}
    return Shown(own, domain={**own.domain, "tilt": tilt}, angle=np.array([omega, 0.0, 0.0]), **told)


class Shown(types.SimpleNamespace):
    def __init__(self, own, **told):
        super().__init__(own=own, **told)

    def __len__(self):
        return len(self.own)


def own(packing):
    return getattr(packing, "own", packing)


@pytest.fixture(autouse=True)
def numbers_of_the_packing_behind(monkeypatch):
    """The module measures its own packings, which what is shown here stands for."""
    monkeypatch.setattr(
        motion,
        "_core",
        types.SimpleNamespace(
            _grain_quantities=arenite._core._grain_quantities,
            grain_values=lambda packing, name: arenite.grain_values(own(packing), name),
            mobilisation=lambda packing, friction: arenite.mobilisation(own(packing), friction),
            _sizes_of_displacements=lambda packings, strain: arenite._core._sizes_of_displacements(
                [own(one) for one in packings], strain
            ),
            _mean_radius=lambda packing: arenite._core._mean_radius(own(packing)),
            _rotations=lambda packings: [one.angle - packings[0].angle for one in packings],
            _at_time=arenite._core._at_time,
            _force_scale=lambda stage, state: arenite._core._force_scale(own(state.packing)),
        ),
    )


def a_result(*packings, asked=None, **history):
    n = len(packings)
    frames = [
        types.SimpleNamespace(time=float(k), label=f"{k + 1} of {n}", packing=packing)
        for k, packing in enumerate(packings)
    ]
    columns = {"time": np.arange(n, dtype=float), **{name: np.array(values, float) for name, values in history.items()}}
    return types.SimpleNamespace(
        stages=[
            types.SimpleNamespace(
                name="shear",
                snapshots=frames,
                history=columns,
                history_units={name: "1" for name in columns},
                asked=asked or {},
            )
        ]
    )


def test_stresses_and_contacts_of_grains_are_those_of_the_module(result):
    shot = shots_of(result)[-1]
    measured = arenite.measure_grains(shot.packing)
    values = {by: motion.colourings[by].values([shot])[0] for by in ("pressure", "z", "deviator")}
    assert values["pressure"] == pytest.approx(-measured["sigma_hyd"], rel=1e-9, abs=1e-9)
    assert np.all(values["z"] >= measured["contacts"])  # walls count here
    assert np.all(values["deviator"] >= 0)


def test_mobilised_friction_is_over_that_of_the_stage():
    shot = shots_of(a_result(a_packing(), a_packing(), asked={"friction": 0.6}))[0]
    assert motion.mobilisation(shot) == pytest.approx([0.5, 0.5, 0])
    shot = shots_of(a_result(a_packing(), a_packing(), asked={"friction": 0.0}))[0]
    assert motion.mobilisation(shot) == pytest.approx([0, 0, 0])


def test_displacements_go_on_across_periodic_sides():
    ways = motion.displacements(
        shots_of(a_result(a_packing(0, periodic="x"), a_packing(1.5, periodic="x"), a_packing(-1, periodic="x")))
    )
    assert ways[1] == pytest.approx([1.5] * 3) and ways[2] == pytest.approx([3.0] * 3)


def test_displacements_and_rotations_count_from_the_first_state_of_their_stage():
    packings = [a_packing(k, periodic="x", omega=0.1 * k) for k in range(4)]
    one, two = a_result(*packings[:2]), a_result(*packings[2:])
    two.stages[0].name = "second"
    shots = shots_of(types.SimpleNamespace(stages=[*one.stages, *two.stages]))
    assert [way[0] for way in motion.displacements(shots)] == pytest.approx([0, 1, 0, 1])
    assert [turned[0] for turned in motion.colourings["rotation"].values(shots)] == pytest.approx([0, 0.1, 0, 0.1])


def test_images_of_a_sheared_cell_lie_aside():
    index, x, y = motion.with_images(a_packing(periodic="xy", tilt=1.0))
    images = [(i, round(float(a), 6), round(float(b), 6)) for i, a, b in zip(index, x, y)][3:]
    assert (2, 1.5, -0.2) in images  # of the grain at (2.5, 3.8), which reaches over the top
    assert len(motion.with_images(a_packing())[0]) == 3


def test_what_was_drawn_can_be_taken_away():
    axes = saving.Canvas().add_subplot()
    for artist in motion.draw_shot(
        axes, shots_of(a_result(a_packing(), a_packing()))[0], "material", mean=5.0, spoked=True
    ):
        artist.remove()
    assert not axes.collections and not axes.patches


def test_limits_hold_all_states_but_the_rarest():
    pressure, rotation = motion.colourings["pressure"], motion.colourings["rotation"]
    assert motion.limits_of(pressure, [np.arange(101.0)]) == (0, pytest.approx(99))
    low, high = motion.limits_of(rotation, [np.linspace(-3, 1, 101)])
    assert low == -high and high == pytest.approx(2.96, abs=0.05)
    assert motion.limits_of(pressure, [np.arange(5.0)], low=1, high=2) == (1, 2)
    assert motion.limits_of(pressure, [np.zeros(5)])[1] > 0


@pytest.mark.parametrize("by", animate.colourings)
def test_every_colouring_is_drawn(by):
    assert set(animate.colourings) == set(motion.colourings)
    shots = shots_of(a_result(a_packing(), a_packing(0.2, omega=1.0), asked={"friction": 0.5}))
    pictures = moving.Pictures(shots, by, chains=True, size=(200, 200))
    first, second = (pictures.image(k).copy() for k in (0, 1))
    assert first.shape == (200, 200, 4) and np.any(first != second)


def test_a_gif_has_a_picture_a_state(tmp_path):
    told = []
    path = animate.save(
        a_result(*(a_packing(0.1 * k) for k in range(4))),
        tmp_path / "a.gif",
        size=(201, 160),
        fps=5,
        progress=lambda share, name: told.append(share),
    )
    film = PIL.open(path)
    assert film.n_frames == 4 and film.size == (200, 160) and film.info["duration"] == 200 and told[-1] == 1


def test_a_mark_moves_along_the_curve():
    stage = a_result(a_packing(), a_packing(0.2)).stages[0]
    beside = moving.Beside(None, ("time", "load"))
    beside.axes, beside.stage = saving.Canvas().add_subplot(), None
    line = {"colour": "strong", "line": "solid", "x": [0.0, 1.0], "y": [5.0, 7.0]}
    panel = {"x": {"label": "time", "unit": "s"}, "y": {"label": "load"}, "series": [line]}
    beside.panels = {"shear": {**panel, "now": {"x": [0.0, 1.0], "y": [5.0, 7.0]}}}
    for k, load in enumerate((5.0, 7.0)):
        beside.show(types.SimpleNamespace(stage=stage, snapshot=stage.snapshots[k]))
        assert [float(v[0]) for v in beside.mark.get_data()] == [k, load]


def test_without_ffmpeg_it_is_a_gif(tmp_path, monkeypatch):
    monkeypatch.setattr(animate, "has_ffmpeg", lambda: False)
    assert (
        animate.save(a_result(a_packing(), a_packing(0.1)), tmp_path / "a.mp4", size=(100, 100)) == tmp_path / "a.gif"
    )


def test_ffmpeg_is_given_every_state(tmp_path, monkeypatch):
    """A stand-in takes the bytes, so that this is seen where ffmpeg is not installed."""
    program = tmp_path / "ffmpeg"
    program.write_text('#!/bin/sh\nfor last; do :; done\ncat > "$last"\n')
    program.chmod(program.stat().st_mode | stat.S_IXUSR)
    monkeypatch.setenv("PATH", f"{tmp_path}{os.pathsep}{os.environ['PATH']}")
    path = animate.save(a_result(*(a_packing(0.1 * k) for k in range(3))), tmp_path / "a.mp4", size=(120, 100))
    assert path.suffix == ".mp4" and path.stat().st_size == 3 * 4 * 120 * 100


def test_bad_requests_are_refused_in_one_sentence(tmp_path, capsys):
    film = a_result(a_packing(), a_packing(0.1))
    for options, sentence in (
        ({"by": "taste"}, "by: .*taste.*material"),
        ({"colour_map": "no"}, "no colour map no"),
        ({"fps": 0}, "fps: .*from 0.01 to 100"),
        ({"size": (5, 5)}, "size: .*100 to 4000 pixels"),
        ({"stage": "other"}, "no stage other; there are shear"),
        ({"by": "velocity", "high": -1}, "velocity, which is never below 0, cannot end at -1"),
        ({"by": "pressure", "low": 2, "high": 1}, "cannot go from 2 to 1"),
    ):
        with pytest.raises(ValueError, match=sentence):
            animate.save(film, tmp_path / "a.gif", **options)
    with pytest.raises(ValueError, match="ends in .mp4 or .gif"):
        animate.save(film, tmp_path / "a.avi")
    with pytest.raises(ValueError, match="one stored state"):
        animate.save(a_result(a_packing()), tmp_path / "a.gif")
    assert animate.main(str(tmp_path / "nothing"), curve="a") == 2
    said = capsys.readouterr().err
    assert said.startswith("arenite: ") and said.count("\n") == 1
