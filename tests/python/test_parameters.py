"""A parameter that recipes, commands and Python share is described by one sentence: that of its declaration."""

import operator
import os
import pathlib
import re
import subprocess

import arenite
import arenite.animate
import arenite.figures
import h5py
import numpy as np
import pytest

root = pathlib.Path(__file__).parents[2]
program = os.environ["ARENITE"]


def keys_of(page):
    """Sentence of every key of a generated page, by its section: {"map.dx": "Side of a pixel; ..."}."""
    sentences, section = {}, ""
    for line in (root / "docs" / page).read_text(encoding="utf-8").splitlines():
        if heading := re.match(r"## (?:`\[+([\w.]+?)(?:\.NAME)?\]+`)?", line):
            section = heading[1] or ""
        elif row := re.match(r"\| `(\w+)` \| .* \| .* \| (.*) \|$", line):
            key = f"{section}.{row[1]}".lstrip(".")
            sentences[key] = re.split(r"\.?<br>| With `| Allowed: | See below", row[2])[0].replace("\\|", "|")
    return {key: text.rstrip(".") for key, text in sentences.items()}


recipe, film_recipe = keys_of("recipe.md"), keys_of("film-recipe.md")


def same_names(section, *names):
    return {"--" + name: f"{section}.{name.replace('-', '_')}" for name in names}


def same_keywords(*names):
    return {"--" + name: name.replace("-", "_") for name in names}


def help_of(command):
    """The sentence of every option, as the program's help has it."""
    text = subprocess.run([program, command, "--help"], capture_output=True, text=True, check=True).stdout
    text = re.sub(r"\n {10,}", "   ", text)
    return {row[1]: row[0] for row in re.finditer(r"^  (--[\w-]+)\b.*$", text, re.MULTILINE)}


of_film = same_names("film", "frame-rate", "scale", "offset", "dataset")
statistics = ("clamp-rows", "leave-out-surface", "leave-out-unloaded", "mean-over-area")
options = {
    "load": (
        recipe,
        {
            option: key
            for option in help_of("load")
            for section in ("map", "loads", "loads.statistics")
            if (key := f"{section}.{option[2:].replace('-', '_')}") in recipe
        },
    ),
    "run": (recipe, same_names("integration", "kernel")),
    "measure": (
        recipe,
        same_names("measure", "border", "load-axis", "seed") | same_names("loads.statistics", *statistics),
    ),
    "grains": (film_recipe, same_names("picture", "pixel", "contrast", "least-score") | {"--dataset": "film.dataset"}),
    "film": (film_recipe, of_film),
    "show": (film_recipe, of_film),
    "step": (film_recipe, of_film),
    "lockin": (
        film_recipe,
        of_film
        | same_names("lockin", "frequency", "drift", "harmonics", "diffusivity")
        | {"--reference-phase": "lockin.phase", "--pixel": "picture.pixel", "--nearest-bin": "lockin.method"},
    ),
}

parts = ("matrix", "interface", "particle")
film_keys = {name: f"film.{name}" for name in ("frame_rate", "scale", "offset", "dataset")}
keywords = {
    "load": (
        recipe,
        {name: f"loads.{name}" for name in "loading strain axis lower method tolerance moduli failure".split()}
        | {name: f"loads.{name}" for name in "stop_at_voids exact_stretch cracks_stay_open max_strain".split()}
        | {name: f"loads.stiffness.{name}" for name in parts}
        | {"toughness": "loads.toughness.matrix", "strength": "loads.strength.matrix"},
    ),
    "read_phase_map": (
        recipe,
        {name: f"map.{name}" for name in "file dx labels phases crop smoothing slice dataset".split()}
        | {name: f"map.{name}" for name in ("label_slice", "label_dataset")},
    ),
    "cement": (
        recipe,
        {name: f"cement.{name}" for name in "kind gap width full_width thickness volume saturation".split()}
        | {"crop": "grid.crop"},
    ),
    "rasterise": (recipe, {name: f"grid.{name}" for name in ("nodes", "crop")}),
    "cavities": (recipe, {name: f"grid.{name}" for name in ("eight_connected", "fewest_nodes", "leave_out_border")}),
    "measure": (recipe, {name: f"measure.{name}" for name in ("border", "load_axis", "seed")}),
    "measure_grains": (recipe, {"border": "measure.border"}),
    "lock_in": (
        film_recipe,
        {"frequency": "lockin.frequency", "drift_order": "lockin.drift", "harmonics": "lockin.harmonics"}
        | {"reference_phase": "lockin.phase", "nearest_bin": "lockin.method"}
        | film_keys,
    ),
    "step_load": (film_recipe, film_keys),
    "film_info": (film_recipe, film_keys),
    "read_film": (film_recipe, film_keys),
    "find_bad_pixels": (film_recipe, film_keys),
    "correct_film": (film_recipe, film_keys | {"bad_pixels": "correction.bad_pixels"}),
    "grain_motion": (film_recipe, film_keys),
    "follow_grains": (film_recipe, film_keys | {"blur": "forces.blur"}),
    "grain_means": (film_recipe, {"share": "forces.central_share"}),
    "infer_forces": (film_recipe, {"pixel": "picture.pixel", "blur": "forces.blur"}),
    "find_grains": (film_recipe, {name: f"picture.{name}" for name in ("contrast", "least_score")}),
}


def manual_of(command):
    """The same of the manual page, of which one section is this command's."""
    page = subprocess.run([program, "man"], capture_output=True, text=True, check=True).stdout
    section = page.split(f".SS arenite {command} ")[1].split(".SS ")[0]
    return section.replace("\\-", "-").replace("\\e", "\\")


def test_options_of_a_load_are_keys_of_a_recipe_but_those_of_the_command():
    assert set(help_of("load")) - set(options["load"][1]) == {"--json", "--out", "--quiet", "--threads"}


@pytest.mark.parametrize("command", options)
def test_help_and_manual_say_of_an_option_what_the_recipe_says_of_its_key(command):
    keys, shared = options[command]
    shown, manual = help_of(command), manual_of(command)
    for option, key in shared.items():
        assert keys[key] in shown[option], f"{command} {option}: {keys[key]}"
        assert keys[key] in manual, f"{command} {option}: {keys[key]}"


@pytest.mark.parametrize("function", keywords)
def test_docstrings_say_of_a_keyword_what_the_recipe_says_of_its_key(function):
    keys, shared = keywords[function]
    lines = dict(re.findall(r"^`(\w+)`: (.*)$", getattr(arenite, function).__doc__, re.MULTILINE))
    for name, key in shared.items():
        assert keys[key] in lines[name], f"{function} {name}: {keys[key]}"


# Parameters that no recipe has: options and the keywords that are the same.
without_recipe = {
    "step": (["step_load"], same_keywords("time", "rise", "window") | {"--drift": "drift_order"}),
    "grains": (["find_grains"], same_keywords("smallest", "largest", "radii")),
    "measure": (
        ["read_packing"],
        same_keywords(
            "box", "origin", "thickness", "length-unit", "force-unit", "pixel", "materials", "format", "y-down"
        )
        | same_keywords("grain-columns", "periodic")
        | {"--columns": "contact_columns", "--doubled": "merge_doubled"},
    ),
    "identify": (
        ["identify_stiffness", "identify_adhesion", "identify_factor"],
        same_keywords("preload", "branch", "length", "effective-radius", "section", "young", "poisson", "band")
        | same_keywords("temperature-convention", "load-convention", "through-origin", "responsivity", "surface-at")
        | same_keywords("responsivity-at", "amplification", "emissivity")
        | {"--k": "stiffness", "--radius": "radii"},
    ),
}


without_recipe["study"] = (["run_study"], same_keywords("jobs"))
without_recipe["verify"] = (["run_study"], same_keywords("jobs"))
without_recipe["camera"] = (["camera"], same_keywords("format"))
without_recipe["figures"] = (["figures.save_all"], same_keywords("width") | {"--format": "formats", "--only": "names"})
without_recipe["animate"] = (
    ["animate.save"],
    same_keywords("by", "chains", "stage", "low", "high", "fps", "size", "curve") | {"--map": "colour_map"},
)


@pytest.mark.parametrize("command", without_recipe)
def test_parameters_of_no_recipe_are_described_alike_in_help_manual_and_docstring(command):
    functions, shared = without_recipe[command]
    lines = {}
    for function in functions:
        lines |= dict(re.findall(r"^`(\w+)`: (.*?)\.(?: A number is in .*)?$", docstring_of(function), re.MULTILINE))
    shown, manual = help_of(command), manual_of(command)
    for option, name in shared.items():
        assert lines[name] in shown[option], f"{command} {option}: {lines[name]}"
        assert lines[name] in manual, f"{command} {option}: {lines[name]}"


def docstring_of(function):
    return operator.attrgetter(function)(arenite).__doc__


def default_in(text):
    return found[1] if (found := re.search(r"\(default ([^;)]*)", text)) else None


def test_defaults_of_options_and_keywords_are_those_of_the_recipe():
    shown = help_of("load")
    lines = dict(re.findall(r"^`(\w+)`: (.*)$", arenite.load.__doc__, re.MULTILINE))
    page = (root / "docs/recipe.md").read_text(encoding="utf-8")
    for name in ("strain", "tolerance", "max_strain", "loading", "method"):
        row = re.search(
            rf"^\| `{name}` \| [^|]* \| `\"?([^`\"]*)\"?` \|", page.split("## `[[loads]]`")[1], re.MULTILINE
        )
        assert default_in(shown["--" + name.replace("_", "-")]) == default_in(lines[name]) == row[1], name


def test_a_keyword_without_effect_is_a_warning():
    map = arenite.PhaseMap([[1] * 16] * 16, dx="1 mm")
    with pytest.warns(UserWarning, match="max_strain: only has an effect with failure = true"):
        arenite.load(map, max_strain=0.01)
    with pytest.raises(TypeError, match="unexpected keyword argument 'speed'"):
        arenite.load(map, speed=1)


def test_what_files_do_not_say_is_a_warning(tmp_path):
    picture, volume = tmp_path / "disks.h5", tmp_path / "balls.npy"
    with h5py.File(picture, "w") as file:
        file["map"] = np.array(4 * [[0, 255, 255, 0, 0, 0, 255, 255, 0]], np.uint8)
    with pytest.warns(arenite.FileWarning, match="the lower was taken as void"):
        arenite.read_phase_map(picture, dx="1 mm")
    np.save(volume, np.ones((4, 5, 6), np.uint8))
    with pytest.warns(arenite.FileWarning) as told:
        arenite.read_voxel_map(volume, phases={1: "matrix"}, voxels=64)
    said = [str(each.message) for each in told]
    assert any("voxels: only has an effect with a table of spheres" in one for one in said), said
    assert any("lengths are in voxels, since dx was not given" in one for one in said), said


def test_doubts_about_a_load_and_a_recipe_are_warnings(tmp_path):
    map = arenite.PhaseMap([[1] * 16] * 16, dx="1 mm")
    with pytest.warns(UserWarning, match="exact_stretch: has no effect, because elements have no bonds"):
        arenite.load(map, method="elements", exact_stretch=True)
    volume = tmp_path / "matrix.npy"
    np.save(volume, np.ones((6, 6, 6), np.uint8))
    (tmp_path / "recipe.toml").write_text(
        '[map]\nfile = "matrix.npy"\nphases = "1=matrix"\nvoxels = 32\n'
        '[[loads]]\nname = "pulled"\nmethod = "elements"\nexact_stretch = true\n'
    )
    with pytest.warns(UserWarning) as told:
        arenite.run(arenite.Recipe(tmp_path / "recipe.toml"), tmp_path / "out")
    said = [str(each.message) for each in told]
    for sentence in ("map.voxels: only has an effect with a table of spheres", "exact_stretch: has no effect"):
        assert any(sentence in one for one in said), said
