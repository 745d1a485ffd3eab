"""arenite-petsc under mpirun against `arenite load`: the same files in, the same field out, on any number of ranks.

`make petsc` runs it; ARENITE and ARENITE_PETSC name the programs.
"""

import json
import os
import pathlib
import subprocess

import h5py
import numpy as np
import pytest

ARENITE, PETSC = os.environ["ARENITE"], os.environ["ARENITE_PETSC"]
FIELDS = ("ux", "uy", "uz", "sigma_xx", "sigma_yy", "sigma_zz", "sigma_yz", "sigma_xz", "sigma_xy")
# Both are solved to a residual of 1e-9 of that of uniform strain, which leaves some 1e-9 of the stress; what is
# stored in single precision is rounded at 6e-8 of itself.
HOW = ["--method", "elements", "--tolerance", "1e-9", "--dx", "10 um", "--phases", "0=void,1=matrix,2=particle"]
MATERIAL = ["--stiffness", "matrix=1 GPa,interface=0.5 GPa,particle=20 GPa", "--poisson", "matrix=0.4,particle=0.2"]


def mpirun(ranks, *arguments):
    alone = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks), PETSC, "load"]
    return subprocess.run([*alone, *map(str, arguments)], capture_output=True, text=True)


def ours(*arguments):
    return subprocess.run([ARENITE, "load", *map(str, arguments)], capture_output=True, text=True, check=True)


def result_in(folder):
    (file,) = folder.glob("*.h5")
    return file


def packing(size):
    """Spheres of radius 6 with necks, a part that floats and one that hangs on the upper clamp, in an odd box."""
    z, y, x = np.mgrid[0 : size[2], 0 : size[1], 0 : size[0]]
    phase = np.zeros(x.shape, np.uint8)
    step = 10
    centres = [(i, j, k) for i in range(0, 40, step) for j in range(0, 40, step) for k in range(0, 40, step)]
    for a, b, c in centres:
        a, b, c = a + (c + b) % 3, b + (a + c) % 4 - 1, c + (a + 2 * b) % 3 - 1
        near = np.hypot(x - a, y - b) < 2.5
        phase[(phase == 0) & near & (abs(z - c) <= 6)] = 1
        phase[(x - a) ** 2 + (y - b) ** 2 + (z - c) ** 2 < 26] = 2
    phase[:, :6, :6] = 0
    phase[8:11, 1:4, 1:4] = 2
    phase[-3:, 1:3, 1:3] = 1
    return phase


@pytest.fixture(scope="module")
def sample(tmp_path_factory):
    file = tmp_path_factory.mktemp("sample") / "map.npy"
    np.save(file, packing((21, 24, 25)))
    return file


def compare(first, second):
    with h5py.File(first) as a, h5py.File(second) as b:
        assert np.array_equal(a["map/phase"][:], b["map/phase"][:])
        stress = max(np.abs(a["field/" + name][:]).max() for name in FIELDS[3:])
        moved = max(np.abs(a["field/" + name][:]).max() for name in FIELDS[:3])
        for name in FIELDS:
            scale = moved if name.startswith("u") else stress
            assert np.abs(a["field/" + name][:] - b["field/" + name][:]).max() <= 1e-6 * scale, name


CASES = {
    "tension": [],
    "sliding": ["--loading", "compression", "--lower", "sliding"],
    "shear": ["--loading", "shear", "--element", "full"],
}


@pytest.mark.parametrize("case", CASES)
def test_any_number_of_ranks_gives_the_field_of_the_program_itself(sample, tmp_path, case):
    options = [sample, *HOW, *MATERIAL, *CASES[case], "--json"]
    told = json.loads(ours(*options, "--out", tmp_path / "ours").stdout)
    for ranks in (1, 2, 4) if case == "tension" else (4,):
        out = tmp_path / str(ranks)
        done = mpirun(ranks, *options, "--out", out)
        assert done.returncode == 0, done.stderr
        compare(result_in(tmp_path / "ours"), result_in(out))
        numbers = json.loads(done.stdout)
        assert numbers["load"]["solver"].endswith(f"on {ranks} process{'es' if ranks > 1 else ''}")
        assert numbers["load"]["voxels"] == told["load"]["voxels"]
        assert numbers["modulus_Pa"] == pytest.approx(told["modulus_Pa"], rel=1e-6)
        assert abs(numbers["load"]["reaction_balance_error"]) < 1e-6
        # The name is that of the same load by `arenite load`, which takes it from there.
        assert result_in(out).name == result_in(tmp_path / "ours").name
    assert told["load"]["voxels"]["floating"] > 0 and told["load"]["voxels"]["held_above"] > 0


def test_what_ranks_wrote_is_shown_and_drawn(sample, tmp_path):
    assert mpirun(2, sample, *HOW, "--out", tmp_path).returncode == 0
    shown = subprocess.run([ARENITE, "show", "--json", str(tmp_path)], capture_output=True, text=True, check=True)
    assert json.loads(shown.stdout)["load"]["solver"].startswith("PETSc ")
    assert (tmp_path / "report.html").exists()


def test_what_it_cannot_do_is_refused_in_one_sentence(sample, tmp_path):
    for more, sentence in (
        (["--method", "peridynamics"], "solves samples of elements"),
        (["--method", "elements", "--effective-stiffness"], "solves no periodic samples"),
        (["--method", "elements", "--axis", "x"], "leave axis out"),
    ):
        refused = mpirun(2, sample, "--phases", "0=void,1=matrix,2=particle", *more)
        assert refused.returncode == 2 and sentence in refused.stderr, refused.stderr
    assert mpirun(2, tmp_path / "none.npy", "--method", "elements").returncode == 2


def test_a_sample_without_a_way_through_it_leaves_no_rank_waiting(tmp_path):
    phase = np.ones((8, 8, 8), np.uint8)
    phase[4] = 0
    np.save(tmp_path / "cut.npy", phase)
    cut = mpirun(2, tmp_path / "cut.npy", *HOW)
    assert cut.returncode == 3 and "none to both" in cut.stdout, cut.stdout
