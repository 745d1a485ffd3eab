"""A function that is called while a stage is under way."""

import arenite
import numpy as np
import pytest

pressing = """
seed = 3
container = { width = "100 mm", height = "100 mm", thickness = "60 mm" }
packing = { method = "random" }
materials.POM = { density = "1410 kg/m^3", stiffness = "27.35 kN/mm" }
populations = [{ material = "POM", count = 60, size = { law = "uniform", min = "8 mm", max = "12 mm" } }]
contact = { restitution = 0.3, friction = 0.3 }

[[stages]]
name = "press"
right = { pressure = "20 kPa" }
top = { velocity = "100 mm/s" }
duration = "20 ms"
"""


@pytest.fixture(scope="module")
def recipe():
    return arenite.Recipe.from_text(pressing)


@pytest.fixture(scope="module")
def packing(recipe):
    return arenite.pack(recipe)


def same(a, b):
    return all(np.array_equal(getattr(a.packing, name), getattr(b.packing, name)) for name in ("x", "y", "vx", "omega"))


def test_a_function_that_only_looks_leaves_every_bit(recipe, packing):
    seen = []

    def look(stage):
        seen.append((stage.step, stage.time, stage.packing.x.copy(), stage.history["top_force"][-1]))

    plain = arenite.load_stage(packing, recipe)
    watched = arenite.load_stage(packing, recipe, on_step=look, every=1000)
    assert same(plain, watched) and plain.provenance == watched.provenance
    assert [step for step, *_ in seen] == [1000 * (k + 1) for k in range(len(seen))] and len(seen) > 1
    assert all(
        step * plain.snapshots[-1].time == pytest.approx(time * plain.snapshots[-1].step) for step, time, *_ in seen
    )
    assert not np.array_equal(seen[0][2], seen[1][2])


def test_it_stops_a_stage(recipe, packing):
    def stop(stage):
        if stage.history["top_position"][-1] < 0.0995:
            stage.stop("pressed by half a millimetre")

    stage = arenite.load_stage(packing, recipe, on_step=stop, every=200)
    top = stage.history["top_position"]
    assert top[-1] < 0.0995 <= top[-2]
    assert "pressed by half a millimetre" in stage.outcome and stage.converged


def test_it_changes_what_drives_the_stage_and_stores_states(recipe, packing):
    def turn(stage):
        if stage.step == 2000:
            stage.change({"top.velocity": "-100 mm/s", "gravity": True, "gravity_angle": "5 deg"})
            stage.store("turned")

    plain = arenite.load_stage(packing, recipe)
    stage = arenite.load_stage(packing, recipe, on_step=turn)
    time, top = stage.history["time"], stage.history["top_position"]
    at = np.argmin(top)
    assert 0 < at < len(top) - 1 and top[-1] > top[at]
    assert time[at] == pytest.approx([s.time for s in stage.snapshots if s.label == "turned"][0])
    assert stage.asked["gravity"][0] == pytest.approx(9.81 * np.sin(np.radians(5)))
    assert stage.provenance["input_hash"] != plain.provenance["input_hash"]
    assert ("gravity", "true") in [tuple(change.split("=", 1)) for _, change in stage.provenance["options"]]


def test_what_it_raises_reaches_the_caller(recipe, packing):
    def fail(stage):
        raise KeyError("mine")

    for threads in (1, 2):
        with pytest.raises(KeyError, match="mine"):
            arenite.load_stage(packing, recipe, threads=threads, on_step=fail)
    with pytest.raises(ValueError, match="no other key"):
        arenite.load_stage(packing, recipe, on_step=lambda stage: stage.change({"duration": "1 s"}))
    with pytest.raises(ValueError, match="every"):
        arenite.load_stage(packing, recipe, on_step=fail, every=0)
    assert arenite.load_stage(packing, recipe).converged


def test_a_running_stage_is_of_use_only_in_its_function(recipe, packing):
    kept = []
    arenite.load_stage(packing, recipe, on_step=kept.append)
    with pytest.raises(ValueError, match="gone on"):
        kept[0].step
    assert len(kept) > 1


def test_a_condition_ends_a_stage(recipe, packing):
    stage = arenite.load_stage(packing, recipe.changed({"stages.0.until": "strain_y > 0.5 %"}))
    assert "strain_y > 0.5 %" in stage.outcome
    assert 1 - stage.history["top_position"][-1] / 0.1 == pytest.approx(0.005, rel=0.2)
    with pytest.raises(ValueError, match="axial_strain"):
        recipe.changed({"stages.0.until": "axal_strain > 1 %"})


def test_a_stage_that_does_not_settle_warns_with_the_keys_that_mend_it():
    restless = arenite.Recipe.from_text(
        pressing.split("[[stages]]")[0].replace("restitution = 0.3, friction = 0.3", "restitution = 1, friction = 0")
        + """
[[stages]]
name = "rattle"
gravity = true
gravity_size = "1000 m/s^2"
equilibrium = { unbalanced = 0.1, max_steps = 150000 }
"""
    )
    with pytest.warns(UserWarning, match="unbalanced force ratio.*critical_drag"):
        stage = arenite.load_stage(arenite.pack(restless), restless)
    assert not stage.converged


two_stages = (
    pressing
    + """
[[stages]]
name = "hold"
right = { pressure = "20 kPa" }
duration = "10 ms"
"""
)


def results(folder):
    return {file.name: file.read_bytes() for file in sorted(folder.glob("0*.h5"))}


def test_a_run_calls_it_in_every_stage_and_has_the_same_bytes_where_it_only_looks(tmp_path):
    recipe, seen = arenite.Recipe.from_text(two_stages), []
    arenite.run(recipe, tmp_path / "plain")
    arenite.run(recipe, tmp_path / "watched", on_step=lambda stage: seen.append(stage.name), every=200)
    assert set(seen) == {"press", "hold"}
    assert results(tmp_path / "watched") == results(tmp_path / "plain")
    seen.clear()
    arenite.run(recipe, tmp_path / "plain", on_step=lambda stage: seen.append(stage.name), every=200)
    assert not seen  # all is there already


def test_a_run_that_was_changed_is_not_taken_for_one_of_the_recipe(tmp_path):
    recipe = arenite.Recipe.from_text(two_stages)

    def stop(stage):
        if stage.name == "press" and stage.step >= 2000:
            stage.stop("enough")

    stopped = arenite.run(recipe, tmp_path / "run", on_step=stop, every=200)
    assert "enough" in stopped.stages[1].outcome
    changed = [stage.provenance["input_hash"] for stage in stopped.stages]
    plain = arenite.run(recipe, tmp_path / "run")
    own = [stage.provenance["input_hash"] for stage in plain.stages]
    assert "enough" not in plain.stages[1].outcome
    assert changed[0] == own[0] and changed[1] != own[1] and changed[2] != own[2]
    arenite.run(recipe, tmp_path / "other")
    assert results(tmp_path / "run") == results(tmp_path / "other")
