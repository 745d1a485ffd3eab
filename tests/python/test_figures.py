import html
import json
import logging
import os
import pathlib
import re
import subprocess
import sys
import types

import arenite
import arenite.figures as figures
import numpy as np
import pytest
from arenite.figures import (
    catalogue,
    densities,
    fields,
    film_forces,
    films,
    histories,
    loadings,
    motion,
    packings,
    panels,
    samples,
    saving,
    style,
)

# The figures of the page by their ids, and the journal's: of a stage, a field or a film.
cards = {
    "fabric": ("stage", "contact-orientations"),
    "sigma-norm": ("stage", "sigma-norm"),
    "forces": ("stage", "forces"),
    "coordination": ("stage", "coordination"),
    "grain-scatter": ("stage", "grain-scatter"),
    "size-curve": ("stage", "size-curve"),
    "coarse-fields": ("stage", "coarse-fields"),
    "contact-numbers": ("stage", "contact-numbers"),
    "rev": ("stage", "rev"),
    "threshold": ("stage", "threshold"),
    "stress-path": ("stage", "stress-path"),
    "wall-forces": ("stage", "wall-forces"),
    "travel": ("stage", "travel"),
    "energies": ("stage", "energies"),
    "equilibrium": ("stage", "equilibrium"),
    "test-curves": ("stage", "stress-strain"),
    "grain-bonds": ("stage", "broken-bonds"),
    "discharge": ("stage", "discharge"),
    "stress-strain": ("field", "stress-strain"),
    "broken-bonds": ("field", "broken-bonds"),
    "energy-balance": ("field", "energy-balance"),
    "stress-pdf": ("field", "stress-pdf"),
    "cavities": ("field", "cavities"),
    "convergence": ("field", "convergence"),
    "film-maps": ("film", "beside-simulation"),
    "film-fit": ("film", "film-fit"),
    "film-simulation": ("film", "against-simulation"),
    "film-tails": ("film", "tails"),
    "film-orientations": ("film", "contact-orientations"),
    "film-forces": ("film", "forces"),
    "film-certainty": ("film", "certainty"),
    "film-stresses": ("film", "stresses"),
}
# What the page shows in its pictures and not on cards.
pictures = {
    ("stage", "packing"),
    ("stage", "sigma-norm-map"),
    ("stage", "force-network"),
    ("stage", "cracks"),
    ("field", "phases"),
    ("field", "stress"),
    ("field", "displacement"),
    ("field", "cracks"),
    ("film", "maps"),
    ("film", "grains"),
    ("film", "force-network"),
}
# What the page has no cards of.
printed = {("stage", "cycles")}
components = {("field", f"stress-pdf-{name}") for name in ("xx", "xy", "hyd")}


def axes():
    return saving.Canvas().add_subplot()


def test_every_card_of_the_page_has_its_figure():
    page = pathlib.Path(__file__).resolve().parents[2] / "web/src/figures"
    ids = [
        name for file in page.glob("*.js") for name in re.findall(r'^  id: "([a-z-]+)",\s+title:', file.read_text(), re.M)
    ]
    assert sorted(ids) == sorted(cards)
    assert {(figure.kind, figure.name) for figure in figures.figures} == set(
        cards.values()
    ) | pictures | printed | components


@pytest.fixture(scope="module")
def drawn(result, tmp_path_factory):
    """All figures of a run."""
    return figures.save_all(result, tmp_path_factory.mktemp("figures"), ("pdf", "svg"))


def test_every_figure_of_a_run_is_drawn_and_embeds_its_fonts(drawn):
    stage = {name for kind, name in set(cards.values()) | pictures | printed if kind == "stage"} - {
        "stress-path",
        "cycles",
        "stress-strain",
        "discharge",
        "size-curve",
        "broken-bonds",
        "cracks",
    }
    field = {"stress", "displacement", "stress-pdf", "convergence"}
    expected = (
        {f"rest-{name}" for name in stage}
        | {"cement-phases", "cement-cavities"}
        | {f"tension-{name}" for name in field}
    )
    assert {p.stem for p in drawn} - {f"tension-{name}" for _, name in components} - {"rest-stress-path"} == expected
    for path in drawn:
        content = path.read_bytes()
        assert len(content) > 2000
        if path.suffix == ".pdf":
            assert content.startswith(b"%PDF") and (b"/FontFile2" in content or b"/Type /Font" not in content)
        else:
            assert not re.search("[\ue000-\uf8ff]", html.unescape(content.decode()))  # letters that only one font has


def test_formulas_in_an_svg_are_the_letters_that_are_meant(result, tmp_path):
    (path,) = figures.save_all(result, tmp_path, "svg", "sigma-norm")
    letters = "".join(re.findall(r"<tspan[^>]*>([^<]*)<", html.unescape(path.read_text())))
    assert "σ" in letters and "β" in letters and "norm" in letters


def test_former_names_of_figures_are_read_with_a_notice(result, tmp_path):
    with pytest.warns(FutureWarning, match="contact-directions is now called contact-orientations"):
        (path,) = figures.save_all(result, tmp_path, "svg", "contact-directions")
    assert path.stem == "rest-contact-orientations"
    assert figures.draw_course is figures.draw_stress_path and figures.draw_rest is figures.draw_equilibrium


def test_the_same_result_gives_the_same_bytes(result, drawn, tmp_path):
    again = figures.save_all(
        result, tmp_path, ("pdf", "svg"), ["force-network", "contact-orientations", "cavities", "stress-pdf"]
    )
    first = {path.name: path for path in drawn}
    assert len(again) == 8 and all(path.read_bytes() == first[path.name].read_bytes() for path in again)


def test_widths_are_those_of_columns(result, tmp_path):
    (one,) = figures.save_all(result, tmp_path, ("svg",), ["coordination"])
    assert f'width="{72 * figures.column_width:g}pt"' in one.read_text()


def test_the_command_draws(result, tmp_path):
    run = subprocess.run(
        [
            os.environ["ARENITE"],
            "figures",
            result.path,
            "--out",
            str(tmp_path),
            "--format",
            "png",
            "--only",
            "packing",
            "--width",
            "60 mm",
        ],
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stderr
    assert (tmp_path / "rest-packing.png").exists()


def test_files_of_the_current_folder_are_not_run(result, tmp_path):
    (tmp_path / "json.py").write_text("import pathlib\npathlib.Path('ran').touch()\n")
    for line in (
        ["figures", result.path, "--out", "f", "--format", "png", "--only", "packing"],
        ["compare", result.path, result.path, "--out", "c.html"],
    ):
        run = subprocess.run([os.environ["ARENITE"], *line], cwd=tmp_path, capture_output=True, text=True)
        assert run.returncode == 0, run.stderr
    assert not (tmp_path / "ran").exists()


def test_files_are_whole_or_not_there(result, tmp_path):
    (tmp_path / "compare.html").write_text("before")
    for line in (
        f"figures {result.path} --out {tmp_path} --format png --only packing",
        f"compare {result.path} {result.path} --out {tmp_path}/compare.html",
    ):
        run = subprocess.run(
            ["bash", "-c", f"ulimit -f 1; exec {os.environ['ARENITE']} {line}"], capture_output=True, text=True
        )
        assert run.returncode == 2 and run.stderr.count("\n") == 1 and "cannot be written" in run.stderr, run.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["compare.html"] and (
        tmp_path / "compare.html"
    ).read_text() == "before"
    full = subprocess.run(
        [
            "bash",
            "-c",
            f"exec {os.environ['ARENITE']} compare {result.path} {result.path} --out {tmp_path}/c.html > /dev/full",
        ],
        capture_output=True,
        text=True,
    )
    assert full.returncode == 2 and full.stderr.count("\n") == 1, full.stderr


def test_names_are_no_formulas(tmp_path):
    packing = arenite.Packing(
        [1e-3, 3e-3],
        [1e-3, 1e-3],
        [1e-3, 1e-3],
        width=4e-3,
        height=2e-3,
        material=[0, 1],
        materials=[arenite.Material("$_{$"), arenite.Material("$a")],
    )
    figure = catalogue.Figure("key", "stage", lambda canvas, part: packings.material_key(canvas.add_subplot(), part))
    saving.save(figure, packing, tmp_path / "key.svg")
    assert (tmp_path / "key.svg").stat().st_size > 0


def test_bad_requests_are_refused_in_one_sentence(result, tmp_path):
    with pytest.raises(ValueError, match="no figure nothing; there are packing, "):
        figures.save_all(result, tmp_path, names=["nothing"])
    with pytest.raises(ValueError, match="this result has no figure tails; there are packing, ") as refused:
        figures.save_all(result, tmp_path, names="tails")
    assert "certainty" not in str(refused.value)
    with pytest.raises(ValueError, match="no stage nothing; there are packing, "):
        figures.save_all(result, tmp_path, stage="nothing")
    with pytest.raises(ValueError, match="no stored state 99; this result has"):
        figures.save_all(result, tmp_path, state=99)
    run = subprocess.run(
        [sys.executable, "-m", "arenite.figures", json.dumps({"result": str(tmp_path)})],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": os.environ["ARENITE_PYTHONPATH"]},
    )
    assert run.returncode == 2 and run.stderr.count("\n") == 1 and "Traceback" not in run.stderr


def test_any_stage_and_any_stored_state_may_be_asked_for(result):
    stage = result.stages[1]
    shown = figures.figures_of(result, stage=stage.name)
    assert {part.name for _, part in shown} == {stage.name}
    assert shown[0][1].packing.x == pytest.approx(stage.packing.x)
    first = [part for _, part in figures.figures_of(result, state=1) if isinstance(part, figures.State)]
    assert {part.name for part in first} == {f"{result.stages[0].name}-1"}
    assert first[0].packing.x == pytest.approx(result.stages[0].snapshots[0].packing.x)


def test_libraries_are_quiet_within_the_style_and_as_before_after_it():
    logger = logging.getLogger("fontTools")
    before = logger.level
    with figures.journal_style():
        assert not logger.isEnabledFor(logging.WARNING)
    assert logger.level == before


def test_materials_have_one_colour_in_all_figures():
    names = ["POM", "HDPE"]
    assert [style.colour_of(name, names) for name in ("POM", "HDPE", "POM-POM", "HDPE-POM", "POM-HDPE", "all")] == [
        *style.colours[:2],
        style.colours[0],
        style.colours[2],
        style.colours[2],
        style.strong,
    ]


def a_field(by, value=-2.0):
    """Four nodes; what its statistics say of sigma_yy only."""
    every = {"mean_Pa": {"value": -4.0}, "mean_over_sample_mean": {"value": -4.0 / value}}
    return types.SimpleNamespace(
        numbers={"stress": {"sigma_yy": {"normalised_by": by, "sets": {"all": every}}}},
        map=types.SimpleNamespace(phase=np.array([[1, 2], [2, 0]])),
        sigma_yy=np.array([[-2.0, -4.0], [-6.0, 99.0]]),
        sigma_xx=np.array([[4.0, 0.0], [2.0, 99.0]]),
        sigma_xy=np.zeros((2, 2)),
    )


def test_stresses_are_centred_where_their_statistics_say():
    values, centre, label = fields.scale_of(a_field("mean"), "sigma_yy")
    assert values[0].tolist() == [1, 2] and np.isnan(values[1, 1]) and centre == 1 and label.endswith("over its mean")
    values, centre, label = fields.scale_of(a_field("root mean square", 8.0), "sigma_yy")
    assert values[0].tolist() == [-0.25, -0.5] and centre == 0 and label.endswith("over its r.m.s.")
    values, centre, label = fields.scale_of(a_field("mean"), "sigma_xx")
    assert values[0].tolist() == [2, 0] and centre == 1 and "yy" in label  # tension stays positive
    values, _, _ = fields.scale_of(a_field("mean"), "sigma_1")
    assert values[0].tolist() == [2, 0]


def test_the_colours_of_a_stress_lie_evenly_about_its_mean(result):
    field = result.fields[-1]
    for component in ("sigma_yy", "sigma_xy"):
        low, high = figures.draw_field(axes(), field, component).get_clim()
        mean = field.numbers["stress"]["sigma_yy"]["sample_mean_Pa"]["value"]
        assert (low + high) / 2 == pytest.approx(
            1 if component == "sigma_yy" else field.sigma_xy[field.map.phase > 0].mean() / mean, abs=1e-6
        )


def test_cavities_are_those_that_are_stored(result):
    stored = result.fields[-1].numbers
    shown = axes()
    figures.draw_cavities(shown, stored)
    for kind, line in zip(("pores", "voids"), shown.lines):
        density = [y for y in stored[kind]["pdf"]["density"] if y > 0]
        assert list(line.get_ydata()) == density
    assert [text.get_text() for text in shown.get_legend().get_texts()] == [
        f"{kind} ({stored[kind]['count']})" for kind in ("pores", "voids")
    ]
    assert not densities.has_cavities({"pores": {"count": 0}})


def test_a_map_that_was_loaded_shows_its_phases_and_cavities(result):
    field = arenite.load(result.fields[0].map, tolerance=1e-2)
    alone = types.SimpleNamespace(stages=[], fields=[field, field], films=[])
    names = [figure.name for figure, _ in figures.figures_of(alone)]
    assert names.count("phases") == names.count("cavities") == 1 and names.count("stress") == 2


def test_fits_hold_what_was_counted():
    x, y = densities.q_gaussian_of(
        {"q_gaussian": {"q": {"value": 1.0}, "beta": {"value": 0.5}, "centre": {"value": 1.0}}}, -9, 11
    )
    assert y.max() == pytest.approx(1 / np.sqrt(2 * np.pi), rel=1e-3) and np.trapz(y, x) == pytest.approx(1, rel=1e-3)
    x, y = densities.tail_of({"count": 100, "tail": {"count": 20, "slope": {"value": 2.0}, "low": 1.0, "high": 3.0}})
    assert (x[0], x[-1]) == (1, 3) and np.trapz(y, x) == pytest.approx(0.2, rel=1e-3)
    assert densities.tail_of({"count": 9, "tail": {"count": 1, "low": 1.0}}) is None


def test_other_components_are_drawn_where_they_are_measured(result):
    measured = result.fields[-1].statistics()
    parts = types.SimpleNamespace(
        statistics=lambda: {
            **measured,
            "sigma_xy": {
                "normalised_by": "root mean square",
                "sets": {"all": {"pdf": {"x": [-1, 0, 1], "y": [0.1, 0.5, 0.1]}}},
            },
        }
    )
    assert panels.density_rows(parts, "sigma_xy") == [False]
    assert panels.density_rows(parts, "sigma_yy") == [False, True]
    canvas = saving.Canvas()
    panels.density_panels(canvas, parts, "sigma_xy")
    assert "r.m.s." in canvas.axes[0].get_xlabel() and [a.get_yscale() for a in canvas.axes] == ["linear", "log"]


def test_forces_across_a_periodic_side_are_seen_from_both_grains():
    packing = arenite.propose_contacts(
        arenite.Packing([1e-3, 9.1e-3], [5e-3, 5e-3], [1e-3, 1e-3], width=1e-2, height=1e-2, periodic="x"),
        position_error=1e-5,
    )
    here, there = packings.segments(packing)
    ends = sorted(float(end[0, 0]) for end in (*here, *there))
    assert ends == pytest.approx([-0.9e-3, 1e-3, 9.1e-3, 11e-3], abs=2e-5)


def test_kinds_of_forces():
    kinds = packings.kinds_of(np.array([0.5, 2.0, -0.1, -1e-4, 3.0]), 1.0, np.array([False, False, False, False, True]))
    assert list(kinds) == ["weak", "strong", "tension", "weak", "may be absent"]


def test_roses_are_of_all_of_strong_and_weak_contacts_and_of_types(result):
    state = next(part for _, part in figures.figures_of(result))
    sets = panels.rose_sets(state.texture["fabric"], catalogue.materials(state))
    assert [name for name, *_ in sets][:3] == ["all", "strong", "weak"] and len(sets) > 3
    assert sets[0][2] is state.texture["fabric"]["sets"]["strong"]
    canvas = saving.Canvas()
    panels.roses(canvas, state)
    assert all(a.get_xlabel().startswith(r"$a_{\mathrm{c}}$ = ") for a in canvas.axes)


def test_directions_of_a_film_and_its_simulation_are_on_one_scale():
    sets = {
        "film": {"contacts": 18, "sectors": [1] * 18},
        "simulation": {"contacts": 18, "sectors": [3, 1, 0] * 4 + [0, 0, 0, 0, 0, 2]},
    }
    canvas = saving.Canvas()
    panels.film_roses(canvas, types.SimpleNamespace(numbers={"contact_orientations": sets}))
    film, simulation = canvas.axes
    assert film.get_title() == "film (18)" and simulation.get_title() == "simulation (18)"
    assert film.get_ylim() == simulation.get_ylim() == (0, pytest.approx(3))


def test_tails_of_a_film_are_those_of_the_stresses_that_it_gives(result):
    packing = result.stages[-1].packing
    sigma = arenite.measure_grains(packing)["sigma_hyd"]
    canvas = saving.Canvas()
    panels.film_tails(
        canvas,
        types.SimpleNamespace(
            packing=packing, sigma_hyd=sigma, simulation={"peak_to_peak": 2 * sigma, "state": sigma**2}
        ),
    )
    film, change, state = [line for line in canvas.axes[0].lines if not line.get_label().startswith("_")]
    assert [line.get_label().split(", $")[0] for line in (film, change, state)] == [
        "film",
        "simulation, peak to peak",
        "simulation, state",
    ]
    assert film.get_xydata() == pytest.approx(change.get_xydata())  # over their means
    stored = arenite.measure(packing)["sigma_norm"]
    shown = [x for x, y in zip(stored["cumulative"]["x"], stored["cumulative"]["y"]) if y >= 0.7 / stored["count"]]
    assert list(film.get_xdata()) == pytest.approx(shown)
    assert len(state.get_xdata()) != len(shown) or list(state.get_xdata()) != pytest.approx(shown)
    part = types.SimpleNamespace(packing=packing)
    assert films.normalised(part, 3 * sigma) == pytest.approx(sigma / stored["mean_Pa"]["value"])


def a_film(amplitude=1.0):
    """Two by two pixels whose signal is late by a quarter, on time, opposite, and lost in noise."""
    phase, size = np.array([[1.0, 0.5], [0.5 - np.pi, 3.0]]), (2, 2)
    maps = types.SimpleNamespace(
        phase=phase,
        reference_phase=0.5,
        amplitude=np.array([[amplitude] * 2, [amplitude, 0.01]]),
        standard_error=np.full(size, 0.02),
        in_phase=np.array([[0.1, 0.4], [-0.2, 0.0]]),
        second_harmonic=np.zeros((0, 2)),
        residual=np.ones(size),
    )
    return types.SimpleNamespace(picture=np.full(size, 300.0), maps=maps, pixel=1e-3, bad=np.array([[0, 1], [0, 0]]))


def test_phases_of_a_film_are_those_after_the_load():
    angle = films.phase_after_load(a_film().maps)
    assert (
        angle[0] == pytest.approx([np.degrees(0.5), 0])
        and angle[1, 0] == pytest.approx(180)
        and np.abs(angle).max() <= 180
    )
    shown = axes()
    figures.draw_phase(shown, a_film().maps)
    colours = shown.images[0].get_array()
    assert colours[1, 1].min() > 0.8 > colours[0, 0].min()  # pale where noise hides it


def test_maps_of_a_film_are_those_that_it_holds():
    canvas = saving.Canvas()
    panels.film_maps(canvas, a_film())
    titles = [a.get_title() for a in canvas.axes if a.get_title()]
    assert titles == [
        "smallest load, K",
        "amplitude, mK",
        "phase relative to the load, °",
        "warming with the load, mK",
        "standard error, mK",
        "residual of the fit, mK",
        "1 pixels replaced",
    ]
    (signed,) = [a.images[0] for a in canvas.axes if a.get_title().startswith("warming")]
    low, high = signed.get_clim()
    assert low == -high and high > 300


def a_film_of_forces():
    contacts = types.SimpleNamespace(fn=np.array([100.0, 50.0, 1.0, -3.0, 9.0]), ft=np.zeros(5))
    return types.SimpleNamespace(
        packing=types.SimpleNamespace(contacts=contacts),
        fn_error=np.ones(5),
        ft_error=np.ones(5),
        presence=np.array([1, 1, 0.6, 1, 0.9]),
    )


def test_contacts_that_may_be_absent_are_told_apart():
    film = a_film_of_forces()
    assert list(film_forces.uncertain(film)) == [False, False, True, False, True]
    shown = axes()
    figures.draw_ranked_forces(shown, film)
    assert [text.get_text() for text in shown.get_legend().get_texts()] == ["3 present", "2 may be absent"]


def test_every_contact_is_in_a_bar_of_its_certainty():
    shown = axes()
    figures.draw_certainty(shown, a_film_of_forces())
    assert sum(bar.get_height() for bar in shown.patches) == 5
    assert shown.get_title() == "1 beyond 50 in the last bar"


def test_bars_of_certainty_are_few_whatever_the_numbers():
    for far in (30.0, 1e4, 1e9, 1e300):
        edges = film_forces.certainty_bins(np.array([-3.0, 0.0, far, far]))
        assert 3 < len(edges) < 50 and edges[-1] >= far


def test_numbers_of_another_shape_are_one_sentence(tmp_path):
    packing = arenite.Packing([1, 2, 3], [1, 1, 1], [0.5, 0.5, 0.5], width=4, height=2)
    (file,) = arenite.save(packing, tmp_path)
    program = "import json, sys, arenite.figures.catalogue as c\nc.save_all = lambda *a: {}['mean']\nsys.argv = ['figures', json.dumps({'result': sys.argv[1]})]\nimport runpy; runpy.run_module('arenite.figures', run_name='__main__')"
    done = subprocess.run(
        [sys.executable, "-c", program, file],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": os.environ["ARENITE_PYTHONPATH"]},
    )
    assert (
        done.returncode == 2 and done.stderr.count("\n") == 1 and "compute the result again" in done.stderr
    ), done.stderr


def test_broken_bonds_are_counted_by_type_up_to_each_step():
    shown = axes()
    part = types.SimpleNamespace(curve={"broken": [0, 2, 5]}, cracks={"type": np.array([1, 1, 2, 3, 1])})
    figures.draw_broken_bonds(shown, part)
    assert {line.get_label(): list(line.get_ydata()) for line in shown.lines} == {
        "matrix": [0, 2, 3],
        "interface": [0, 0, 1],
        "particle": [0, 0, 1],
    }


def test_stored_states_lie_on_the_travel_of_the_wall(result):
    stage = next(part for part in result.stages[::-1] if histories.moving_wall(part.history))
    shown = axes()
    figures.draw_travel(shown, stage.history, stage.snapshots)
    assert len(stage.frames) == len(stage.snapshots)  # the former name
    line, states = shown.lines
    assert len(states.get_xdata()) == len(stage.snapshots) and states.get_xdata()[-1] == pytest.approx(
        line.get_xdata()[-1], abs=1e-3 * np.ptp(line.get_xdata())
    )


def test_the_mass_that_has_passed_is_drawn_over_the_time():
    axes_of = axes()
    histories.draw_discharge(axes_of, {"time": np.array([2.0, 2.5, 3.0]), "passed_mass": np.array([0, 0.2, 0.4])})
    line = axes_of.lines[0]
    assert line.get_xdata().tolist() == [0, 0.5, 1] and line.get_ydata() == pytest.approx([0, 200, 400])
    assert axes_of.get_ylabel() == "mass passed, g"


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
    shown = axes()
    figures.draw_size_curve(shown, measured, asked)
    assert [line.get_label() for line in shown.lines] == ["measured", "asked"] and shown.lines[0].get_ydata()[-1] == 100


def test_a_critical_state_is_drawn_where_it_was_found():
    shown = axes()
    loadings.draw_critical_state(
        shown, {"from": 0.2, "to": 1.0, "mu": {"value": 0.4, "error": 0.01, "low_95": 0.38, "high_95": 0.42}}
    )
    assert shown.lines[0].get_xdata() == pytest.approx([20, 100]) and shown.lines[0].get_ydata() == pytest.approx(
        [0.4, 0.4]
    )
    assert "0.400 ± 0.020" in shown.lines[0].get_label()


def test_fields_are_those_of_the_state(result):
    state = next(part for _, part in figures.figures_of(result))
    fields = samples.fields_of(state)
    picture, label = figures.draw_coarse_field(axes(), fields, "solid_fraction")
    assert np.asarray(picture.get_array()) == pytest.approx(fields["solid_fraction"]) and "solid fraction" in label
    shown = axes()
    figures.draw_grains_against(shown, motion.Shot(state.stage, state.snapshot))
    assert sum(len(line.get_xdata()) for line in shown.lines) == len(state.packing)
