"""What the pages and the container file tell a user to make can be made."""
import re

import pytest
from conftest import root


@pytest.mark.parametrize("name", ["Containerfile", "CONTRIBUTING.md", "README.md", "docs/install.md", "docs/python.md"])
def test_targets_are_there(name):
    targets = set(re.search(r"^\.PHONY: (.*)$", (root / "Makefile").read_text(), re.M)[1].split())
    told = set(re.findall(r"(?:^|`|RUN )make ([a-z]+)", (root / name).read_text(), re.M))
    assert told and told <= targets
