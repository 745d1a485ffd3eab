"""What single figures and pictures show of fields, films and packings."""

import os
import subprocess
import sys
import types

import arenite
import arenite.figures as figures
import numpy as np
import pytest
from arenite import _core
from arenite.figures import fields, films, packings, panels, samples, saving
from arenite.figures.shots import Shot
from empty_axes import axes
from test_pages import content_of


def scaled(by, component, values, mean=None):
    """Three nodes by what the statistics of a field say of sigma_yy only."""
    number = {"mean": {"sample_mean_Pa": {"value": -2.0}}, "root mean square": {"root_mean_square_Pa": {"value": 8.0}}}
    stored, quantities = {"sigma_yy": {"normalised_by": by, **number[by]}}, _core._field_quantities()
    return fields.scale_in(
        np.array(values), component, quantities, lambda: fields.unit_in(stored, quantities), lambda: mean
    )


def test_stresses_are_centred_where_their_statistics_say():
    values, centre, label = scaled("mean", "sigma_yy", [-2.0, -4.0, np.nan])
    assert values[:2].tolist() == [1, 2] and np.isnan(values[2]) and centre == 1 and label.endswith("over its mean")
    values, centre, label = scaled("root mean square", "sigma_yy", [-2.0, -4.0, -6.0])
    assert values[:2].tolist() == [-0.25, -0.5] and centre == 0 and label.endswith("over its r.m.s.")
    values, centre, label = scaled("mean", "sigma_xx", [4.0, 0.0, 2.0], 3.0)
    assert values[:2].tolist() == [2, 0] and centre == 1.5 and "yy" in label  # tension stays positive


def test_the_tile_the_page_and_print_have_one_mean(result, tmp_path):
    arenite.page(result, tmp_path / "page.html")
    field = result.fields[-1]
    tile = field.numbers["stress"]["sigma_yy"]["sample_mean_Pa"]["value"]
    on_page = content_of(tmp_path / "page.html")["fields"][-1]
    assert on_page["components"]["sigma_yy"]["mean"] == on_page["quantities"]["yy"]["mean"] == tile
    assert on_page["scale"] == pytest.approx(abs(tile))
    assert fields.unit_of(field)[0] == _core._field_mean(field, "sigma_yy") == tile
    assert field.sigma_yy[field.map.phase > 0].mean() != pytest.approx(tile, rel=1e-6)  # which the clamp rows shift


def test_the_colours_of_a_stress_lie_evenly_about_its_mean(result):
    field = result.fields[-1]
    for component in ("sigma_yy", "sigma_xy"):
        low, high = figures.draw_field(axes(), field, component).get_clim()
        mean = field.numbers["stress"]["sigma_yy"]["sample_mean_Pa"]["value"]
        assert (low + high) / 2 == pytest.approx(
            1 if component == "sigma_yy" else _core._field_mean(field, component) / mean, abs=1e-6
        )


def test_cavities_are_those_that_are_stored(result):
    field = result.fields[-1]
    (shown,) = figures.describe(field)["cavities"]
    for kind, series in zip(("pores", "voids"), shown["panels"][0]["series"]):
        assert series["y"] == [y for y in field.numbers[kind]["pdf"]["density"] if y > 0]
    assert [entry["name"] for entry in shown["key"]] == [
        f"{kind} {field.numbers[kind]['count']}" for kind in ("pores", "voids")
    ]
    on = axes()
    figures.draw_panel(on, shown["panels"][0])
    assert on.get_xscale() == on.get_yscale() == "log" and on.get_ylabel() == "probability density"


def test_densities_have_a_file_for_each_component_and_rows_over_the_sample_and_the_phase(result, tmp_path):
    found = [
        (f.name, f) for f, part in figures.figures_of(result) if f.kind == "field" and f.name.startswith("stress-pdf")
    ]
    assert {name for name, _ in found} <= {"stress-pdf"} | {f"stress-pdf-{name}" for name in ("xx", "xy", "hyd")}
    canvas = saving.Canvas()
    dict(found)["stress-pdf"].draw(canvas, result.fields[-1])
    scales = [a.get_yscale() for a in canvas.axes if a.axison]
    assert scales == ["linear", "log"] * 2


def test_a_map_that_was_loaded_shows_its_phases_and_cavities(result):
    field = arenite.load(result.fields[0].map, tolerance=1e-2)
    alone = types.SimpleNamespace(stages=[], fields=[field, field], films=[], voxels=[], spheres=[])
    names = [figure.name for figure, _ in figures.figures_of(alone)]
    assert names.count("phases") == names.count("cavities") == 1 and names.count("stress") == 2


def test_forces_across_a_periodic_side_are_seen_from_both_grains():
    packing = arenite.propose_contacts(
        arenite.Packing([1e-3, 9.1e-3], [5e-3, 5e-3], [1e-3, 1e-3], width=1e-2, height=1e-2, periodic="x"),
        position_error=1e-5,
    )
    here, there = packings.segments(packing)
    ends = sorted(float(end[0, 0]) for end in (*here, *there))
    assert ends == pytest.approx([-0.9e-3, 1e-3, 9.1e-3, 11e-3], abs=2e-5)


def test_kinds_of_forces():
    force, doubtful = np.array([0.5, 2.0, -0.1, -1e-4, 3.0]), np.array([False, False, False, False, True])
    kinds = packings.kinds_of(force, (1.0, -1e-3), doubtful)
    assert list(kinds) == ["weak", "strong", "tension", "weak", "may be absent"]


def test_roses_are_of_all_of_strong_and_weak_contacts_and_of_types(result):
    state = next(part for _, part in figures.figures_of(result))
    (shown,) = figures.describe(state)["fabric"]
    assert [rose["name"] for rose in shown["roses"]][:3] == ["all", "strong", "weak"] and len(shown["roses"]) > 3
    strong = arenite.measure(state.packing)["fabric"]["sets"]["strong"]
    isotropic = shown["roses"][0]["count"] / len(strong["sectors"])
    assert shown["roses"][0]["inner"] == pytest.approx([n / isotropic for n in strong["sectors"]])
    assert shown["roses"][1]["count"] == strong["contacts"]
    canvas = saving.Canvas()
    figures.draw_described(canvas, [shown])
    assert all(a.get_xlabel().startswith(r"$a_\mathrm{c}$ = ") for a in canvas.axes)


def test_the_fit_of_a_film_is_drawn_with_the_root_mean_squares_of_the_library(monkeypatch):
    maps = {name: (np.full((2, 2), value), value) for name, value in (("measured", 3e-3), ("fitted", 2e-3))}
    maps["residual"] = (np.full((2, 2), np.nan), np.nan)
    said = _core._film_maps()
    core = types.SimpleNamespace(_fit_maps=lambda film: maps, _film_maps=lambda film: said, _ends_of=_core._ends_of)
    monkeypatch.setattr(films, "_core", core)
    figure = saving.Canvas()
    films.draw_fit(figure, types.SimpleNamespace(pixel=1e-3))
    titles = [a.get_title() for a in figure.axes]
    assert titles[:3] == ["measured, r.m.s. 3 mK", "from forces, r.m.s. 2 mK", "misfit"]


def a_film(amplitude=1.0):
    """Two by two pixels whose signal is late by a quarter, on time, opposite, and lost in noise."""
    size = (2, 2)
    maps = types.SimpleNamespace(
        phase_after_load=np.array([[0.5, 0.0], [np.pi, 2.5]]),
        amplitude=np.array([[amplitude] * 2, [amplitude, 0.01]]),
        standard_error=np.full(size, 0.02),
        in_phase=np.array([[0.1, 0.4], [-0.2, 0.0]]),
        second_harmonic=np.zeros((0, 2)),
        residual=np.ones(size),
    )
    return types.SimpleNamespace(picture=np.full(size, 300.0), maps=maps, pixel=1e-3, bad=np.array([[0, 1], [0, 0]]))


def test_phases_of_a_film_lost_in_noise_are_pale():
    shown = axes()
    figures.draw_phase(shown, a_film().maps)
    colours = shown.images[0].get_array()
    assert colours[1, 1].min() > 0.8 > colours[0, 0].min()  # pale where noise hides it


def drawn_maps(monkeypatch, film, unit):
    """Its maps in print, of a film in this unit."""
    values = {
        "picture": film.picture,
        "amplitude": film.maps.amplitude,
        "phase": np.degrees(film.maps.phase_after_load),
        "in_phase": film.maps.in_phase,
        "fitted": film.maps.in_phase,
        "standard_error": film.maps.standard_error,
        "residual": film.maps.residual,
        "bad": film.picture,
    }
    said = {
        name: {
            **words,
            "unit": words["unit"] and unit,
            "values": values[name],
            "ends": _core._ends_of(np.ravel(values[name]), 0),
        }
        for name, words in _core._film_maps().items()
        if name in values
    }
    core = types.SimpleNamespace(
        _film_maps=lambda film=None: said if film else _core._film_maps(),
        _faint_below=_core._faint_below,
        _ends_of=_core._ends_of,
    )
    monkeypatch.setattr(films, "_core", core)
    canvas = saving.Canvas()
    panels.film_maps(canvas, film)
    return canvas, [a.get_title().replace("\n", " ") for a in canvas.axes if a.get_title()]


def test_maps_of_a_film_are_those_that_it_holds_in_the_words_of_the_library(monkeypatch):
    levels = drawn_maps(monkeypatch, a_film(), "DL")[1]
    assert [title for title in levels if title.endswith(", DL")] == [
        "image at the smallest load, DL",
        "amplitude, DL",
        "warming with the load, DL",
        "warming predicted from the contact forces, DL",
        "standard error of the signed amplitude, DL",
        "residual of the fit, DL",
    ]
    monkeypatch.undo()
    canvas, titles = drawn_maps(monkeypatch, a_film(), "K")
    assert titles == [
        "image at the smallest load, K",
        "amplitude, K",
        "phase relative to the load, °",
        "warming with the load, mK",
        "warming predicted from the contact forces, mK",
        "standard error of the signed amplitude, mK",
        "residual of the fit, K",
        "1 pixels replaced",
    ]
    (signed,) = [a.images[0] for a in canvas.axes if a.get_title().startswith("warming with")]
    low, high = signed.get_clim()
    assert low == -high and high > 300


def test_numbers_of_another_shape_are_one_sentence(tmp_path):
    packing = arenite.Packing([1, 2, 3], [1, 1, 1], [0.5, 0.5, 0.5], width=4, height=2)
    (file,) = arenite.save(packing, tmp_path)
    program = (
        "import json, sys, arenite.figures.catalogue as c\nc.save_all = lambda *a: {}['mean']\n"
        "sys.argv = ['figures', json.dumps({'result': sys.argv[1]})]\n"
        "import runpy; runpy.run_module('arenite.figures', run_name='__main__')"
    )
    done = subprocess.run(
        [sys.executable, "-c", program, file],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": os.environ["ARENITE_PYTHONPATH"]},
    )
    assert (
        done.returncode == 2 and done.stderr.count("\n") == 1 and "compute the result again" in done.stderr
    ), done.stderr


def test_stored_states_lie_on_the_travel_of_the_wall(result):
    stage = result.stages[-1]
    state = figures.State(stage.name, stage, stage.snapshots[-1], [stage])
    (shown,) = figures.describe(state)["travel"]
    assert len(stage.frames) == len(stage.snapshots)  # the former name
    on = axes()
    figures.draw_panel(on, shown["panels"][0])
    line, states = on.lines
    assert len(states.get_xdata()) == len(stage.snapshots) and states.get_xdata()[-1] == pytest.approx(
        line.get_xdata()[-1], abs=1e-3 * np.ptp(line.get_xdata())
    )


def test_the_size_curve_is_by_mass_and_keeps_to_the_law():
    text = """[materials.glass]
density = "2500 kg/m^3"
stiffness = "1 kN/mm"
[[populations]]
material = "glass"
count = 400
size = { law = "uniform", min = "1 mm", max = "3 mm" }
[packing]
method = "random"
solid_fraction = 0.4
[container]
width = "70 mm"
thickness = "10 mm"
[[stages]]
name = "press"
top = { pressure = "1 kPa" }
"""
    recipe = arenite.Recipe.from_text(text)
    asked = arenite.asked_size_curve(recipe)
    d = np.array([1.5e-3, 2e-3, 2.5e-3])
    share = (d**3 - 1e-9) / (27e-9 - 1e-9)  # of the mass, as d^2, of diameters spread evenly
    assert np.interp(d, asked["diameter"], asked["passing"]) == pytest.approx(share, abs=0.01)
    packing = arenite.pack(recipe)
    measured = arenite.size_curve(packing)
    whole = np.sum(packing.radius**2)
    assert [np.interp(x, measured["diameter"], measured["passing"]) for x in d] == pytest.approx(
        [np.sum(packing.radius[2 * packing.radius <= x] ** 2) / whole for x in d], abs=0.012
    )
    assert measured["passing"][-1] == pytest.approx(1)


def test_fields_are_those_of_the_state(result):
    state = next(part for _, part in figures.figures_of(result))
    fields = samples.fields_of(state)
    picture, label = figures.draw_coarse_field(axes(), fields, "solid_fraction")
    assert np.asarray(picture.get_array()) == pytest.approx(fields["solid_fraction"]) and label == "Solid fraction φ"
    stress = arenite.coarse_grained(state.packing, fields["x"][1] - fields["x"][0])
    if len(stress["x"]) == len(fields["x"]):
        whole = stress["contact_stress"] + stress["kinetic_stress"]
        pressure = -0.5 * np.trace(whole, axis1=-2, axis2=-1)
        assert np.nanmean(fields["pressure"]) == pytest.approx(np.nanmean(pressure), rel=0.05)
    shown = axes()
    figures.draw_grains_against(shown, Shot(state.stage, state.snapshot))
    assert sum(len(line.get_xdata()) for line in shown.lines) == len(state.packing)
