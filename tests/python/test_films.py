import arenite
import numpy as np
import pytest


def swinging(frames=600, rate=148.0, frequency=3.02, dtype=np.float32):
    """Every pixel swings by its own amplitude on a slope."""
    t = np.arange(frames) / rate
    amplitude = np.linspace(0.5, 20, 12 * 10).reshape(12, 10)
    film = 5000 + 3 * t[:, None, None] + amplitude * np.cos(2 * np.pi * frequency * t)[:, None, None]
    if dtype == np.uint16:  # noise, as cameras have it, breaks the steps of the levels
        film = film + np.random.default_rng(1).normal(0, 1, film.shape)
    return (np.round(film) if dtype == np.uint16 else film).astype(dtype), amplitude


def test_lock_in_of_an_array_finds_amplitudes_and_the_frequency_off_the_bin():
    film, amplitude = swinging()
    maps = arenite.lock_in(film, 3.0, frame_rate=148.0)
    assert maps.frequency == pytest.approx(3.02, abs=1e-5)
    assert np.allclose(maps.amplitude, amplitude, rtol=2e-3)
    assert maps.amplitude.shape == (12, 10)


def test_levels_are_taken_as_they_are_and_times_may_be_uneven():
    film, amplitude = swinging(dtype=np.uint16)
    keep = np.arange(len(film)) % 7 != 3
    maps = arenite.lock_in(film[keep], 3.0, time=(np.arange(len(film)) / 148.0)[keep], full_swing=True)
    assert np.allclose(maps.amplitude, 2 * amplitude, atol=0.6) and maps.full_swing


def test_a_nearest_bin_is_off_where_least_squares_is_not():
    film, amplitude = swinging(frames=148)
    plain = arenite.lock_in(film, 3.02, frame_rate=148.0, nearest_bin=True, drift_order=0)
    fitted = arenite.lock_in(film, 3.02, frame_rate=148.0, drift_order=1)
    assert np.abs(fitted.amplitude / amplitude - 1).max() < np.abs(plain.amplitude / amplitude - 1).max()


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
    packing = arenite.propose_contacts(arenite.Packing([15e-3], [10e-3], [radius], width=30e-3, height=20e-3, thickness=length), position_error=1e-6)
    n = 60
    first = (pixel / 2, 20e-3 - pixel / 2)
    column, row = np.meshgrid(np.arange(n), np.arange(40))
    x, y = first[0] + pixel * column - 15e-3, first[1] - pixel * row - 10e-3
    with np.errstate(divide="ignore"):
        field = -2 * force / (np.pi * length) * ((radius - y) / (x**2 + (radius - y) ** 2) + (radius + y) / (x**2 + (radius + y) ** 2)) + 2 * force / (np.pi * 2 * radius * length) * 2
    inside = np.hypot(x, y) < radius
    swing = np.where(inside & np.isfinite(field), -field * 15e-9, 0)
    found = arenite.infer_forces(packing, swing, np.where(inside, 1e-5, 0), pixel=pixel, first=first, factor=[15e-9], walls={"bottom": force, "top": force}, blur=0.0)
    assert np.allclose(found["fn"], force, rtol=0.02)


def test_films_of_files(examples):
    films = sorted((examples.parent / "tests" / "data").rglob("*.ptw"))
    assert films
    info = arenite.film_info(str(films[0]))
    frames = arenite.read_film(str(films[0]), count=2)
    assert frames.shape == (2, info["height"], info["width"])


def test_what_films_do_not_allow_is_a_value_error():
    film, _ = swinging(frames=40)
    with pytest.raises(ValueError):
        arenite.lock_in(film, 100.0, frame_rate=148.0)
    with pytest.raises(ValueError, match="frames, height, width"):
        arenite.lock_in(film[0], 3.0, frame_rate=148.0)
