import ast
import inspect
import pathlib

import arenite
import pytest

package = pathlib.Path(arenite.__file__).parent


def names_in_stub():
    tree = ast.parse((package / "_core.pyi").read_text())
    functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    classes = {node.name: {n.name for n in node.body if isinstance(n, ast.FunctionDef)} for node in tree.body if isinstance(node, ast.ClassDef)}
    return functions, classes


def test_stubs_name_everything():
    functions, classes = names_in_stub()
    core = vars(arenite._core)
    public = {n for n in core if not n.startswith("_")}
    assert {n for n in public if not inspect.isclass(core[n])} == functions
    assert {n for n in public if inspect.isclass(core[n])} == set(classes)
    for name, members in classes.items():
        assert {m for m in vars(core[name]) if not m.startswith("_")} == {m for m in members if not m.startswith("_")}, name


def test_everything_has_a_docstring():
    for name, thing in vars(arenite._core).items():
        if not name.startswith("_"):
            assert thing.__doc__, name


def test_notebooks_show_results(result):
    for part in [result, result.stages[-1], result.stages[-1].packing, *result.fields, result.fields[0].map]:
        text = part._repr_html_()
        assert "<table>" in text and "data:image/png;base64," in text


def test_results_open_again(result):
    again = arenite.open(result.path)
    assert [s.name for s in again.stages] == ["packing", "compact", "rest"] and len(again.fields) == 2
    assert again.numbers == result.numbers and again.title
    with pytest.raises(ValueError):
        arenite.open("/nowhere/at/all")


def test_identification_reads_the_thesis_tables(examples):
    tables = sorted((examples / "data").rglob("separation-force.csv"))
    if not tables:
        pytest.skip("the table is not among the examples")
    found = arenite.identify_adhesion(str(tables[0]), stiffness=27.35e6, radii=(6.2e-3, 6.2e-3))
    assert [round(g["surface_energy"]["value"] / 1e6, 3) for g in found["groups"]] == [0.268, 0.511, 0.745, 1.061]


def test_a_study_becomes_a_table(tmp_path):
    recipe = arenite.Recipe.template("cemented", {"bidisperse.box_area": 40, "bidisperse.size_ratio": 1.25, "raster.nodes": 64, "raster.crop": "6 mm"})
    file = tmp_path / "recipe.toml"
    file.write_text(recipe.toml() + "\n[sweep.grid]\n\"cement.width\" = [0.2, 0.8]\n")
    done = arenite.run_study(str(file), str(tmp_path / "out"))
    assert done == {"done": 2, "not_done": 0, "left": 0}
    table = arenite.study_table(str(file), str(tmp_path / "out"))
    assert [float(width) for width in table["cement.width"]] == [0.2, 0.8]
    saturation = next(v for k, v in table.items() if k.endswith("saturation") or k.endswith("S_m"))
    assert saturation[1] > saturation[0]
