"""A cemented packing under tension: how do stiffness and stress depend on the amount of matrix?"""

# %% Disks of two sizes, compacted.
import numpy as np

import arenite
from arenite import figures

recipe = arenite.Recipe.template("cemented", {"bidisperse.box_area": 100, "bidisperse.size_ratio": 1.67})
packing = arenite.pack(recipe)
for name in recipe.stages:
    packing = arenite.load_stage(packing, recipe, name).packing
print(packing)

# %% The same packing with increasing amounts of matrix, on 256 x 256 nodes, in tension to a strain of 1e-4.
rows = []
for width in [0.1, 0.3, 0.6, 1.0]:
    cement = arenite.cement(packing, "bridges", gap="0.075 mm", width=width)
    map = arenite.rasterise(packing, cement, nodes=256, crop="12 mm")
    field = arenite.load(map, "tension", strain=1e-4, matrix="1 GPa")
    saturation = np.sum(map.phase == 1) / np.sum(map.phase < 2)
    stiffness = field.sigma_yy.mean(axis=1)[8:-8].mean() / 1e-4
    rows.append((saturation, stiffness))
    print(f"S_m {saturation:.3f}: E {stiffness / 1e9:.3f} GPa")

# %% The densities of the node stresses by phase, and the field, for a paper.
from matplotlib.figure import Figure

with figures.journal_style():
    canvas = Figure(figsize=(figures.page_width, 2.6), layout="constrained")
    left, right = canvas.subplots(1, 2)
    figures.draw_field(left, field)
    figures.draw_panel(right, figures.describe(field)["stress-pdf"][0]["panels"][1])
    canvas.savefig("cemented.pdf")

# %% Voids of the sample with the least matrix.
cement = arenite.cement(packing, "bridges", gap="0.075 mm", width=0.1)
voids = arenite.cavities(arenite.rasterise(packing, cement, nodes=256, crop="12 mm"), "void")
print(f"{len(voids)} voids, mean {voids.mean():.1f} nodes")
