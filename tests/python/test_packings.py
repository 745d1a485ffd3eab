import gc

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
    file.write_text("[frame]\nwidth = 3\n")
    with pytest.raises(ValueError, match=r"r.toml:2.*width"):
        arenite.Recipe(str(file))
    with pytest.raises(ValueError, match="no template"):
        arenite.Recipe.template("sand")
    with pytest.raises(ValueError, match="one length"):
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
