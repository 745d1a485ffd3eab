"""Grains of two materials: make a packing, load it, measure how it transmits stress.

Cells begin at `# %%`: run the file as a whole, or cell by cell in an editor or a notebook.
"""

# %% A recipe: laboratory sample 8 of the thesis with fewer grains.
import numpy as np

import arenite
from arenite import figures

recipe = arenite.Recipe.template(
    "composite", {"container.width": "140 mm", "populations.0.count": 48, "populations.1.count": 64}
)
print(recipe.title, recipe.stages)

# %% Pack, then load stage by stage; every stage takes the packing of the one before.
packing = arenite.pack(recipe)
stages = []
for name in recipe.stages:
    stages.append(arenite.load_stage(packing, recipe, name))
    packing = stages[-1].packing
    print(f"{name}: {stages[-1].outcome}")

# %% Texture: each statistic with its standard error.
texture = arenite.measure(packing)
for name in ["all", "without_rattlers"]:
    z = texture["coordination"][name]
    print(f"z {name}: {z['value']:.2f} +- {z.get('error', float('nan')):.2f}")

# %% Grain by grain, as arrays: which material carries more?
grains = arenite.measure_grains(packing)
for number, material in enumerate(packing.materials):
    of = (packing.material == number) & grains["considered"]
    print(f"{material.name}: mean sigma_norm {np.mean(grains['sigma_norm'][of]):.3f}")

# %% The stages as one result: stored, shown on a page, exported for ParaView.
result = arenite.Result(stages)
arenite.save(result, "loaded")
arenite.page(result, "report.html")
print(arenite.export(result, "vtk", last=True))

# %% Figures for a paper.
for path in figures.save_all(result, "figures", names=["force-network", "contact-orientations", "sigma-norm"]):
    print(path)
