"""From an infrared film to stresses and contact forces, on a film with known forces: simulate, film, measure,
compare."""

# %% A small sample between two loads, as laboratory sample 8 is simulated.
import pathlib

import numpy as np

import arenite
from arenite import figures

here = pathlib.Path(__file__).resolve().parent
example = here.parent / "40-virtual-experiment"
sample = arenite.Recipe(
    example / "sample.toml",
    {
        "container.width": "140 mm",
        "populations.0.count": 48,
        "populations.1.count": 64,
        "stages.1.bottom.force": "24 kN",
        "stages.2.bottom.force": "2.4 kN",
        "stages.3.bottom.force": "24 kN",
    },
)
states = arenite.run(sample, "states")

# %% A virtual camera films both states: 20 mK of noise, non-uniform pixels, drift, an inexact frequency.
frame = states.stages[-2].packing.domain
camera = {
    "container.width": f"{1e3 * frame['width']} mm",
    "container.height": f"{1e3 * frame['height']} mm",
    "camera.frames": 600,
    "camera.width": 120,
    "camera.height": 120,
}
files = arenite.camera("states", example / "camera.toml", "film", changes=camera)
print(arenite.film_info(files[0]))

# %% The film alone: lock-in with the frequency refined on all pixels.
maps = arenite.lock_in(files[0], "3 Hz", peak_to_peak=True)
print(f"{maps.frequency:.5f} +- {maps.frequency_error:.5f} Hz, noise floor {np.median(maps.noise_floor):.2f} levels")

# %% The whole workflow: grains found and followed, their stresses measured, forces inferred.
result = arenite.film(files[0], files[-1], "measured")
print(f"{len(result.grains)} grains, {len(result.packing.contacts)} contacts")
print(
    f"median error of a normal force: {np.median(result.fn_error):.1f} N of "
    f"{np.mean(np.abs(result.packing.contacts.fn)):.0f} N"
)

# %% Figures.
for path in figures.save_all("measured", "figures", ("png",), ["grains", "maps", "forces"]):
    print(path)
