"""Cemented samples and their stresses (P figures 1 to 15)."""

import numpy as np
from matplotlib.colors import ListedColormap

from .style import bare, colours, length_bar, phase_colours, scaled, soft, strong

order = ["all", "large", "small", "particle", "matrix"]
crack_colours = {1: ("matrix", "#d62728"), 2: ("interface", "#111111"), 3: ("particle", "#ff9d00")}
set_colours = {"all": strong, "large": colours[0], "small": colours[1], "particle": colours[0], "matrix": colours[2]}


def _picture(axes, map, values, **options):
    width, height = map.width * map.dx, map.height * map.dx
    shown = axes.imshow(values, origin="lower", extent=(0, width, 0, height), interpolation="nearest", rasterized=True, **options)
    axes.set_ylim(-0.08 * height, height)
    length_bar(axes, width, 0, -0.05 * height)
    bare(axes)
    return shown


def draw_phases(axes, field):
    """Void, matrix, small and large grains; `field` is a Field or a PhaseMap."""
    map = getattr(field, "map", field)
    kind = np.array(map.phase, dtype=np.uint8)  # 0 void, 1 matrix, 2 particle, 3 small, 4 large
    grain_class = np.array(map.grain_class)
    inside = map.grain >= 0
    if len(grain_class):
        of_node = grain_class[np.where(inside, map.grain, 0)]
        kind[inside & (of_node == 1)] = 3
        kind[inside & (of_node == 2)] = 4
    palette = ListedColormap([phase_colours[name] for name in ("void", "matrix", "particle", "small", "large")])
    return _picture(axes, map, kind, cmap=palette, vmin=-0.5, vmax=4.5)


def draw_field(axes, field, component="sigma_yy", share=0.005, colour_map="RdBu_r"):
    """A stress component over its mean in the solid; colours leave out `share` of the nodes at each end, the void is white."""
    solid = field.map.phase > 0
    values = np.where(solid, getattr(field, component), np.nan)
    mean = np.nanmean(values)
    typical = np.sqrt(np.nanmean(values**2))
    values = values / (mean if abs(mean) > 0.1 * typical else typical)
    low, high = np.nanquantile(values, [share, 1 - share])
    most = max(abs(low - 1), abs(high - 1))
    return _picture(axes, field.map, values, cmap=colour_map, vmin=1 - most, vmax=1 + most)


def draw_cracks(axes, field):
    """Broken bonds on the sample, by type."""
    draw_phases(axes, field)
    crack_dots(axes, field.cracks["x"], field.cracks["y"], field.cracks["type"])


def crack_dots(axes, x, y, kinds):
    """A dot at every broken bond, by type; the key says how many."""
    for kind, (name, colour) in crack_colours.items():
        of = kinds == kind
        if of.any():
            axes.plot(x[of], y[of], ".", color=colour, markersize=0.8, label=f"{name} {of.sum()}", rasterized=True)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, 0), ncols=3, markerscale=6, handletextpad=0.2)


def draw_broken_bonds(axes, field):
    """Number of broken bonds by type over the steps of a pull."""
    until = np.asarray(field.curve["broken"], int)
    step = np.arange(1, len(until) + 1)
    for kind, (name, colour) in crack_colours.items():
        count = np.concatenate([[0], np.cumsum(field.cracks["type"] == kind)])
        axes.step(step, count[np.minimum(until, len(count) - 1)], where="post", color=colour, label=name)
    axes.set(xlabel="step", ylabel="broken bonds", ylim=(0, None))
    axes.legend()


def draw_densities(axes, statistics, component="sigma_yy", own=False, log=True):
    """Densities of a component by phase over the sample's mean, or over each phase's `own` (P Figs. 9, 13, 14)."""
    sets = statistics["components"][component]["sets"] if "components" in statistics else statistics[component]["sets"]
    most = 0.0
    for name in order:
        curve = sets.get(name, {}).get("own_pdf" if own else "pdf")
        if curve is None or (name == "particle" and "large" in sets):
            continue
        x, y = np.array(curve["x"]), np.array(curve["y"])
        most = max(most, y.max())
        axes.plot(x[y > 0], y[y > 0], color=set_colours[name], label=name, linewidth=1.4 if name == "all" else 1.0)
    axes.axvline(1, color=soft, linewidth=0.6, linestyle=":")
    symbol = component.replace("sigma_", r"\sigma_{") + "}"
    axes.set(xlabel=f"${symbol}/\\langle {symbol}\\rangle$" + (" of the phase" if own else ""), ylabel="probability density")
    if log:
        axes.set(yscale="log", ylim=(2e-5 * most, 2 * most))
    axes.legend()


def draw_cavities(axes, volumes, label="pores"):
    """Density of the volume of single pores or voids; `volumes` in m^2 over pi r_L^2 or any other unit."""
    volumes = np.asarray(volumes, float)
    edges = np.geomspace(volumes.min(), volumes.max() * 1.0001, 16)
    count, _ = np.histogram(volumes, edges)
    seen = count > 0
    density = count / len(volumes) / np.diff(edges)
    axes.errorbar(np.sqrt(edges[1:] * edges[:-1])[seen], density[seen], yerr=(density / np.sqrt(np.maximum(count, 1)))[seen] * 0.95, fmt="o-", elinewidth=0.7, label=f"{label} {len(volumes)}")
    axes.set(xscale="log", yscale="log", xlabel=r"$V/(\pi\,\overline{r}^2)$", ylabel="probability density")
    axes.legend()


def draw_convergence(axes, convergence):
    """Relative residual of the solver."""
    axes.semilogy(convergence["iteration"], convergence["residual"], "o-" if len(convergence["residual"]) < 60 else "-", color=colours[0])
    axes.set(xlabel="iteration", ylabel="relative residual")


def draw_stress_strain(axes, curve):
    """Mean stress of the pulled row against strain, before every round of breaking."""
    factor, unit = scaled(np.max(curve["stress"]), "Pa")
    axes.plot(1e3 * np.append(0, curve["strain"]), np.append(0, curve["stress"]) / factor, color=colours[0])
    axes.set(xlabel=r"strain, $10^{-3}$", ylabel=f"stress, {unit}", ylim=(0, None), xlim=(0, None))


def draw_energy_balance(axes, curve):
    """Work of the clamp, stored elastically or released by broken bonds, per unit thickness."""
    factor, unit = scaled(np.max(curve["work"]), "J/m")
    step = np.arange(1, len(curve["work"]) + 1)
    axes.stackplot(step, curve["released"] / factor, curve["elastic"] / factor, labels=["released", "elastic"], colors=[colours[1], colours[0]], alpha=0.5, linewidth=0)
    axes.plot(step, curve["work"] / factor, color=strong, label="work")
    axes.set(xlabel="step", ylabel=f"energy, {unit}")
    axes.legend()
