#!/usr/bin/env python3
"""The spectral scheme that most codes for images in space begin with, beside elements under several levels.

usage: bench/peers/fft_voxels.py [IMAGE.npz] [VOXELS] [ITERATIONS] [--picture FILE]     (examples/35-berea, 64, 1000)
A cube of a porous image, whose pores are above 0, is strained by the basic scheme of Moulinec and Suquet (1998) and by
conjugate gradients on the same equation (Zeman et al. 2010), in NumPy, and by this program's elements between clamps.
Every residual is the force that is out of balance over that of the cube strained uniformly; CPU seconds are of one
core. The picture has all three.
"""
import argparse
import json
import os
import resource
import sys

for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ.setdefault(name, "1")

import numpy as np

import arenite

POISSON = 0.3
HERE = os.path.dirname(os.path.abspath(__file__))


def cpu_seconds():
    return resource.getrusage(resource.RUSAGE_SELF).ru_utime


class Spectral:
    """A cube that repeats itself: strains as 3 x 3 fields on its voxels."""

    def __init__(self, solid):
        mu = 1 / (2 * (1 + POISSON))
        lame = POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
        self.mu, self.lame = mu * solid, lame * solid  # Young's modulus 1, voids without stiffness
        self.mu_0, self.lame_0 = 0.5 * mu, 0.5 * lame  # the mean of the largest and the smallest, the best for voids
        count = solid.shape[0]
        full, half = np.fft.fftfreq(count), np.fft.rfftfreq(count)
        self.wave = np.stack(np.meshgrid(full, full, half, indexing="ij"))
        for axis, frequencies in enumerate((full, full, half)):  # Nyquist's has no direction
            self.wave[axis][np.isclose(np.abs(self.wave[axis]), 0.5)] = 0
        square = np.sum(self.wave**2, axis=0)
        self.direction = self.wave / np.sqrt(np.where(square > 0, square, 1))
        self.begin = None

    def stress(self, strain):
        trace = strain[0, 0] + strain[1, 1] + strain[2, 2]
        stress = 2 * self.mu * strain
        for k in range(3):
            stress[k, k] += self.lame * trace
        return stress

    def out_of_balance(self, transformed):
        """|div sigma| over that of the first strain, which is uniform."""
        force = np.einsum("k...,ki...->i...", self.wave, transformed)
        size = np.linalg.norm(force)
        self.begin = self.begin or size
        return size / self.begin

    def answer(self, strain):
        """The strain that the reference medium answers the stress of `strain` with, and the residual of this stress."""
        transformed = np.fft.rfftn(self.stress(strain), axes=(2, 3, 4))
        n = self.direction
        force = np.einsum("ki...,k...->i...", transformed, n)
        along = np.einsum("i...,i...->...", force, n)
        share = (self.lame_0 + self.mu_0) / (self.mu_0 * (self.lame_0 + 2 * self.mu_0))
        answer = (n[:, None] * force[None, :] + n[None, :] * force[:, None]) / (2 * self.mu_0)
        answer -= share * n[:, None] * n[None, :] * along
        return np.fft.irfftn(answer, s=strain.shape[2:], axes=(2, 3, 4)), self.out_of_balance(transformed)


def basic(cube, strain, iterations):
    residuals = []
    for _ in range(iterations):
        answer, residual = cube.answer(strain)
        residuals.append(residual)
        strain = strain - answer
    return residuals


def conjugate_gradients(cube, strain, iterations):
    answer, residual = cube.answer(strain)
    rest, residuals = -answer, [residual]
    direction, square = rest, np.vdot(rest, rest)
    for _ in range(iterations - 1):
        pull, _ = cube.answer(direction)
        step = square / np.vdot(direction, pull)
        strain = strain + step * direction
        rest = rest - step * pull
        residuals.append(cube.out_of_balance(np.fft.rfftn(cube.stress(strain), axes=(2, 3, 4))))
        last, square = square, np.vdot(rest, rest)
        direction = rest + square / last * direction
    return residuals


def spectral(solid, scheme, iterations):
    strain = np.zeros((3, 3) + solid.shape)
    strain[2, 2] = 1
    begin = cpu_seconds()
    residuals = scheme(Spectral(solid), strain, iterations)
    return residuals, cpu_seconds() - begin


def elements(solid):
    voxels = arenite.VoxelMap(np.where(solid > 0, 2, 0).astype(np.uint8), np.where(solid > 0, 0, -1), dx=1e-6)
    begin = cpu_seconds()
    result = arenite.load_voxels(voxels, method="elements", particle="1 GPa", matrix_poisson=POISSON)
    return list(result.convergence["residual"]), cpu_seconds() - begin


def draw(file, image, solid, curves):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, sides = plt.subplots(1, 2, figsize=(7.5, 3.2), sharey=True, constrained_layout=True)
    for (name, (residuals, seconds)), colour in zip(curves.items(), ("#c0392b", "#e08e0b", "#1f5fa8")):
        steps = np.arange(len(residuals))
        sides[0].loglog(steps + 1, residuals, color=colour, label=name)
        sides[1].loglog(seconds * (steps + 1) / len(residuals), residuals, color=colour)
    sides[0].set(xlabel="iterations", ylabel="force out of balance\nover that of uniform strain")
    sides[1].set(xlabel="CPU seconds, set-up included")
    sides[0].legend(frameon=False, fontsize=7, handlelength=1.2, loc="center right")
    figure.suptitle(f"{image}, {solid.shape[0]}$^3$ voxels, {100 * (1 - solid.mean()):.0f} % pores", fontsize=9)
    figure.savefig(file, dpi=150)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("image", nargs="?", default=os.path.join(HERE, "../../examples/35-berea/berea.npz"))
    parser.add_argument("voxels", nargs="?", type=int, default=64)
    parser.add_argument("iterations", nargs="?", type=int, default=1000)
    parser.add_argument("--picture")
    given = parser.parse_args()
    with np.load(given.image) as file:
        pores = file[file.files[0]][: given.voxels, : given.voxels, : given.voxels] > 0
    solid = np.where(pores, 0.0, 1.0)
    curves = {
        "basic scheme": spectral(solid, basic, given.iterations),
        "conjugate gradients, spectral": spectral(solid, conjugate_gradients, given.iterations),
        "elements, several levels": elements(solid),
    }
    for name, (residuals, seconds) in curves.items():
        print(
            json.dumps({"solver": name, "iterations": len(residuals) - 1, "residual": residuals[-1], "cpu_s": seconds})
        )
    if given.picture:
        draw(given.picture, os.path.basename(given.image).split(".")[0], solid, curves)


if __name__ == "__main__":
    sys.exit(main())
