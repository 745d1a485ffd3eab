import arenite
import numpy as np
import pytest


def oscillating(frames=600, rate=148.0, frequency=3.02, dtype=np.float32):
    """Every pixel oscillates by its own amplitude on a slope."""
    t = np.arange(frames) / rate
    amplitude = np.linspace(0.5, 20, 12 * 10).reshape(12, 10)
    film = 5000 + 3 * t[:, None, None] + amplitude * np.cos(2 * np.pi * frequency * t)[:, None, None]
    if dtype == np.uint16:  # noise, as cameras have it, breaks the steps of the levels
        film = film + np.random.default_rng(1).normal(0, 1, film.shape)
    return (np.round(film) if dtype == np.uint16 else film).astype(dtype), amplitude


def test_lock_in_of_an_array_finds_amplitudes_and_the_frequency_off_the_bin():
    film, amplitude = oscillating()
    maps = arenite.lock_in(film, 3.0, frame_rate=148.0)
    assert maps.frequency == pytest.approx(3.02, abs=1e-5)
    assert np.allclose(maps.amplitude, amplitude, rtol=2e-3)
    assert maps.amplitude.shape == (12, 10)


def test_levels_are_taken_as_they_are_and_times_may_be_uneven():
    film, amplitude = oscillating(dtype=np.uint16)
    keep = np.arange(len(film)) % 7 != 3
    maps = arenite.lock_in(film[keep], 3.0, time=(np.arange(len(film)) / 148.0)[keep], peak_to_peak=True)
    assert np.allclose(maps.amplitude, 2 * amplitude, atol=0.6) and maps.peak_to_peak


@pytest.mark.parametrize("dtype", [np.float32, np.uint16])
def test_masked_frames_are_lost_and_masked_pixels_are_no_numbers(dtype):
    film, _ = oscillating(dtype=dtype)
    keep = np.arange(len(film)) != 40
    right = arenite.lock_in(film[keep], 3.0, time=(np.arange(len(film)) / 148.0)[keep])
    masked = np.ma.masked_array(film.copy(), np.zeros(film.shape, bool))
    masked.data[40] = 12345
    masked[40] = np.ma.masked
    masked[:, 2, 3] = np.ma.masked
    maps = arenite.lock_in(masked, 3.0, frame_rate=148.0)
    assert maps.blank_frames == [40]
    assert np.isnan(maps.amplitude[2, 3])
    there = np.ones((12, 10), bool)
    there[2, 3] = False
    assert np.allclose(maps.amplitude[there], right.amplitude[there], rtol=1e-3, atol=1e-3)


def test_a_film_of_nan_shows_nothing():
    film, _ = oscillating()
    with pytest.raises(ValueError, match="not a number"):
        arenite.lock_in(np.full_like(film, np.nan), 3.0, frame_rate=148.0)
    with pytest.raises(ValueError, match="not a number"):
        arenite.step_load(np.full_like(film, np.nan), frame_rate=148.0)


def test_a_nearest_bin_is_off_where_least_squares_is_not():
    film, amplitude = oscillating(frames=148)
    plain = arenite.lock_in(film, 3.02, frame_rate=148.0, nearest_bin=True, drift_order=0)
    fitted = arenite.lock_in(film, 3.02, frame_rate=148.0, drift_order=1)
    assert np.abs(fitted.amplitude / amplitude - 1).max() < np.abs(plain.amplitude / amplitude - 1).max()


def test_keywords_of_a_lock_in_are_those_of_its_recipe():
    film, _ = oscillating()
    as_given = arenite.lock_in(film, 3.0, frame_rate=148.0, refine=False, peak_to_peak=False, nearest_bin=False)
    assert as_given.frequency == 3.0 and not as_given.peak_to_peak
    assert arenite.lock_in(film, 3.0, frame_rate=148.0).frequency == pytest.approx(3.02, abs=1e-5)
    for wrong in ({"peak_to_peak": "yes"}, {"nearest_bin": 1}, {"refine": "no"}):
        with pytest.raises(ValueError, match=next(iter(wrong))):
            arenite.lock_in(film, 3.02, frame_rate=148.0, **wrong)


def test_grains_of_a_picture():
    y, x = np.mgrid[0:80, 0:100]
    picture = np.full((80, 100), 20.0)
    for cx, cy, level in [(20.3, 30.1, 200), (52.6, 41.2, 90), (80.0, 20.5, 200)]:
        picture += (level - 20) * np.clip(9.5 - np.hypot(x - cx, y - cy), 0, 1)
    grains = arenite.find_grains(picture, materials=2)
    assert len(grains) == 3
    order = np.argsort(grains.x)
    assert np.allclose(grains.x[order], [20.3, 52.6, 80.0], atol=0.15)
    assert list(grains.material[order]) == [1, 0, 1]


def test_forces_of_a_compressed_disk():
    """A disk between two walls: sigma_kk by superposed Flamant fields gives back the load."""
    radius, length, force, pixel = 10e-3, 60e-3, 1000.0, 0.5e-3
    packing = arenite.propose_contacts(
        arenite.Packing([15e-3], [10e-3], [radius], width=30e-3, height=20e-3, thickness=length), position_error=1e-6
    )
    n = 60
    first = (pixel / 2, 20e-3 - pixel / 2)
    column, row = np.meshgrid(np.arange(n), np.arange(40))
    x, y = first[0] + pixel * column - 15e-3, first[1] - pixel * row - 10e-3
    with np.errstate(divide="ignore"):
        field = (
            -2
            * force
            / (np.pi * length)
            * ((radius - y) / (x**2 + (radius - y) ** 2) + (radius + y) / (x**2 + (radius + y) ** 2))
            + 2 * force / (np.pi * 2 * radius * length) * 2
        )
    inside = np.hypot(x, y) < radius
    signal = np.where(inside & np.isfinite(field), -field * 15e-9, 0)
    found = arenite.infer_forces(
        packing,
        signal,
        np.where(inside, 1e-5, 0),
        pixel=pixel,
        first=first,
        factor=[15e-9],
        walls={"bottom": force, "top": force},
        blur=0.0,
    )
    assert np.allclose(found["fn"], force, rtol=0.02)


def test_films_of_files(examples):
    films = sorted((examples.parent / "tests" / "data").rglob("*.ptw"))
    assert films
    info = arenite.film_info(str(films[0]))
    frames = arenite.read_film(str(films[0]), count=2)
    assert frames.shape == (2, info["height"], info["width"])


def test_a_dataset_of_a_file_with_several_is_chosen_as_the_commands_choose_it(tmp_path):
    h5py = pytest.importorskip("h5py")
    frames = np.arange(3 * 4 * 5, dtype=np.uint16).reshape(3, 4, 5)
    with h5py.File(tmp_path / "films.h5", "w") as file:
        file["first"], file["second"] = frames, frames + 100
    path = tmp_path / "films.h5"
    with pytest.raises(ValueError, match="dataset"):
        arenite.read_film(path)
    assert np.array_equal(arenite.read_film(path, count=3, dataset="second"), frames + 100)
    assert arenite.film_info(path, dataset="first", frame_rate="50 Hz")["frame_rate"] == 50
    assert np.allclose(
        arenite.read_film(path, dataset="first", scale="0.5 K", offset="273 K")[0], 273 + 0.5 * frames[0]
    )
    with pytest.raises(ValueError, match="dataset are for films in files"):
        arenite.find_bad_pixels(frames, dataset="first")


def test_what_films_do_not_allow_is_a_value_error():
    film, _ = oscillating(frames=40)
    with pytest.raises(ValueError):
        arenite.lock_in(film, 100.0, frame_rate=148.0)
    with pytest.raises(ValueError, match="frames, height, width"):
        arenite.lock_in(film[0], 3.0, frame_rate=148.0)


def plates_and_film(frames=16):
    """A camera whose pixels have gains and offsets of their own, one of them dead, looking at black-body references and
    at a picture."""
    random = np.random.default_rng(3)
    gain, offset = 1 + 0.1 * random.standard_normal((24, 32)), 50 * random.standard_normal((24, 32))

    def seen(scene):
        film = gain * (scene + random.normal(0, 1, (frames, 24, 32))) + offset
        film[:, 5, 7] = 0
        return film.astype(np.float32)

    scene = 5000 + 20 * np.sin(np.arange(32) / 5) + np.zeros((24, 1))
    return seen(4000), seen(6000), seen(scene), scene


def test_a_film_is_corrected_by_two_plates_and_its_dead_pixel_replaced():
    cold, warm, film, scene = plates_and_film()
    bad = arenite.find_bad_pixels(film, cold=cold, warm=warm)
    assert bad.dtype == bool and np.array_equal(np.argwhere(bad), [[5, 7]])
    mended = arenite.correct_film(film, cold=cold, warm=warm)
    assert mended.shape == film.shape and mended.dtype == np.float32
    assert np.abs(mended.mean(axis=0) - scene - (mended.mean() - scene.mean())).max() < 5
    assert np.array_equal(arenite.correct_film(film, bad_pixels=False), film)
    with pytest.raises(ValueError, match="same camera"):
        arenite.correct_film(film, cold=cold[:, :-1])
    with pytest.raises(ValueError, match="without cold"):
        arenite.correct_film(film, warm=warm)


def rocking_disks(frames=400, rate=100.0, frequency=3.0, move=0.4, warm=-0.01):
    """Two bright disks that move to and fro with the load and warm with it."""
    t = np.arange(frames) / rate
    y, x = np.mgrid[0:40, 0:70]
    film = np.full((frames, 40, 70), 295.0)
    for cx, cy in [(20.0, 20.0), (50.0, 20.0)]:
        cycle = np.cos(2 * np.pi * frequency * t)[:, None, None]
        film += (5 + warm * cycle) * np.clip(12 - np.hypot(x - cx - move * cycle, y - cy), 0, 1)
    return film.astype(np.float32)


def test_grains_are_followed_and_weighed():
    film = rocking_disks()
    maps = arenite.lock_in(film, 3.0, frame_rate=100.0)
    grains = arenite.find_grains(maps.mean, materials=1)
    motion = arenite.grain_motion(film, maps, grains, frame_rate=100.0)
    assert len(motion) == len(grains) == 2 and not motion.lost.any()
    assert np.allclose(np.hypot(motion.cos_x, motion.sin_x), 0.4, atol=0.03) and np.allclose(motion.cos_y, 0, atol=0.03)
    followed = arenite.follow_grains(film, maps, grains, motion, frame_rate=100.0)
    found = arenite.grain_means(followed, grains, ["0.015 K/MPa"])
    assert np.allclose(np.abs(found["temperature"]), 0.02, rtol=0.05)
    assert np.allclose(found["sigma_hyd"], -found["temperature"] / (2 * 15e-9))
    with pytest.raises(ValueError, match="another film"):
        arenite.grain_motion(film[:, 1:], maps, grains, frame_rate=100.0)


def test_a_recipe_of_a_film_is_made_and_changed():
    recipe = arenite.FilmRecipe.template()
    other = recipe.changed({"lockin.frequency": "4 Hz"})
    assert other != recipe and other == arenite.FilmRecipe.from_text(other.toml())
    with pytest.raises(ValueError, match="FilmRecipe.template"):
        arenite.Recipe.template("film")


def test_what_a_film_says_of_its_frames_is_warned_of(tmp_path):
    film, _ = oscillating(frames=120)
    for n in range(120):
        if n % 10 != 5:
            np.savetxt(tmp_path / f"frame{n:03}.asc", film[n], fmt="%.4f")
    with pytest.warns(arenite.FileWarning, match="12 frames are missing"):
        assert arenite.lock_in(tmp_path, 3.0, frame_rate=148.0).frames == 108
