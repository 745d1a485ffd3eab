import os
import pathlib
import subprocess
import sys

import pytest

scripts = sorted((pathlib.Path(__file__).resolve().parents[2] / "examples" / "50-python").glob("*.py"))


@pytest.mark.parametrize("script", scripts, ids=[s.stem for s in scripts])
def test_example_runs_as_it_stands(script, tmp_path):
    run = subprocess.run(
        [sys.executable, "-B", str(script)],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": os.environ["ARENITE_PYTHONPATH"]},
    )
    assert run.returncode == 0, run.stderr[-2000:]
    assert run.stdout and list(tmp_path.iterdir())
