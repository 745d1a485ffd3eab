import os
import pathlib
import subprocess

import pytest

root = pathlib.Path(__file__).resolve().parents[2]


def run(*words, ok=True, **options):
    """What a command says; it must end well, or with ok=False badly."""
    done = subprocess.run(
        [str(word) for word in words], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options
    )
    assert (done.returncode == 0) == ok, done.stdout[-4000:]
    return done.stdout


@pytest.fixture(scope="session")
def build():
    """The build that is tested."""
    return pathlib.Path(os.environ["ARENITE_BUILD_FOLDER"])
