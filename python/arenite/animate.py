"""Animations of a run along its loading: `save(result, "run.mp4", by="pressure")`, or `python3 -m arenite.animate
RESULT`.

ffmpeg, if installed, writes an MP4; Pillow, which comes with Matplotlib, a GIF.
"""

import os
import pathlib
import sys
import types

from . import _core
from ._core import open as open_result
from ._said import carry_out, said, tell
from ._written import written_whole

no_ffmpeg = "ffmpeg is not installed (Debian: apt-get install ffmpeg), so this is a GIF: larger, and with fewer colours"
colourings = tuple(_core._colourings)


def save(result, path, by=None, *, low=None, high=None, size=None, curve=None, progress=None, **asked):
    """Writes the stored states of a result (a Result or its path) as an animation; returns its path, which ends in .gif
    instead of .mp4 if ffmpeg is not installed. `low` and `high` are in SI units, `size` is (width, height), `curve`
    ("axial_strain", "top_force"), columns of `curves.along` or of the history, or "test"; `progress(share, "states")`
    is called meanwhile. Raises ValueError. What is asked for:"""
    from .figures import moving
    from .figures.shots import shots_of
    from .figures.style import journal_style

    told = {"size": size and "x".join(str(n) for n in size), "curve": curve and str(curve)}
    wanted = types.SimpleNamespace(**_core._animation(by=by, **told, **asked))
    path = pathlib.Path(path)
    refuse(path, wanted.colour_map)
    refuse_scale(wanted, low, high)
    result = open_result(os.fspath(result)) if isinstance(result, (str, os.PathLike)) else result
    shots = shots_of(result, wanted.stage)
    if path.suffix == ".mp4" and not has_ffmpeg():
        path = path.with_suffix(".gif")
    with journal_style(**moving.text_size):
        even = [2 * (n // 2) for n in wanted.size]  # video codecs halve both sides
        beside = curve and moving.Beside(result, curve)
        pictures = moving.Pictures(shots, wanted.by, even, wanted.chains, wanted.colour_map, low, high, beside)
        path.parent.mkdir(parents=True, exist_ok=True)
        with written_whole(path) as part:
            write = write_mp4 if path.suffix == ".mp4" else write_gif
            write(part, pictures, wanted.fps, progress or (lambda share, name: None))
    return path


# The library says of each what its key says, to a line.
save.__doc__ += "\n\n" + _core._animation.__doc__.split("\n\n")[-1]


def refuse(path, colour_map):
    """Raises ValueError for what the library knows nothing of."""
    import matplotlib

    if path.suffix not in (".mp4", ".gif"):
        raise ValueError(f"{path}: give a name that ends in .mp4 or .gif")
    if colour_map is not None and colour_map not in matplotlib.colormaps:
        raise ValueError(
            f"Matplotlib has no colour map {colour_map}; examples are viridis, magma_r, RdBu_r, cividis and turbo"
        )


def refuse_scale(wanted, low, high):
    """Raises ValueError for a colour scale that shows no state, its ends in SI units."""
    if high is None:
        return
    if wanted.never_negative and high <= 0:
        raise ValueError(f"the colour scale of {wanted.by}, which is never below 0, cannot end at {high:g}; raise it")
    if low is not None and high <= low:
        raise ValueError(f"the colour scale of {wanted.by} cannot go from {low:g} to {high:g}; give a high above low")


def has_ffmpeg():
    from matplotlib import animation

    return animation.writers.is_available("ffmpeg")


def write_mp4(path, pictures, fps, progress):
    """With ffmpeg, which receives the images as they are drawn; in a format that every player and presentation program
    reads."""
    from matplotlib import animation

    writer = animation.FFMpegWriter(
        fps=fps, codec="h264", extra_args=["-pix_fmt", "yuv420p", "-crf", "20", "-movflags", "+faststart"]
    )
    with writer.saving(pictures.figure, os.fspath(path), pictures.figure.dpi):
        for k in range(len(pictures)):
            pictures.image(k)
            writer.grab_frame()
            progress((k + 1) / len(pictures), "states")


def write_gif(path, pictures, fps, progress):
    """With Pillow, without dithering, which would make static parts flicker."""
    from PIL import Image

    def image(k):
        return Image.fromarray(pictures.image(k)[..., :3].copy())

    palette = palette_of(
        [image(k) for k in (0, len(pictures) // 2, len(pictures) - 1)],
        pictures.style.get("colour_map"),
        scale=40 if pictures.shots[0].in_space else 176,  # surfaces that are lit have many shades
    )
    frames = []
    for k in range(len(pictures)):
        frames.append(image(k).quantize(palette=palette, dither=Image.Dither.NONE))
        progress((k + 1) / len(pictures), "states")
    frames[0].save(path, save_all=True, append_images=frames[1:], duration=max(20, round(100 / fps) * 10), loop=0)


def palette_of(images, colour_map=None, scale=176):
    """256 colours for all states: those of lines, `scale` colours evenly along the colour map if there is one, the
    others from some states."""
    import matplotlib
    import numpy as np
    from PIL import Image

    from .figures import style

    sample = Image.new("RGB", (images[0].width, len(images) * images[0].height))
    for k, part in enumerate(images):
        sample.paste(part, (0, k * part.height))
    fixed = ["#ffffff", style.strong, style.weak, style.pale, style.tension, *style.colours]
    fixed = np.round(255 * matplotlib.colors.to_rgba_array(fixed)[:, :3]).astype(int).ravel().tolist()
    if colour_map is not None:
        fixed += matplotlib.colormaps.get_cmap(colour_map)(np.linspace(0, 1, scale), bytes=True)[:, :3].ravel().tolist()
    palette = Image.new("P", (1, 1))
    palette.putpalette(fixed + sample.quantize(256 - len(fixed) // 3).getpalette()[: 3 * 256 - len(fixed)])
    return palette


def main(result, out=None, map=None, curve=None, **options):
    """Implements `arenite animate`, whose options are declared by the program: prints the path; status 2 and a message
    on stderr for bad input."""
    folder = pathlib.Path(result) if os.path.isdir(result) else pathlib.Path(result).parent
    try:
        written = save(
            result,
            out or folder / "animation.mp4",
            colour_map=map,
            curve=curve and pair(curve),
            progress=progress_on(sys.stderr),
            **options,
        )
    except ValueError as error:
        return said(str(error))
    except ImportError as error:
        return said(
            "an animation needs Matplotlib and Pillow (Debian: apt-get install python3-matplotlib python3-pil): "
            f"{error}"
        )
    except OSError as error:
        return said(
            f"{error.filename or out}: cannot be written ({error.strerror or error}); choose another file with --out"
        )
    if written.suffix == ".gif" and not (out or "").endswith(".gif"):
        tell(f"arenite: {no_ffmpeg}", sys.stderr)
    tell(f"{written}")
    return 0


def pair(text):
    """("x", "y") of "x,y", and "test" unchanged."""
    if text == "test":
        return text
    names = [name.strip() for name in text.split(",")]
    if len(names) != 2 or not all(names):
        raise ValueError(f"--curve {text}: give two names, X,Y, such as axial_strain,top_force")
    return names


def progress_on(stream):
    """Progress on a terminal, none elsewhere."""
    if not stream.isatty():
        return None
    return lambda share, name: print(
        f"\r{name} {100 * share:3.0f} %", end="\n" if share == 1 else "", file=stream, flush=True
    )


if __name__ == "__main__":
    carry_out(main)
