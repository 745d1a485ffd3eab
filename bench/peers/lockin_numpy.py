#!/usr/bin/env python3
"""The sums of a lock-in in NumPy, on a film like that of bench/lockin.cpp: 320 x 240 pixels of 16 bit in memory.

usage: bench/peers/lockin_numpy.py [FRAMES]         (default: 8880)
For every pixel the sums of its values weighed with 1, t, t^2, cos and sin of two harmonics, and of its squares. Two
ways: `natural` as one writes it, one product of the weights with the film, which NumPy turns to doubles; `fastest` the
fastest found: blocks of frames that fit the cache, in single precision about the first frame, multiplied by BLAS.
Prints seconds of wall and of CPU time, least of three, and GB/s by wall time.
"""
import sys
import time

import numpy as np

PIXELS, RATE, LOAD = 320 * 240, 148.0, 3.0


def draw(frames):
    rng = np.random.default_rng(1)
    noise = rng.normal(0, 4, 1 << 20).astype(np.float32)
    column = (np.arange(PIXELS) % 320 + 8000).astype(np.float32)
    film = np.empty((frames, PIXELS), np.uint16)
    for n in range(frames):
        at = int(rng.integers(noise.size - PIXELS))
        film[n] = column + 2 * n / RATE + noise[at : at + PIXELS] + 10 * np.cos(2 * np.pi * LOAD * 1.0003 * n / RATE)
    return film


def weights(frames):
    t = np.arange(frames) / RATE
    angle = 2 * np.pi * LOAD * t
    x = 2 * t / t[-1] - 1
    return np.stack([np.ones(frames), x, x * x, np.cos(angle), np.sin(angle), np.cos(2 * angle), np.sin(2 * angle)])


def natural(film, w):
    sums = np.zeros((w.shape[0], PIXELS))
    squares = np.zeros(PIXELS)
    for at in range(0, len(film), 888):  # in parts, since the film in doubles is four times as large
        part = film[at : at + 888]
        sums += np.tensordot(w[:, at : at + 888], part, axes=1)
        squares += np.einsum("np,np->p", part, part, dtype=np.float64)
    return sums, squares


def fastest(film, w, block=16, tile=9600):
    w = w.astype(np.float32)
    sums = np.zeros((w.shape[0], PIXELS), np.float32)
    squares = np.zeros(PIXELS, np.float32)
    for p in range(0, PIXELS, tile):
        base = film[0, p : p + tile].astype(np.float32)
        for at in range(0, len(film), block):
            d = film[at : at + block, p : p + tile].astype(np.float32)
            d -= base
            sums[:, p : p + tile] += w[:, at : at + block] @ d
            squares[p : p + tile] += np.einsum("np,np->p", d, d)
    return sums, squares


def main():
    frames = int(sys.argv[1]) if len(sys.argv) > 1 else 8880
    film, w = draw(frames), weights(frames)
    for way in (natural, fastest):
        wall, cpu = [], []
        for _ in range(3):
            wall_0, cpu_0 = time.perf_counter(), time.process_time()
            way(film, w)
            wall.append(time.perf_counter() - wall_0)
            cpu.append(time.process_time() - cpu_0)
        print(
            f"{way.__name__:<8} {min(wall):7.3f} s wall  {min(cpu):7.3f} s CPU  {film.nbytes / min(wall) / 1e9:6.2f} "
            "GB/s"
        )


if __name__ == "__main__":
    main()
