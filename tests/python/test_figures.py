import os
import subprocess
import sys
import types

import arenite
import arenite.figures as figures
import pytest
from arenite.figures import catalogue


def test_every_figure_of_a_run_is_drawn_and_embeds_its_fonts(result, tmp_path):
    paths = figures.save_all(result, tmp_path, ("pdf", "svg"))
    names = {p.stem for p in paths}
    for name in ["rest-packing", "rest-force-network", "rest-contact-directions", "rest-sigma-norm", "rest-forces", "tension-stress", "tension-stress-pdf", "tension-convergence"]:
        assert name in names
    for path in paths:
        bytes = path.read_bytes()
        assert len(bytes) > 2000
        if path.suffix == ".pdf":
            assert bytes.startswith(b"%PDF") and (b"/FontFile2" in bytes or b"/Type /Font" not in bytes)


def test_the_same_result_gives_the_same_bytes(result, tmp_path):
    a, = figures.save_all(result, tmp_path / "a", ("pdf",), ["coordination"])
    b, = figures.save_all(result, tmp_path / "b", ("pdf",), ["coordination"])
    assert a.read_bytes() == b.read_bytes()


def test_widths_are_those_of_columns(result, tmp_path):
    (one,) = figures.save_all(result, tmp_path, ("svg",), ["coordination"])
    assert f'width="{72 * figures.column_width:g}pt"' in one.read_text()


def test_the_command_draws(result, tmp_path):
    run = subprocess.run([os.environ["ARENITE"], "figures", result.path, "--out", str(tmp_path), "--format", "png", "--only", "packing", "--width", "60 mm"], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert (tmp_path / "rest-packing.png").exists()


def test_bad_requests_are_refused_in_one_sentence(result, tmp_path):
    with pytest.raises(ValueError, match="no figure"):
        figures.save_all(result, tmp_path, names=["nothing"])
    run = subprocess.run([sys.executable, "-m", "arenite.figures", str(tmp_path)], capture_output=True, text=True, env={**os.environ, "PYTHONPATH": os.environ["ARENITE_PYTHONPATH"]})
    assert run.returncode == 2 and run.stderr.count("\n") == 1 and "Traceback" not in run.stderr


def test_directions_of_a_film_and_its_simulation_are_on_one_scale():
    sets = {"film": {"contacts": 18, "sectors": [1] * 18}, "twin": {"contacts": 18, "sectors": [3, 1, 0] * 4 + [0, 0, 0, 0, 0, 2]}}
    canvas = catalogue.Canvas()
    catalogue.film_roses(canvas, types.SimpleNamespace(numbers={"directions": sets}))
    film, simulation = canvas.axes
    assert film.get_title() == "film (18)" and simulation.get_title() == "simulation (18)"
    assert film.get_ylim() == simulation.get_ylim() == (0, pytest.approx(3.15))


def test_tails_of_a_film_are_those_of_the_stresses_that_it_gives(result):
    packing = result.stages[-1].packing
    sigma = arenite.measure_grains(packing)["sigma_hyd"]
    canvas = catalogue.Canvas()
    catalogue.film_tails(canvas, types.SimpleNamespace(packing=packing, sigma_hyd=sigma, twin={"swing": 2 * sigma, "state": sigma**2}))
    film, swing, state = [line for line in canvas.axes[0].lines if not line.get_label().startswith("_")]
    assert [line.get_label() for line in (film, swing, state)] == ["film", "simulation, swing", "simulation, state"]
    assert film.get_xydata() == pytest.approx(swing.get_xydata())  # over their means
    stored = arenite.measure(packing)["sigma_norm"]
    shown = [x for x, y in zip(stored["cumulative"]["x"], stored["cumulative"]["y"]) if y >= 0.7 / stored["count"]]
    assert list(film.get_xdata()) == pytest.approx(shown)
    assert len(state.get_xdata()) != len(shown) or list(state.get_xdata()) != pytest.approx(shown)


def test_broken_bonds_are_counted_by_type_up_to_each_step():
    canvas = catalogue.Canvas()
    axes = canvas.add_subplot()
    part = types.SimpleNamespace(curve={"broken": [0, 2, 5]}, cracks={"type": catalogue.np.array([1, 1, 2, 3, 1])})
    figures.draw_broken_bonds(axes, part)
    assert {line.get_label(): list(line.get_ydata()) for line in axes.lines} == {"matrix": [0, 2, 3], "interface": [0, 0, 1], "particle": [0, 0, 1]}
