"""Samples of spheres in Python: arrays, balance, what was measured."""

import numpy as np
import pytest

import arenite

RECIPE = """
seed = 5
dimension = 3
[materials.glass]
density = "2500 kg/m^3"
stiffness = "100 kN/m"
[packing]
grains = 120
[[populations]]
material = "glass"
ratio = 1
diameter = "4 mm"
[container]
width = "20 mm"
depth = "20 mm"
periodic_x = true
periodic_y = true
periodic_z = true
[[stages]]
name = "compress"
friction = 0
right = { pressure = "10 kPa" }
top = { pressure = "10 kPa" }
front = { pressure = "10 kPa" }
"""


def test_a_sample_of_spheres_is_arrays_of_three_components(tmp_path):
    (tmp_path / "recipe.toml").write_text(RECIPE)
    result = arenite.run(arenite.Recipe(tmp_path / "recipe.toml"), tmp_path / "out")
    assert result.converged and not result.stages
    packing, compressed = result.spheres
    assert packing.name == "packing" and compressed.name == "compress"
    state = compressed.states[-1]
    assert state.position.shape == (120, 3) and len(state) == 120
    assert not state.position.flags.writeable
    # Each sphere is in balance, and the stress of the forces is the one that is told.
    total = np.zeros((120, 3))
    np.add.at(total, state.contact_i, state.force)
    np.add.at(total, state.contact_j, -state.force)
    assert np.linalg.norm(total, axis=1).max() < 0.02 * state.fn.mean()
    size = np.array(state.domain["size"])
    branch = state.position[state.contact_i] - state.position[state.contact_j]
    branch -= size * np.round(branch / size)
    stress = -np.einsum("ca,cb->ab", state.force, branch) / size.prod()
    assert np.allclose(stress, compressed.numbers["stress"]["value"], rtol=1e-6, atol=1)
    assert np.allclose(np.diag(stress), -10e3, rtol=5e-3)
    field = arenite.coarse_grained(state, "4 mm", "2 mm")
    mean = field["contact_stress"].mean(axis=(0, 1, 2))
    assert np.allclose(mean, stress, atol=1e-3 * 10e3)  # a kernel's radius is seven spacings
    again = arenite.open(str(tmp_path / "out"))
    assert np.array_equal(again.spheres[-1].states[-1].position, state.position)
    assert state.measure()["coordination"]["all"]["value"] == compressed.numbers["coordination"]["all"]["value"]
    assert compressed.history["kinetic"].shape == compressed.history["time"].shape


def test_coarse_grained_fields_of_spheres_have_layers_rows_and_columns(tmp_path):
    (tmp_path / "recipe.toml").write_text(RECIPE.replace('depth = "20 mm"', 'depth = "30 mm"'))
    packing = arenite.pack(arenite.Recipe(tmp_path / "recipe.toml"))
    field = arenite.coarse_grained(packing, "4 mm", spacing="2 mm")
    shape = tuple(len(field[name]) for name in "zyx")
    assert field["density"].shape == field["solid_fraction"].shape == shape and shape[0] > shape[2]
    assert field["velocity"].shape == field["wall_force"].shape == (*shape, 3)
    for name in ("velocity_gradient", "contact_stress", "kinetic_stress", "gradient_stress"):
        assert field[name].shape == (*shape, 3, 3)
    size = np.array(packing.domain["size"])
    for name, length in zip("xyz", size):
        assert np.allclose(np.diff(field[name]), length / len(field[name]))
    fraction = (4 / 3 * np.pi * packing.radius**3).sum() / size.prod()
    assert field["solid_fraction"].mean() == pytest.approx(fraction, rel=1e-4)
    assert np.allclose(field["density"], 2500 * field["solid_fraction"], rtol=1e-9)
    # The layer of a point is that of its z: a sphere is nearest to where it is smeared out to.
    sharp = arenite.coarse_grained(packing, "0.5 mm")
    layer, row, column = np.unravel_index(sharp["density"].argmax(), sharp["density"].shape)
    apart = packing.position - [sharp["x"][column], sharp["y"][row], sharp["z"][layer]]
    apart -= size * np.round(apart / size)
    assert np.linalg.norm(apart, axis=1).min() < 0.5e-3
    with pytest.raises(ValueError, match="at most 4e.06 fit; give a spacing above"):
        arenite.coarse_grained(packing, "4 mm", "1 um")


def test_spheres_of_files_are_measured_as_our_own(tmp_path):
    """Two crystals' worth of neighbours: eight spheres of a simple cubic cell, pressed along x alone."""
    place = np.array([(x, y, z) for x in (0.5, 1.5) for y in (0.5, 1.5) for z in (0.5, 1.5)])
    rows = "".join(f"{k},{x},{y},{z},0.505\n" for k, (x, y, z) in enumerate(place))
    (tmp_path / "grains.csv").write_text("id,x [mm],y [mm],z [mm],radius [mm]\n" + rows)
    box = dict(box=("4 mm", "4 mm", "4 mm"), periodic="xyz")
    bare = arenite.read_packing(tmp_path / "grains.csv", **box)
    assert isinstance(bare, arenite.SpherePacking) and len(bare.contact_i) == 12  # where they overlap
    assert bare.measure()["coordination"]["all"]["value"] == 3 and "stress" not in bare.measure()
    (tmp_path / "contacts.csv").write_text("i,j,fx,fy,fz\n" + "".join(f"{k},{k + 4},8,0,1\n" for k in range(4)))
    packing = arenite.read_packing(tmp_path / "grains.csv", tmp_path / "contacts.csv", **box)
    measured = packing.measure()
    assert np.allclose(measured["stress"]["value"][0], [-4 * 8 * 1e-3 / 4e-3**3, 0, 0])
    assert np.isclose(measured["quality"]["friction_ratio_max"], 1 / 8)
    told = arenite.measure(packing)
    assert told["coordination"]["all"]["value"] == measured["coordination"]["all"]["value"] == 1
    assert told.keys() == measured.keys() and np.allclose(told["stress"]["value"], measured["stress"]["value"])
    assert "stress" not in arenite.measure(bare, border=0)
    with pytest.raises(ValueError, match="sigma_hyd is of disks"):
        arenite.measure(packing, sigma_hyd=np.zeros(8))
    with pytest.raises(TypeError):
        arenite.measure(None)
    page = tmp_path / "page.html"
    arenite.page(packing, page)
    assert page.stat().st_size > 10_000


def test_a_function_looks_at_a_stage_of_spheres_and_stops_it(tmp_path):
    (tmp_path / "recipe.toml").write_text(RECIPE)
    recipe = arenite.Recipe(tmp_path / "recipe.toml")
    packing, seen = arenite.pack(recipe), []

    def look(stage):
        assert isinstance(stage.packing, arenite.SpherePacking)
        seen.append((stage.step, stage.unbalanced_ratio, stage.packing.position[:, 1].max()))

    plain = arenite.load_stage(packing, recipe)
    watched = arenite.load_stage(packing, recipe, on_step=look, every=1000)
    assert (
        np.array_equal(plain.states[-1].position, watched.states[-1].position)
        and plain.provenance == watched.provenance
    )
    assert [step for step, *_ in seen] == [1000 * (k + 1) for k in range(len(seen))] and len(seen) > 1
    assert seen[-1][2] < seen[0][2]
    stopped = arenite.load_stage(packing, recipe, on_step=lambda stage: stage.stop("enough"), every=200)
    assert "enough" in stopped.outcome and stopped.history["time"][-1] < plain.history["time"][-1]
    run = arenite.run(recipe, tmp_path / "out", on_step=lambda stage: stage.stop("enough"), every=200)
    assert "enough" in run.spheres[1].outcome


def test_a_stage_of_spheres_that_does_not_settle_warns():
    restless = arenite.Recipe.from_text(
        RECIPE.replace("grains = 120", "grains = 40")
        .replace("20 mm", "14 mm")
        .replace("[[stages]]", "[contact]\nrestitution = 1\n[[stages]]")
        + "equilibrium = { max_steps = 700000 }"
    )
    with pytest.warns(UserWarning, match="without coming to rest: unbalanced force ratio"):
        stage = arenite.load_stage(arenite.pack(restless), restless)
    assert not stage.converged


BONDED = (
    RECIPE.replace(
        "[[stages]]",
        "[contact]\nbonds = 'parallel'\nbond_modulus = '0.1 GPa'\n"
        "bond_tensile_strength = '1 MPa'\nbond_cohesion = '1 MPa'\n[[stages]]",
        1,
    )
    + """
[[stages]]
name = "bond"
bond = true
right = { pressure = "15 kPa" }
top = { pressure = "15 kPa" }
front = { pressure = "15 kPa" }
"""
)


def test_bonds_and_contacts_together_are_in_balance(tmp_path):
    (tmp_path / "recipe.toml").write_text(BONDED)
    stage = arenite.run(arenite.Recipe(tmp_path / "recipe.toml"), tmp_path / "out").spheres[-1]
    state = stage.states[-1]
    bonds = state.bonds
    assert len(bonds["i"]) > 200 and (bonds["broken"] == 0).all()
    assert stage.history["bonds"][-1] == len(bonds["i"])
    total = np.zeros((len(state), 3))
    for i, j, force in ((state.contact_i, state.contact_j, state.force), (bonds["i"], bonds["j"], bonds["force"])):
        np.add.at(total, i, force)
        np.add.at(total, j, -force)
    size = np.linalg.norm(state.force, axis=1).mean()
    assert np.linalg.norm(bonds["force"], axis=1).mean() > 0.01 * size
    assert np.linalg.norm(total, axis=1).mean() < 0.02 * size
    assert np.isclose(-np.trace(np.array(stage.numbers["stress"]["value"])) / 3, 15e3, rtol=5e-3)


def test_packings_of_spheres_are_spheres_and_what_is_of_disks_says_so(tmp_path):
    (tmp_path / "recipe.toml").write_text(RECIPE)
    recipe = arenite.Recipe(tmp_path / "recipe.toml")
    packing = arenite.pack(recipe)
    assert isinstance(packing, arenite.SpherePacking) and len(packing) == 120
    with pytest.raises(ValueError, match="the packing is of disks, and the recipe has dimension = 3"):
        arenite.load_stage(arenite.Packing([0.5], [0.5], [0.1], width=1, height=1, thickness=1), recipe)
    for border in (-1, float("nan")):
        with pytest.raises(ValueError, match="border of .* is not possible"):
            packing.measure(border=border)
