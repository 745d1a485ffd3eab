#!/usr/bin/env python3
"""Runs for an instant what needs more than itself: `tables` on a small simulated sample, `peers` beside the programs
here.

usage: bench/instant.py tables|peers BUILD_FOLDER
"""
import ast
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
EXAMPLE = HERE.parent / "examples" / "40-virtual-experiment"


def run(*command):
    """What a command prints; ends with its complaint where it fails."""
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} ended with {done.returncode}:\n{done.stdout[-4000:]}")
    return done.stdout


def settings(**values):
    return [word for key, value in values.items() for word in ("--set", f"{key.replace('__', '.')}={value}")]


def small_states(build, folder):
    """The example's sample with 42 grains, loaded by a twentieth of its forces."""
    keys = {
        "populations__0__count": 20,
        "populations__1__count": 22,
        "container__width": '"95 mm"',
        "packing__solid_fraction": 0.7,
        "integration__track_energy": "false",
    }
    for stage, force in ((1, 16), (2, 1.6), (3, 16)):
        keys[f"stages__{stage}__bottom__force"] = f'"{force} kN"'
        keys[f"stages__{stage}__increments"] = 2
    run(build / "arenite", "run", EXAMPLE / "sample.toml", "--quiet", "--out", folder, *settings(**keys))
    return sorted(folder.glob("*.h5"))


def run_tables(build):
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        files = small_states(build, folder / "states")
        forces = run(build / "bench" / "force_errors", files[-2], files[-1])
        assert forces.count("\n") > 5, forces
        camera = run(
            build / "bench" / "camera_table",
            folder / "states",
            small_camera(folder),
            folder / "films",
            1,
            "nothing moves",
        )
        assert "| nothing moves" in camera, camera


def small_camera(folder):
    """The example's camera with a short film."""
    recipe, text = folder / "camera.toml", (EXAMPLE / "camera.toml").read_text()
    assert "frames = 2960\n" in text
    recipe.write_text(text.replace("frames = 2960\n", "frames = 300\n"))
    return recipe


def run_peers(build):
    for script in (HERE / "peers").iterdir():
        if script.suffix == ".py" or script.read_text(errors="replace").startswith("#!/usr/bin/env python3"):
            ast.parse(script.read_text(), str(script))
    run(sys.executable, HERE / "peers" / "lockin_numpy.py", 200)
    run(sys.executable, HERE / "peers" / "run", build, 0)
    if (build / "python" / "arenite").exists():
        module = f"PYTHONPATH={build / 'python'}"
        berea = HERE.parent / "examples" / "35-berea" / "berea.npz"
        run("env", module, sys.executable, "-B", HERE / "peers" / "fft_voxels.py", berea, 16, 20)
    run("lmp", "-in", HERE / "peers" / "peridynamics.in", "-log", "none", "-var", "nodes", 16, "-var", "steps", 4)
    for name, *sample in (("petsc_gamg", 64, 2.5, 0.4), ("petsc_voxels", 16, 4, 0)):
        if (build / "bench" / "peers" / name).exists():
            run(build / "bench" / "peers" / name, *sample)


if __name__ == "__main__":
    {"tables": run_tables, "peers": run_peers}[sys.argv[1]](pathlib.Path(sys.argv[2]).resolve())
