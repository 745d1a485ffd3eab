"""Animations of a run along its loading: `save(result, "run.mp4", by="pressure")`, or `python3 -m arenite.animate
RESULT`.

ffmpeg, if installed, writes an MP4; Pillow, which comes with Matplotlib, a GIF.
"""

import os
import pathlib
import sys

from . import _core
from ._core import open as open_result
from ._said import carry_out, said, tell
from ._written import written_whole

no_ffmpeg = "ffmpeg is not installed (Debian: apt-get install ffmpeg), so this is a GIF: larger, and with fewer colours"
colourings = tuple(_core._colourings)


def save(
    result,
    path,
    by="material",
    *,
    stage=None,
    chains=False,
    colour_map=None,
    low=None,
    high=None,
    fps=10.0,
    size=(800, 800),
    curve=None,
    progress=None,
):
    """Writes the stored states of a result (a Result or its path), or of one `stage`, as an animation; returns its
    path, which ends in .gif instead of .mp4 if ffmpeg is not installed.

    `by`: "material", "forces" (bars only), "pressure", "deviator" (Pa), "z", "velocity" (m/s), "displacement" (from
    the first state of the stage, m), "rotation" (rad), "mobilisation" (mean ``|F_t|/(mu F_n)`` of a grain);
    `chains`: also forces as bars over the grains; `colour_map`: a colour map of Matplotlib; `low`, `high`: limits
    of its scale in SI units, taken from the states unless given; `fps`: states per second; `size`: width and height
    in pixels; `curve`: ("axial_strain", "top_force"), columns of `curves.along` or of the history, drawn beside the
    grains with the current state marked, or "test": q/p or mu against strain; `progress(share, "states")` is called
    meanwhile. Raises ValueError."""
    from .figures import motion, moving
    from .figures.style import journal_style

    path = pathlib.Path(path)
    refuse(by, path, colour_map, fps, size)
    result = open_result(os.fspath(result)) if isinstance(result, (str, os.PathLike)) else result
    shots = motion.shots_of(result, stage)
    if path.suffix == ".mp4" and not has_ffmpeg():
        path = path.with_suffix(".gif")
    with journal_style(**moving.text_size):
        even = [2 * (n // 2) for n in size]  # video codecs halve both sides
        pictures = moving.Pictures(
            shots, by, chains, colour_map, low, high, even, curve and moving.Beside(result, curve)
        )
        path.parent.mkdir(parents=True, exist_ok=True)
        with written_whole(path) as beside:
            write = write_mp4 if path.suffix == ".mp4" else write_gif
            write(beside, pictures, fps, progress or (lambda share, name: None))
    return path


def refuse(by, path, colour_map, fps, size):
    """Raises ValueError for invalid arguments."""
    import matplotlib

    if by not in colourings:
        raise ValueError(f"grains cannot be coloured by {by}; there are {', '.join(colourings)}")
    if path.suffix not in (".mp4", ".gif"):
        raise ValueError(f"{path}: give a name that ends in .mp4 or .gif")
    if colour_map is not None and colour_map not in matplotlib.colormaps:
        raise ValueError(
            f"Matplotlib has no colour map {colour_map}; examples are viridis, magma_r, RdBu_r, cividis and turbo"
        )
    if not 0 < fps <= 100:
        raise ValueError(f"{fps:g} states per second cannot be shown; give up to 100")
    if not all(100 <= n <= 4000 for n in size):
        raise ValueError("give 100 to 4000 pixels for width and height")


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
        [image(k) for k in (0, len(pictures) // 2, len(pictures) - 1)], pictures.style.get("colour_map")
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


def main(
    result,
    out=None,
    by="material",
    stage=None,
    chains=False,
    map=None,
    low=None,
    high=None,
    fps=10,
    size=None,
    curve=None,
):
    """Implements `arenite animate`, whose options are declared by the program: prints the path; status 2 and a message
    on stderr for bad input."""
    folder = pathlib.Path(result) if os.path.isdir(result) else pathlib.Path(result).parent
    try:
        written = save(
            result,
            out or folder / "animation.mp4",
            by,
            stage=stage,
            chains=chains,
            colour_map=map,
            low=low,
            high=high,
            fps=fps,
            size=size or (1200 if curve else 800, 800),
            curve=curve and pair(curve),
            progress=progress_on(sys.stderr),
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
