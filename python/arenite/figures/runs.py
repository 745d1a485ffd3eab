"""Figures of several results, each one point: rheology, critical states and the laws of flows."""

import pathlib

from .. import _core
from .._core import open as open_result
from ..curves import Test, find_test, in_plane
from ..flows import last_stages
from .drawing import draw_described, heads
from .saving import Figure


of_histories = ("rheology", "critical-state")


def last_stage(result):
    """Whose numbers tell of a flow."""
    return Test(*last_stages([result]), None)


def done_runs(study):
    """Results of the finished runs of a study."""
    path = pathlib.Path(study)
    runs = sorted(((path if path.is_dir() else path.parent) / "runs").glob("*/status"))
    return [open_result(str(run.parent)) for run in runs if run.read_text(encoding="utf-8").split()[:1] == ["done"]]


def figures_of_study(study):
    """Ids of the figures that suit the runs of a study."""
    return _core.study_kind(study)["figures"]


def drawings_of_runs(name, results):
    """What the figure `name` shows of results that have a stage with a history, their last."""
    tests = [find_test(result) if name in of_histories else last_stage(result) for result in results]
    stages, before = [test.stage for test in tests], [in_plane(*test) for test in tests]
    return _core._figure_of_runs(name, stages, before)["drawings"]


def draw_runs(figure, name, results):
    """One of the figures of several results, by its name: rheology, critical-state, beverloo, runout or janssen."""
    draw_described(figure, drawings_of_runs(name, results))


def over_runs(study):
    """(figure, drawings) of those that suit the runs of a study and have something to draw."""
    names = figures_of_study(study)
    results = done_runs(study) if names else []
    for name in names:
        head = next(head for head in heads()["runs"] if head["id"] == name)
        if drawings := drawings_of_runs(name, results):
            yield Figure(name, "study", draw_described, wide=head.get("wide", False), head=head), drawings
