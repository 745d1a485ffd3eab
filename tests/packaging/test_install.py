"""What `make install` and the Debian package put on a machine: a program that runs, and pages whose links lead
somewhere."""
import re

import pytest
from conftest import run


@pytest.fixture(scope="module")
def installed(build, tmp_path_factory):
    folder = tmp_path_factory.mktemp("installed")
    run("cmake", "--install", build, "--component", "Unspecified", "--prefix", folder)
    return folder


def test_the_program_runs_an_example_there(installed, tmp_path):
    said = run(
        installed / "bin/arenite",
        "check",
        installed / "share/arenite/examples/01-thesis-sample-08/recipe.toml",
        cwd=tmp_path,
    )
    assert "grains" in said


def test_links_of_pages_lead_to_files(installed):
    pages = installed / "share/doc/arenite"
    dead = [
        f"{page.relative_to(pages)}: {target}"
        for page in sorted([*pages.glob("*.md"), *pages.glob("docs/**/*.md")])
        for target in re.findall(
            r"\]\((?!\w+:|#)([^)#]+)", re.sub(r"^```.*?^```", "", page.read_text(), flags=re.M | re.S)
        )
        if not (page.parent / target).exists()
    ]
    assert not dead, dead


def test_studies_lie_beside_the_examples(installed):
    assert (installed / "share/arenite/validation/studies/paper/recipe.toml").is_file()
