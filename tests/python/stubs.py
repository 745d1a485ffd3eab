"""The type stub of the compiled module, from the signatures in its docstrings: python3 tests/python/stubs.py >
python/arenite/_core.pyi"""

import inspect
import os
import re
import sys

head = '''"""What the compiled part of Arenite offers; meaning, units and sources are in the docstrings."""
import os
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union, overload

import numpy
from numpy.typing import ArrayLike, NDArray

__version__: str
'''

words = [
    (r"arenite\._core\.", ""),
    (r"numpy\.ndarray\[(numpy\.\w+)\]", r"NDArray[\1]"),
    (r"numpy\.ndarray\[bool\]", "NDArray[numpy.bool_]"),
    (r"\bUnion\[(\w+), os\.PathLike\]", r"Union[\1, str, os.PathLike]"),
    (r"(?<!str, )\bos\.PathLike", "Union[str, os.PathLike]"),
    (r"\bbefore: Packing = None", "before: Optional[Packing] = None"),
    (r"\bbefore: List\[Packing\]", "before: List[Optional[Packing]]"),
    (r"\bresult: object", "result: Union[str, os.PathLike, Result, Stage, Field, FilmResult, Packing, SpherePacking]"),
    (r"\bstage: object", "stage: Union[int, str]"),
    (r"\bdict\b", "Dict[str, Any]"),
    (r"\bobject\b", "Any"),
]
exact = {
    "Stage.snapshots": "List[Snapshot]",
    "Stage.frames": "List[Snapshot]",
    "FilmResult.origin": "Tuple[float, float]",
}


def typed(text):
    for pattern, word in words:
        text = re.sub(pattern, word, text)
    return text


def signatures(docstring):
    """Those of a function, one for each kind of arguments that it takes: numbered by pybind11, or where keywords are
    declared keys each at the head of its own docstring."""
    lines = docstring.splitlines()
    name = lines[0].split("(")[0]
    several = [found[1] for line in lines if (found := re.fullmatch(r"\d+\. (\w+\(.*)", line))]
    own = [line for line in lines[1:] if name and re.fullmatch(rf"{name}\(.*\) -> .*", line)]
    return several if lines[1:2] == ["Overloaded function."] else [lines[0], *own]


def parts(docstring):
    """Parameters and result of "name(self: ..., x: float = 1.0) -> int", or of "(arg0: ...) -> int"."""
    signature = docstring.splitlines()[0]
    inside, result = re.fullmatch(r"\w*\((.*)\)(?: -> (.*))?", signature).groups()
    inside = re.sub(r"^(self|arg0): [^,]*", "self", inside)
    return typed(inside), typed(result or "None")


def function(name, docstring, static=False):
    found = signatures(docstring)
    lines = []
    for parameters, result in map(parts, found):
        if name == "__eq__":
            parameters = "self, other: object"
        lines += ["@overload"] if len(found) > 1 else []
        lines += [*(["@staticmethod"] if static else []), f"def {name}({parameters}) -> {result}: ..."]
    return lines


def member(owner, name, thing):
    if isinstance(thing, property):
        result = exact.get(f"{owner}.{name}") or parts(thing.fget.__doc__)[1]
        return ["@property", f"def {name}(self) -> {result}: ..."]
    static = isinstance(thing, staticmethod)
    return function(name, (thing.__func__ if static else thing).__doc__, static)


def shown(name):
    return not name.startswith("_") or name in ("__init__", "__len__", "__eq__")


def described(module):
    """What a reader of the module may use: functions, and classes with their members."""
    public = {name: thing for name, thing in vars(module).items() if not name.startswith("_")}
    classes = {
        name: {n: t for n, t in vars(thing).items() if shown(n) and not (t.__doc__ or "").startswith("Initialize self")}
        for name, thing in public.items()
        if inspect.isclass(thing)
    }
    return {name: thing for name, thing in public.items() if name not in classes}, classes


def stub(module, pictured):
    functions, classes = described(module)
    text = head
    for name in sorted(classes):
        is_warning = issubclass(getattr(module, name), Warning)
        text += f"\nclass {name}(UserWarning): ...\n" if is_warning else f"\nclass {name}:\n"
        for lines in (member(name, n, t) for n, t in classes[name].items()):
            text += "".join(f"    {line}\n" for line in lines)
        if name in pictured:
            text += "    def _repr_html_(self) -> str: ...\n"
    return (
        text + "\n" + "".join("\n".join(function(name, functions[name].__doc__)) + "\n" for name in sorted(functions))
    )


if __name__ == "__main__":
    sys.path.insert(0, os.environ["ARENITE_PYTHONPATH"])
    import arenite

    print(stub(arenite._core, arenite._html.pictures), end="")
