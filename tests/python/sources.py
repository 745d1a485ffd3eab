"""The sources of the library, for the tests that read them."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = ROOT / "src"


def files():
    return sorted(p for p in SOURCES.rglob("*") if p.suffix in (".cpp", ".hpp", ".inc"))


def code_of(file):
    """A source without comments and includes."""
    return re.sub(r"//.*|^#include.*", "", file.read_text(), flags=re.M)
