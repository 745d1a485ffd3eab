"""Sphinx: the pages of docs/ and the reference of Python and C++ (scripts/docs calls it on the staged pages)."""
import os
import pathlib
import re
import sys

here = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(here), os.environ["ARENITE_PYTHONPATH"]]

project = "Arenite"
author = "The Arenite developers"
version = release = re.search(r"project\(arenite VERSION ([\d.]+)", (here.parents[1] / "CMakeLists.txt").read_text())[1]
root_doc = "docs/index"

extensions = ["myst_parser", "sphinx.ext.autodoc", "breathe", "katex_math"]
myst_enable_extensions = ["dollarmath", "amsmath"]
myst_heading_anchors = 4
myst_dmath_double_inline = True

default_role = "literal"
autodoc_typehints = "none"
breathe_projects = {"arenite": os.environ["ARENITE_DOXYGEN_XML"]}
breathe_default_project = "arenite"
breathe_default_members = ("members", "undoc-members")

html_theme = "furo"
html_title = "Arenite"
html_copy_source = False
html_static_path = [str(here / "static")]
html_css_files = ["pages.css"]
html_theme_options = {"sidebar_hide_name": False}
# Worked examples are fragments, and recipes have units.
suppress_warnings = ["misc.highlighting_failure"]
