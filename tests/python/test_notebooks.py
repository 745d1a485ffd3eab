"""Notebooks run as they stand, in their folder, and leave nothing there; they are stored without outputs."""
import os
import pathlib

import nbclient
import nbformat
import pytest

folder = pathlib.Path(__file__).resolve().parents[2] / "examples" / "51-notebooks"
notebooks = sorted(folder.glob("*.ipynb"))


def test_there_is_one_for_each_part():
    assert {n.stem for n in notebooks} == {"composite", "cemented", "film"}


@pytest.mark.parametrize("path", notebooks, ids=[n.stem for n in notebooks])
def test_notebook_runs_as_it_stands(path, tmp_path, monkeypatch):
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    assert not [
        cell.id for cell in notebook.cells if cell.cell_type == "code" and (cell.outputs or cell.execution_count)
    ]
    for name, value in {
        "PYTHONPATH": os.environ["ARENITE_PYTHONPATH"],
        "TMPDIR": str(tmp_path),
        "IPYTHONDIR": str(tmp_path),
        "MPLBACKEND": "module://matplotlib_inline.backend_inline",
    }.items():
        monkeypatch.setenv(name, value)
    before = set(folder.iterdir())
    nbclient.NotebookClient(
        notebook, timeout=300, kernel_name="python3", resources={"metadata": {"path": str(folder)}}
    ).execute()
    shown = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
    assert [o for o in shown if o.output_type == "display_data" and "image/png" in o.data]
    assert set(folder.iterdir()) == before
    if path.stem == "film":  # what is measured is what was simulated
        said = notebook.cells[-1].outputs[-1].text
        assert float(said.split("correlation ")[1]) > 0.98
