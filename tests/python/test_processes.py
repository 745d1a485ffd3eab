"""Threads and forked processes beside the library: nothing waits for what is not there."""

import os
import subprocess
import sys

import numpy as np

_head = f"import sys; sys.path.insert(0, {os.environ['ARENITE_PYTHONPATH']!r})\nimport arenite\nimport numpy as np\n"


def run(program, *arguments):
    """What the program prints; a program that hangs fails the test."""
    done = subprocess.run(
        [sys.executable, "-c", _head + program, *map(str, arguments)], capture_output=True, text=True, timeout=300
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.split()


def test_films_and_results_are_read_side_by_side(tmp_path):
    import h5py

    frames = np.arange(20 * 30 * 40, dtype="uint16").reshape(20, 30, 40)
    with h5py.File(tmp_path / "film.h5", "w") as file:
        file["frames"] = frames
        file["frames"].attrs["frame_rate"] = 100.0
    program = """
import threading
film, folder = sys.argv[1:]
packing = arenite.Packing([1, 2, 3], [1, 1, 1], [.5, .5, .5], width=4, height=2)
arenite.save(packing, folder)
sums = []
def films():
    for _ in range(60):
        sums.append(int(arenite.read_film(film, count=20).astype(int).sum()))
def results():
    for _ in range(300):
        arenite.open(folder)
threads = [threading.Thread(target=work) for work in (films, results, films, results)]
for thread in threads: thread.start()
for thread in threads: thread.join()
print(len(sums), *set(sums))
"""
    assert run(program, tmp_path / "film.h5", tmp_path / "stored") == ["120", str(frames.astype(int).sum())]


def test_workers_forked_from_a_process_that_has_loaded_load():
    program = """
import multiprocessing
phases = np.ones((160, 160), dtype="uint8")
phases[60:100, 20:140] = 2
def stress(strain):
    return float(arenite.load(arenite.PhaseMap(phases, dx="1 mm"), strain=strain).sigma_yy.mean())
if __name__ == "__main__":
    here = stress(1e-4)
    with multiprocessing.get_context("fork").Pool(2) as pool:
        print(*(value == here for value in pool.map(stress, [1e-4, 1e-4, 1e-4])))
"""
    assert run(program) == ["True", "True", "True"]
