import gc
import pathlib

import arenite
import numpy as np
import pytest


def lattice(n=6, radius=1e-3):
    x, y = np.meshgrid((2 * np.arange(n) + 1) * radius, (2 * np.arange(n) + 1) * radius)
    return arenite.Packing(x.ravel(), y.ravel(), np.full(n * n, radius), width=2 * n * radius, height=2 * n * radius)


def test_arrays_look_into_the_packing_and_keep_it_alive(result):
    stage = result.stages[-1]
    x = stage.packing.x
    assert not x.flags.owndata and not x.flags.writeable
    assert np.shares_memory(x, stage.packing.x)
    copy = x.copy()
    del stage
    gc.collect()
    assert np.array_equal(x, copy)
    with pytest.raises(ValueError):
        x[0] = 0


def test_a_packing_of_ones_own_is_measured():
    texture = arenite.measure(arenite.propose_contacts(lattice(12), position_error=1e-9), border=0)
    assert texture["solid_fraction"]["value"] == pytest.approx(np.pi / 4, abs=0.02)
    assert texture["coordination"]["all"]["value"] == pytest.approx(2 * 2 * 12 * 11 / 144)


def test_stages_one_by_one_are_those_of_a_run(recipe, result):
    packing = arenite.pack(recipe)
    assert np.array_equal(packing.x, result.stages[0].packing.x)
    stage = arenite.load_stage(packing, recipe, 0)
    assert np.array_equal(stage.packing.x, result.stages[1].packing.x)
    assert np.array_equal(stage.packing.contacts.fn, result.stages[1].packing.contacts.fn)
    assert stage.texture == result.stages[1].texture


wet_heap = """
seed = 2
container = { width = "60 mm", height = "100 mm", thickness = "10 mm" }
packing = { method = "random", area = { top = "90 mm" } }
materials.glass = { density = "2500 kg/m^3", stiffness = "0.02 kN/mm" }
populations = [{ material = "glass", count = 120, size = { law = "uniform", min = "3 mm", max = "4 mm" } }]

[contact]
friction = 0.5
cohesion = "capillary_disks"
surface_tension = "72.8 mN/m"
contact_angle = "20 deg"
liquid_volume = "0.05 mm^3"

[[stages]]
name = "pour"
gravity = true
drag = "5 1/s"
duration = "0.3 s"

[[stages]]
name = "fall"
gravity = true
duration = "0.2 s"
open = { bottom = true }
count_below = "0 mm"
"""


def test_a_stage_alone_has_all_numbers_of_a_runs_stage(tmp_path):
    recipe = arenite.Recipe.from_text(wet_heap)
    run = arenite.run(recipe, tmp_path).stages
    pour = arenite.load_stage(arenite.pack(recipe), recipe, "pour")
    assert {"surface", "floor", "cohesion", "solid_fraction"} <= pour.texture.keys()
    assert pour.texture == run[1].texture and pour.provenance["recipe"] == run[1].provenance["recipe"]
    fall = arenite.load_stage(pour.packing, recipe, "fall").texture
    assert {"discharge", "surface", "cohesion"} <= fall.keys() and "width_before_m" in fall["surface"]
    assert {part: set(fall[part]) for part in fall if isinstance(fall[part], dict)} == {
        part: set(run[2].texture[part]) for part in fall if isinstance(fall[part], dict)
    }


def test_forces_balance(result):
    p, c = result.stages[-1].packing, result.stages[-1].packing.contacts
    fx = c.fn * c.nx - c.ft * c.ny
    total = np.zeros(len(p))
    np.add.at(total, c.i, fx)
    np.add.at(total, c.j[c.j >= 0], -fx[c.j >= 0])
    assert np.abs(total).max() < 1e-2 * np.abs(fx).mean()


def test_progress_is_told_and_a_stage_is_chosen_by_name(recipe):
    told = []
    arenite.load_stage(arenite.pack(recipe), recipe, "compact", progress=lambda share, name: told.append((share, name)))
    assert told and told[-1][1] == "compact" and all(0 <= share <= 1 for share, _ in told)


def test_bad_input_is_a_value_error_with_the_programs_sentence(tmp_path):
    file = tmp_path / "r.toml"
    file.write_text("[container]\nwidth = 3\n")
    with pytest.raises(ValueError, match=r"r.toml:2.*width"):
        arenite.Recipe(str(file))
    with pytest.raises(ValueError, match="no template"):
        arenite.Recipe.template("sand")
    with pytest.raises(ValueError, match="equal lengths"):
        arenite.Packing([1.0], [1.0, 2.0], [1.0], width=1, height=1)
    with pytest.raises(ValueError, match="no stage"):
        arenite.load_stage(lattice(), arenite.Recipe.template("composite"), "nowhere")


def test_recipes_change_and_come_back_from_text(recipe):
    other = recipe.changed({"seed": 9, "bidisperse.large_radius": "2 mm"})
    assert other.seed == 9 and 'large_radius = "2 mm"' in other.toml()
    assert other == arenite.Recipe.from_text(other.toml())
    assert recipe != other and recipe.stages == ["compact", "rest"]


def test_python_threads_are_not_stopped_by_a_run(recipe):
    import threading

    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(1)
            done.wait(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    arenite.load_stage(arenite.pack(recipe), recipe, 0)
    done.set()
    thread.join()
    assert len(ticks) > 5


def test_contacts_of_ones_own_are_measured_as_those_of_a_run(result):
    p = result.stages[-1].packing
    d = p.domain
    frame = {
        "width": d["width"],
        "height": d["height"],
        "thickness": d["thickness"],
        "origin": (d["left"]["position"], d["bottom"]["position"]),
    }
    own = arenite.Packing(p.x, p.y, p.radius, p.material, p.materials, contacts=p.contacts, **frame)
    columns = arenite.Packing(
        p.x,
        p.y,
        p.radius,
        p.material,
        p.materials,
        contacts={name: getattr(p.contacts, name) for name in ("i", "j", "fn", "ft")},
        **frame,
    )
    for other in (own, columns):
        assert np.allclose(other.contacts.nx, p.contacts.nx, atol=1e-9) and np.array_equal(
            other.contacts.fn, p.contacts.fn
        )
        assert arenite.measure(other)["stress_details"]["pressure_Pa"] == pytest.approx(
            arenite.measure(p)["stress_details"]["pressure_Pa"], rel=1e-6
        )
        assert arenite.measure(other)["coordination"]["all"] == arenite.measure(p)["coordination"]["all"]


@pytest.mark.parametrize(
    "contacts, sentence",
    [
        ({"i": [0], "j": [99]}, "not among the grains"),
        ({"i": [0], "j": [0]}, "touch itself"),
        ({"i": [0], "j": [-5]}, "whole numbers from -4"),
        ({"i": [-1], "j": [0]}, "whole numbers from 0"),
        ({"i": [0]}, 'no "j"'),
        ({"i": [0], "j": [1], "fn": [1.0, 2.0]}, "equal length"),
        ({"i": [0], "j": [1], "fn": [np.nan]}, "finite"),
        (3, "a dict"),
        ({"i": [0], "j": [30], "fn": [1.0]}, "apart"),
        ({"i": [0, 1], "j": [1, 0]}, "already"),
    ],
)
def test_contacts_that_cannot_be_are_refused(contacts, sentence):
    x, y = np.meshgrid(np.arange(1, 13, 2) * 1e-3, np.arange(1, 13, 2) * 1e-3)
    with pytest.raises(ValueError, match=sentence):
        arenite.Packing(x.ravel(), y.ravel(), np.full(36, 1e-3), width="12 mm", height="12 mm", contacts=contacts)


def test_files_are_read_with_what_they_do_not_say(tmp_path):
    (tmp_path / "grains.csv").write_text("id,x,y,radius\n0,1,1,1\n1,3,1,1\n")
    (tmp_path / "contacts.csv").write_text("i,j,fn\n0,1,5\n")
    with pytest.warns(arenite.FileWarning, match="so N was assumed; force_unit or a header"):
        p = arenite.read_packing(
            tmp_path / "grains.csv",
            tmp_path / "contacts.csv",
            box=("4 mm", "2 mm"),
            length_unit="mm",
            thickness="10 mm",
        )
    assert p.domain["width"] == 4e-3 and p.domain["thickness"] == 10e-3 and list(p.x) == [1e-3, 3e-3]
    with pytest.raises(ValueError, match=r"correct its centre, box or origin"):
        arenite.read_packing(tmp_path / "grains.csv", box=(2e-3, 2e-3), origin=(0, 0), length_unit="mm")


def test_what_files_do_not_say_is_warned_of_and_kept(tmp_path):
    (tmp_path / "grains.csv").write_text("id,x,y,radius,step\n0,1,1,1,7\n1,3,1,1,7\n")
    (tmp_path / "contacts.csv").write_text("i,j,fn\n0,1,5\n")
    with pytest.warns(arenite.FileWarning) as told:
        p = arenite.read_packing(tmp_path / "grains.csv", tmp_path / "contacts.csv")
    assert [str(one.message) for one in told] == p.notes and len(p.notes) >= 3  # two units, and the moment
    assert any("The grains are of step 7" in note for note in p.notes)
    assert issubclass(arenite.FileWarning, UserWarning)
    assert arenite.Packing([1e-3], [1e-3], [1e-3], width=2e-3, height=2e-3).notes == []


def test_curves_of_textures_are_arrays(result):
    texture = arenite.measure(result.stages[-1].packing, load_axis=90)
    for curve in (texture["rev"]["mean"], texture["sigma_norm"]["cumulative"]["x"], texture["fabric"]["sectors"]):
        assert isinstance(curve, np.ndarray) and curve.dtype == float
    assert texture["fabric"]["phi"]["value"].shape == (2, 2) and texture["notes"] == []


def test_histories_look_into_the_stage(result):
    history = result.stages[1].history
    stage = result.stages[1]
    history = stage.history
    assert np.shares_memory(history["time"], stage.history["time"]) and not history["time"].flags.writeable
    assert set(stage.history_units) == set(history)


def test_stages_are_stored_exported_and_shown_as_a_page(recipe, result, tmp_path):
    stage = arenite.load_stage(arenite.pack(recipe), recipe, "compact")
    assert stage.provenance["recipe"] == result.stages[1].provenance["recipe"] and stage.provenance["input_hash"]
    assert arenite.load_stage(arenite.pack(recipe), recipe, "compact").provenance == stage.provenance
    result = arenite.Result([stage])
    assert result.title == recipe.title and result.converged == stage.converged
    (file,) = arenite.save(result, tmp_path / "stored")
    again = arenite.open(tmp_path / "stored")
    assert (
        np.array_equal(again.stages[0].packing.x, stage.packing.x)
        and again.numbers["provenance"] == result.numbers["provenance"]
    )
    for what in (file, stage, stage.packing, result):
        files = arenite.export(what, tmp_path / "exported", "csv", last=True)
        assert files and all(pathlib.Path(f).parent == tmp_path / "exported" for f in files)
    arenite.page(stage.packing, tmp_path / "page.html")
    assert "<html" in (tmp_path / "page.html").read_text()
    with pytest.raises(ValueError, match="format \"obj\""):
        arenite.export(stage, tmp_path / "exported", "obj")
    with pytest.raises(ValueError, match="nothing to store"):
        arenite.save(arenite.Result(), tmp_path / "empty")
    with pytest.raises(ValueError, match="result is a folder"):
        arenite.save(3, tmp_path / "empty")
    assert not (tmp_path / "empty").exists()


def test_forces_follow_from_the_moduli_of_the_materials(tmp_path):
    recipe = arenite.Recipe.from_text(
        """[container]
width = "30 mm"
height = "30 mm"
thickness = "10 mm"
[[populations]]
material = "hard"
count = 40
diameter = "3 mm"
[[populations]]
material = "soft"
count = 20
diameter = "4 mm"
[materials.hard]
density = "2500 kg/m^3"
youngs_modulus = "0.7 GPa"
poisson = 0.22
[materials.soft]
density = "1100 kg/m^3"
youngs_modulus = "0.1 GPa"
poisson = 0.45
[contact]
normal = "hertz_mindlin"
[[stages]]
name = "press"
right = { force = "20 N" }
top = { force = "20 N" }
equilibrium = { unbalanced = 1e-5, kinetic = 1e-10 }
"""
    )
    packing = arenite.open(arenite.run(recipe, str(tmp_path / "out")).path).stages[-1].packing  # as stored
    constants = {m.name: (m.youngs_modulus, m.poisson) for m in packing.materials}
    assert constants == {"hard": (0.7e9, 0.22), "soft": (0.1e9, 0.45)} and arenite.Material("other").poisson is None
    yields = np.array([(1 - m.poisson**2) / m.youngs_modulus for m in packing.materials])[packing.material]
    c, r = packing.contacts, packing.radius
    i, j = (np.asarray(k)[np.asarray(c.j) >= 0] for k in (c.i, c.j))
    overlap = r[i] + r[j] - np.hypot(packing.x[i] - packing.x[j], packing.y[i] - packing.y[j])
    force = 4 / 3 / (yields[i] + yields[j]) * np.sqrt(r[i] * r[j] / (r[i] + r[j])) * overlap**1.5
    pressed = np.asarray(c.fn)[np.asarray(c.j) >= 0]
    assert len(pressed) > 50 and np.abs(force - pressed).max() < 1e-4 * pressed.max()
