"""Many runs as one table: how does the coordination number depend on friction?"""

# %% A recipe with [sweep]: three friction coefficients, two seeds each.
import pathlib

from matplotlib.figure import Figure

import arenite
from arenite import figures

recipe = arenite.Recipe.template(
    "composite", {"container.width": "120 mm", "populations.0.count": 30, "populations.1.count": 40}
)
file, out = pathlib.Path("recipe.toml"), pathlib.Path("study")
file.write_text(recipe.toml() + '\n[sweep]\nreplicates = 2\n[sweep.grid]\n"contact.friction" = [0.05, 0.3, 0.6]\n')

# %% All runs, two at a time; the same call continues where it was stopped.
print(arenite.run_study(file, out, jobs=2))

# %% Means over the seeds, as columns.
table = arenite.study_table(file, out, by=["contact.friction"])
friction, z, error = table["contact.friction"], table["coordination.all"], table["coordination.all_error"]
for row in zip(friction, z, error):
    print("mu {:.2f}: z = {:.2f} +- {:.2f}".format(*row))

# %% One figure.
with figures.journal_style():
    canvas = Figure(figsize=(figures.column_width, 2.4), layout="constrained")
    axes = canvas.add_subplot()
    axes.errorbar(friction, z, yerr=error, fmt="o-")
    axes.set(xlabel=r"$\mu$", ylabel="$z$")
    canvas.savefig("coordination.pdf")
