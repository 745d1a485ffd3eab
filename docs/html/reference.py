"""Pages of the reference: of Python from the type stub and the docstrings, of C++ from the list of public headers."""
import ast
import itertools
import os
import re
import sys
from xml.etree import ElementTree


def heading(text, line="="):
    return f"{text}\n{line * len(text)}\n\n"


def plain(text):
    """Prose of a docstring as reStructuredText: only `code` means something."""
    parts = re.split(r"(`[^`]*`)", text)
    return "".join(part if k % 2 else re.sub(r"([\\*|_])", r"\\\1", part) for k, part in enumerate(parts))


def described(thing, indent):
    """The docstring without the signatures that pybind11 writes before it."""
    text = thing.__doc__ or ""
    several = "\nOverloaded function.\n" in text
    text = re.sub(r"\A\w*\(.*\)( -> .*)?\n+(Overloaded function\.\n+)?", "", text)
    text = (re.sub(r"^\d+\. \w+\(.*\n+", "", text, flags=re.M) if several else text).strip()
    return "\n" + "".join(f"{indent}{line}\n" for line in plain(text).splitlines()) + "\n" if text else "\n"


def names(node):
    return [decorator.id for decorator in node.decorator_list if isinstance(decorator, ast.Name)]


def signature(node):
    arguments = ast.unparse(node.args)
    arguments = re.sub(r"^self(, )?", "", arguments)
    return f"{node.name}({arguments})" + (f" -> {ast.unparse(node.returns)}" if node.returns else "")


def member(node, owner):
    thing = vars(owner).get(node.name)
    thing = thing.__func__ if isinstance(thing, staticmethod) else thing
    if "property" in names(node):
        return f"   .. py:property:: {node.name}\n      :type: {ast.unparse(node.returns)}\n" + described(
            thing, "      "
        )
    option = "      :staticmethod:\n" if "staticmethod" in names(node) else ""
    return f"   .. py:method:: {signature(node)}\n{option}" + described(thing, "      ")


def class_text(node, module):
    owner = getattr(module, node.name)
    members = [m for m in node.body if isinstance(m, ast.FunctionDef)]
    made = next((signature(m)[len("__init__") :].removesuffix(" -> None") for m in members if m.name == "__init__"), "")
    text = f".. py:class:: {node.name}{made}\n" + described(owner, "   ")
    if made:
        text += described(owner.__init__, "   ")
    return text + "".join(member(m, owner) for m in members if not m.name.startswith("_"))


def python_pages(root):
    sys.path.insert(0, os.environ["ARENITE_PYTHONPATH"])
    import arenite

    tree = ast.parse((root / "python/arenite/_core.pyi").read_text(encoding="utf-8"))
    functions = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
    classes = [node for node in tree.body if isinstance(node, ast.ClassDef)]
    text = heading("Python") + plain(arenite.__doc__) + "\n\n.. py:module:: arenite\n\n" + heading("Functions", "-")
    for name, forms in itertools.groupby(functions, lambda node: node.name):
        begin = ".. py:function:: "
        text += begin + ("\n" + " " * len(begin)).join(map(signature, forms)) + "\n"
        text += described(getattr(arenite, name), "   ")
    text += (
        ".. autofunction:: arenite.run_study\n\n"
        + heading("Classes", "-")
        + "".join(class_text(node, arenite) for node in classes)
    )
    figures = heading("Figures in Python") + ".. automodule:: arenite.figures\n   :members:\n   :imported-members:\n"
    text += "".join(
        f"\n{heading(title, '-')}.. automodule:: arenite.{name}\n   :members: {members}\n\n"
        for name, title, members in (
            ("curves", "Curves of a test", "along, of_states, of_cycles, rheology, Curve"),
            ("animate", "Films of a run", "save"),
            ("compare", "Two results", "rows, save_page, save_table, Row"),
        )
    )
    return {"python": text, "figures": figures}


def public_headers(root):
    return re.findall(r"^  (\S+\.hpp)\)?$", (root / "cmake/public_headers.cmake").read_text(encoding="utf-8"), re.M)


def directive(member, owner):
    """Of a function, enumeration, name or constant of a namespace."""
    name = f"{owner}::{member.findtext('name')}"
    kind = {"variable": "variable", "function": "function", "enum": "enum", "typedef": "typedef"}[member.get("kind")]
    if kind == "function":
        types = ["".join(param.find("type").itertext()).strip() for param in member.findall("param")]
        name += f"({', '.join(types)})" + (" const" if member.get("const") == "yes" else "")
    return f".. doxygen{kind}:: {name}\n\n"


def parts_of_headers(xml):
    """What Doxygen found, by header: structures first, then what is free in a namespace, in its order."""
    index = ElementTree.parse(xml / "index.xml").getroot()
    compounds = [
        ElementTree.parse(xml / (c.get("refid") + ".xml")).find("compounddef")
        for c in index
        if c.get("kind") in ("struct", "class", "namespace")
    ]
    known = {c.findtext("compoundname") for c in compounds if c.get("kind") != "namespace"}
    classes, members = {}, {}
    for compound in compounds:
        name = compound.findtext("compoundname")
        if compound.get("kind") != "namespace":
            if (
                compound.get("prot") == "public" and name.rpartition("::")[0] not in known
            ):  # what is within another is shown with it
                members_of = "   :members:\n\n"
                classes.setdefault(compound.find("location").get("file"), []).append(
                    f".. doxygen{compound.get('kind')}:: {name}\n{members_of}"
                )
            continue
        for member in compound.iter("memberdef"):
            at = member.find("location")
            members.setdefault(at.get("declfile") or at.get("file"), []).append(
                (int(at.get("declline") or at.get("line")), directive(member, name))
            )
    return {
        file: "".join(classes.get(file, [])) + "".join(text for _, text in sorted(members.get(file, [])))
        for file in {*classes, *members}
    }


def cpp_pages(root, xml):
    index = (
        heading("C++")
        + "What an installed library offers; ``<arenite/arenite.hpp>`` includes all of it.\n\n.. toctree::\n\n"
    )
    pages, parts = {}, parts_of_headers(xml)
    for header in public_headers(root):
        name = "cpp-" + header.removesuffix(".hpp").replace("/", "-")
        index += f"   {name}\n"
        pages[name] = (
            heading(header) + f".. code-block:: cpp\n\n   #include <arenite/{header}>\n\n" + parts[f"src/{header}"]
        )
    return {"cpp": index, **pages}
