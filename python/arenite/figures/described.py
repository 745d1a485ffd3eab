"""The figures that the library describes, as rows of the catalogue."""

from .drawing import describe, draw_described, heads
from .saving import Figure


def _first(choices, drawings):
    """Of choices of which print shows the first alone, that one."""
    for choice in choices:
        if choice["print"] == "first":
            there = [drawing["for"][choice["key"]] for drawing in drawings]
            value = next((value for value, *_ in choice["options"] if value in there), None)
            drawings = [drawing for drawing in drawings if drawing["for"][choice["key"]] == value]
    return drawings


def _of_file(choices, drawings, chosen):
    """The drawings that stand in one file: of a choice with files of its own those of this option."""
    return [
        drawing
        for drawing in _first(choices, drawings)
        if all(drawing["for"][key] == value for key, value in chosen.items())
    ]


def _figure(kind, head, chosen, ending):
    choices = head.get("choices", [])

    def drawings(part):
        return _of_file(choices, describe(part).get(head["id"], []), chosen)

    return Figure(
        head["name"] + (f"-{ending}" if ending else ""),
        kind,
        lambda figure, part: draw_described(figure, drawings(part)),
        lambda part: bool(drawings(part)),
        wide=lambda part: _is_wide(head, drawings(part)),
        of_map=head["id"] == "cavities",
        head=head,
    )


def _is_wide(head, drawings):
    if "roses" in drawings[0]:
        return len(drawings[0]["roses"]) > 2
    if "hemispheres" in drawings[0]:
        return len(drawings[0]["hemispheres"]["sets"]) > 2
    return sum(len(drawing["panels"]) for drawing in drawings) > 1


def described(kind, head):
    """[Figure] of a head: one, or one for each option of a choice that has files."""
    files = [choice for choice in head.get("choices", []) if choice["print"] == "files"]
    if not files:
        return [_figure(kind, head, {}, "")]
    return [_figure(kind, head, {files[0]["key"]: value}, ending) for value, _, ending in files[0]["options"]]


def all_described(kind, pictures):
    """[Figure] of all heads of a kind in the order of the page; `pictures`: {id: Figure} of those with renderers of
    their own."""
    found = []
    for head in heads()[kind]:
        if head["id"] in pictures:
            figure = pictures[head["id"]]
            figure.head = head
            found.append(figure)
        else:
            found += described(kind, head)
    return found
