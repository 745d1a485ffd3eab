"""Studies run in a separate interpreter: each run forks, which a process that has used threads must not do."""

import os
import pathlib
import pickle
import subprocess
import sys
from typing import Any, Callable, Dict, Optional, Union

from . import _core


def run_study(
    recipe: Union[str, os.PathLike],
    out: Union[str, os.PathLike],
    *,
    jobs: Optional[int] = None,
    progress: Optional[Callable[[float, str], Any]] = None,
) -> Dict[str, int]:
    """Runs a recipe with [sweep], each run in its own process; finished runs are not repeated.

    `progress(share, "runs")` is called meanwhile. Returns the numbers of runs that are done, not done (failed or
    without equilibrium) and left. Raises ValueError with the program's message.
    """
    command = [
        sys.executable,
        "-c",
        "from arenite import studies; studies._main()",
        os.fspath(recipe),
        os.fspath(out),
        "" if jobs is None else str(jobs),
    ]
    last = {}
    with subprocess.Popen(command, stdout=subprocess.PIPE, env=_environment()) as process:
        try:
            for last in _heard(process.stdout):
                if "share" in last and progress:
                    progress(last["share"], "runs")
        except BaseException:
            process.terminate()
            raise
    if "error" in last:
        raise ValueError(last["error"])
    if process.returncode != 0 or "done" not in last:
        raise RuntimeError(f"the study's process ended with status {process.returncode}")
    return last


run_study.__doc__ += "\n\n" + _core._run_study.__doc__.split("\n\n")[-1]


def _heard(pipe):
    """The messages of the process, one dict after the other."""
    while True:
        try:
            yield pickle.load(pipe)
        except (EOFError, pickle.UnpicklingError):  # it has ended, or was ended in the middle of a word
            return


def _environment():
    """The new interpreter must find this module at the same place."""
    home = str(pathlib.Path(__file__).resolve().parent.parent)
    return {**os.environ, "PYTHONPATH": os.pathsep.join([home, *filter(None, [os.environ.get("PYTHONPATH")])])}


def _main():
    recipe, out, jobs = sys.argv[1:]

    def say(**words):
        pickle.dump(words, sys.stdout.buffer)
        sys.stdout.buffer.flush()

    try:
        say(
            **_core._run_study(
                recipe, out, jobs=int(jobs) if jobs else None, progress=lambda share, _: say(share=share)
            )
        )
    except ValueError as error:
        say(error=str(error))
