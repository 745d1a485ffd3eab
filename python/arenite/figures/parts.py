"""The drawable parts of a result: a stored state of a stage, fields, films, samples in space."""

import dataclasses
import typing

import numpy as np

from .. import _core


@dataclasses.dataclass
class State:
    """A stored state with its stage and all `stages` of its run."""

    name: str
    stage: typing.Any
    snapshot: typing.Any
    stages: list

    @property
    def packing(self):
        return self.snapshot.packing

    @property
    def history(self):
        return self.stage.history

    @property
    def mean_force(self):
        return _core._force_scale(self.stage, self.snapshot)[0]


def states_of(result, stage=None, state=None):
    """The state that is drawn: the last of a stage, the last of all, or the `state`-th of all stored states, from 1."""
    stages = list(result.stages)
    stored = [(part, snapshot) for part in stages for snapshot in part.snapshots]
    if state is not None:
        if not 1 <= state <= len(stored):
            raise ValueError(f"there is no stored state {state}; this result has {len(stored)}")
        part, snapshot = stored[state - 1]
        return [State(f"{part.name}-{state}", part, snapshot, stages)] if stage in (None, part.name) else []
    chosen = [(part, snapshot) for part, snapshot in stored if stage in (None, part.name)]
    return [State(part.name, part, snapshot, stages) for part, snapshot in chosen[-1:]]


def parts_of(result, stage=None, state=None):
    """(kind, part) of the drawable parts of a result."""
    names = [part.name for part in [*result.stages, *result.spheres, *result.fields, *result.films, *result.voxels]]
    if stage is not None and stage not in names:
        raise ValueError(f"there is no stage {stage}; there are {', '.join(names)}")
    yield from (("stage", shown) for shown in states_of(result, stage, state))
    yield from (("spheres", spheres) for spheres in result.spheres[-1:] if stage is None)
    yield from (("spheres", spheres) for spheres in result.spheres if spheres.name == stage)
    yield from (("field", field) for field in result.fields if stage in (None, field.name))
    yield from (("film", film) for film in result.films if stage in (None, film.name))
    yield from (("voxels", sample) for sample in result.voxels if stage in (None, sample.name))


def same_map(a, b):
    return a is b or (
        a.dx == b.dx
        and all(
            np.array_equal(getattr(a, name, None), getattr(b, name, None)) for name in ("phase", "grain", "grain_class")
        )
    )
