"""The wheel: the Python module, and the program `arenite` beside it.

ARENITE_BUILD=FOLDER takes both from a build that is there (`make build` makes one in build/) instead of compiling them.
"""
import glob
import os
import re
import sys
import sysconfig

from skbuild import setup

here = os.path.dirname(os.path.abspath(__file__))


def version():
    with open(os.path.join(here, "CMakeLists.txt"), encoding="utf-8") as file:
        return re.search(r"project\(arenite VERSION ([\d.]+)", file.read())[1]


def source_of_build():
    """The CMake project that brings program and module, and what it is told."""
    build = os.environ.get("ARENITE_BUILD")
    if not build:
        return "", [f"-DARENITE_PYTHON_EXECUTABLE={sys.executable}", "-DARENITE_TESTS=OFF"]
    build = os.path.abspath(build)
    module = os.path.join(build, "python", "arenite", "_core" + sysconfig.get_config_var("EXT_SUFFIX"))
    for file in (os.path.join(build, "arenite"), module):
        if not os.path.exists(file):
            sys.exit(
                f"ARENITE_BUILD={build}: there is no {os.path.relpath(file, build)}; `make build` makes it for "
                "/usr/bin/python3"
            )
    return os.path.join("cmake", "wheel"), [f"-DARENITE_BUILD={build}", f"-DARENITE_MODULE={module}"]


source, arguments = source_of_build()
files = [
    os.path.relpath(f, os.path.join(here, "python", "arenite"))
    for kind in ("*.pyi", "py.typed")
    for f in glob.glob(os.path.join(here, "python", "arenite", kind))
]
setup(
    version=version(),
    packages=["arenite", "arenite.figures"],
    package_dir={"": "python"},
    package_data={"arenite": files},
    cmake_source_dir=source,
    cmake_args=["-DCMAKE_BUILD_TYPE=Release", *arguments],
    zip_safe=False,
)
