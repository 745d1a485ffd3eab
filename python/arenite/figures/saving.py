"""A figure and how it is written to a file."""

import dataclasses
import io
import pathlib
import re
import typing

from matplotlib.figure import Figure as Canvas

from .._written import written_whole
from .style import column_width, journal_style, make_ticks_plain, page_width, unmarked


@dataclasses.dataclass
class Figure:
    """`draw(figure, part)` on an empty matplotlib figure, whose height it may set; `part` is a State, Field,
    VoxelResult or FilmResult, and `when(part)` says whether it can."""

    name: str
    kind: str
    draw: typing.Callable
    when: typing.Callable = lambda part: True
    height: typing.Any = 0.8  # over the width; a number or a function of the part
    wide: typing.Any = False  # two columns; a truth or a function of the part
    head: typing.Any = None  # what the library says of it: title and caption, which files hold
    of_map: bool = False  # shows nothing but the map, and so only the first of the fields that have the same


def save(figure, part, paths, width=None, **style):
    """Draws one figure and writes it to one or several files; their suffixes (pdf, svg, png) determine the format.
    `width`: inches; one or two columns if not given."""
    with journal_style(**style):
        wide = figure.wide(part) if callable(figure.wide) else figure.wide
        width = width or (page_width if wide else column_width)
        height = figure.height(part) if callable(figure.height) else figure.height
        canvas = Canvas(figsize=(width, width * height), layout="constrained")
        figure.draw(canvas, part)
        make_ticks_plain(canvas)
        # Laid out once and by one renderer: where things stand does not depend on the formats asked for.
        canvas.get_layout_engine().execute(canvas)
        # Not "none", which leaves an engine that does nothing and for which Matplotlib draws everything twice.
        canvas.set_layout_engine(None)
        for path in map(pathlib.Path, [paths] if isinstance(paths, (str, pathlib.Path)) else paths):
            # Without a date the same result gives the same bytes.
            metadata = metadata_of(path.suffix[1:], figure.head)
            # Whole in memory first: Matplotlib hides why a file cannot be written behind errors of its own.
            drawn = io.BytesIO()
            canvas.savefig(drawn, format=path.suffix[1:], metadata=metadata)
            content = drawn.getvalue()
            with written_whole(path) as beside:
                beside.write_bytes(number_clips(content) if path.suffix == ".svg" else content)


def metadata_of(form, head):
    """Title and caption, without a date."""
    undated = {"pdf": {"CreationDate": None}, "svg": {"Date": None}}.get(form, {})
    if not head:
        return undated
    name = {"pdf": "Subject"}.get(form, "Description")
    return {**undated, "Title": unmarked(head["title"]), name: unmarked(head["caption"])}


def number_clips(content):
    """Names the clipping paths of an SVG by their order: Matplotlib names those that are not rectangles by their memory
    address."""
    text = content.decode()
    names = {name: f"clip{k}" for k, name in enumerate(re.findall(r'<clipPath id="(\w+)"', text))}
    return re.sub(r'(<clipPath id="|url\(#)(\w+)', lambda m: m[1] + names.get(m[2], m[2]), text).encode()


def listed(words):
    """A list of words, or a single word as a list."""
    return [words] if isinstance(words, str) else list(words)
