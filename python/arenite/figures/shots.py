"""Stored states of stages, one after another."""

import dataclasses
import typing

from .. import _core
from .._core import SpherePacking


@dataclasses.dataclass
class Shot:
    """A stored state and its stage; `sheared` is the shear strain of a sheared cell at that time, 0 in others."""

    stage: typing.Any
    snapshot: typing.Any
    sheared: float = 0.0

    @property
    def packing(self):
        return self.snapshot.packing

    @property
    def in_space(self):
        return isinstance(self.packing, SpherePacking)

    @property
    def contacts(self):
        """What has the forces: of spheres the packing itself."""
        return self.packing if self.in_space else self.packing.contacts


def shots_of(result, stage=None):
    """The stored states of a stage, or of all. Raises ValueError if there are fewer than two."""
    stages = [*result.stages, *getattr(result, "spheres", [])]
    if stage is not None and stage not in [part.name for part in stages]:
        raise ValueError(f"there is no stage {stage}; there are {', '.join(part.name for part in stages)}")
    shots = [
        Shot(part, snapshot, sheared_at(part, snapshot.time))
        for part in stages
        if stage in (None, part.name)
        for snapshot in part.snapshots
    ]
    if len(shots) < 2:
        what = f"the stage {stage}" if stage else "this result"
        raise ValueError(
            f"{what} holds {['no', 'one'][len(shots)]} stored state of a loading, too few for an animation; "
            "`snapshots` or `increments` of a stage store more"
        )
    return shots


def sheared_at(stage, time):
    history = stage.history
    return _core._at_time(history["time"], history["shear_strain"], time) if "shear_strain" in history else 0.0
