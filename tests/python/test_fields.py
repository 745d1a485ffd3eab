import arenite
import numpy as np
import pytest


def two_blocks():
    """A stiff block between two soft ones, all as wide as the sample."""
    phase = np.ones((64, 48), np.uint8)
    phase[20:44, :] = 2
    return arenite.PhaseMap(phase, dx="1 mm")


def test_a_map_is_loaded_and_its_reaction_is_the_mean_stress():
    field = arenite.load(two_blocks(), strain=1e-4)
    assert field.converged and field.sigma_yy.shape == (64, 48)
    rows = np.delete(field.sigma_yy.mean(axis=1), np.r_[0:8, 14:26, 38:50, 56:64])  # without clamps and seams
    assert np.ptp(rows) < 1e-3 * rows.mean()
    assert 1e9 * 1e-4 < rows.mean() < 4e9 * 1e-4


def test_elements_take_poissons_ratios_of_phases():
    soft = arenite.load(two_blocks(), method="elements", matrix_poisson=0.1)
    held = arenite.load(two_blocks(), method="elements", matrix_poisson=0.45, plane="strain")
    assert soft.converged and soft.sigma_yy.shape == (64, 48)
    assert np.ptp(soft.sigma_yy.mean(axis=1)) < 1e-4 * soft.sigma_yy.mean()  # equilibrium row by row, clamps too
    assert held.sigma_yy.mean() > 1.1 * soft.sigma_yy.mean()
    with pytest.raises(ValueError, match="matrix_poisson"):
        arenite.load(two_blocks(), method="elements", matrix_poisson=0.5)


def test_units_are_read_and_moduli_scale():
    soft = arenite.load(two_blocks(), matrix="1 GPa")
    stiff = arenite.load(two_blocks(), matrix=2e9)
    assert np.allclose(2 * soft.sigma_yy, stiff.sigma_yy, rtol=1e-4, atol=1.0)
    with pytest.raises(ValueError, match="loading.*\"twist\""):
        arenite.load(two_blocks(), "twist")


def test_cement_and_grid_follow_the_recipe(recipe, result):
    packing = result.stages[-1].packing
    sample = arenite.cement_sample(recipe, packing)
    assert np.array_equal(sample.map.phase, result.fields[0].map.phase)
    bridges = arenite.cement(packing, gap="0.075 mm", width=0.4)
    assert np.array_equal(arenite.rasterise(packing, bridges, nodes=128, crop="9 mm").phase, sample.map.phase)


def test_saturation_is_found(result):
    packing = result.stages[-1].packing
    cement = arenite.cement(packing, "coating", saturation=0.4)
    map = arenite.rasterise(packing, cement, nodes=512)
    assert np.sum(map.phase == 1) / np.sum(map.phase < 2) == pytest.approx(0.4, abs=0.02)
    assert cement.coating > 0


def test_saturation_holds_in_the_crop_as_in_the_recipe(recipe, result):
    packing = result.stages[-1].packing
    for crop in ("6 mm", "9 mm"):
        cement = arenite.cement(packing, "coating", saturation=0.4, crop=crop)
        map = arenite.rasterise(packing, cement, nodes=512, crop=crop)
        assert np.sum(map.phase == 1) / np.sum(map.phase < 2) == pytest.approx(0.4, abs=0.02)


def test_arrays_of_a_field_are_views(result):
    field = result.fields[-1]
    assert np.shares_memory(field.sigma_yy, field.sigma_yy) and not field.map.phase.flags.writeable
    assert field.sigma_yy.shape == field.map.grain.shape == (field.map.height, field.map.width)
    assert np.all(field.sigma_yy[field.map.phase == 0] == 0)


def test_pores_are_counted(result):
    map = result.fields[0].map
    pores = arenite.cavities(map, "pore", fewest_nodes=1, leave_out_border=False)
    assert pores.sum() == np.sum(map.phase < 2)


def test_statistics_say_what_the_field_says(result):
    field = result.fields[-1]
    inner = np.zeros_like(field.map.phase, bool)
    inner[4:-4] = True
    solid = inner & (field.map.phase > 0)
    large = solid & (field.map.grain >= 0) & (field.map.grain_class[np.maximum(field.map.grain, 0)] == 2)
    ratio = field.sigma_yy[large].mean() / field.sigma_yy[solid].mean()
    sets = (
        field.statistics()["components"]["sigma_yy"]["sets"]
        if "components" in field.statistics()
        else field.statistics()["sigma_yy"]["sets"]
    )
    assert sets["large"]["mean_over_sample_mean"]["value"] == pytest.approx(ratio, rel=1e-4)


def test_pictures_are_read_as_the_program_reads_them(examples):
    file = examples / "30-electrode" / "electrode.tiff"
    map = arenite.read_phase_map(
        file, dx="1 um", phases={0: "void", 85: "particle", 170: "matrix"}, slice=0, labels="watershed"
    )
    assert len(map.grain_class) == 79 and map.phase.shape == (256, 256)
    text = arenite.read_phase_map(
        file, dx="1 um", phases="0=void,85=particle,170=matrix", slice=0, crop=(0, 0, 100, 50)
    )
    assert np.array_equal(text.phase, map.phase[-50:, :100])
    one = arenite.read_phase_map(
        file, dx="1 um", phases={0: "void", 85: "particle", 170: "matrix"}, slice=0, labels="none"
    )
    assert len(one.grain_class) == 1 and np.array_equal(one.grain == 0, one.phase == 2)
    with pytest.raises(ValueError, match=r"choose one with slice 0 to 255"):
        arenite.read_phase_map(file, dx="1 um")
    with pytest.raises(ValueError, match='labels is "watersheds"'):
        arenite.read_phase_map(file, dx="1 um", slice=0, labels="watersheds")
    with pytest.raises(ValueError, match="dx"):
        arenite.read_phase_map(file, dx=0, slice=0)


def test_sentences_name_arguments_and_leave_names_of_files_as_they_are(examples, tmp_path):
    file = tmp_path / "a --dx b.tiff"
    file.write_bytes((examples / "30-electrode" / "electrode.tiff").read_bytes())
    with pytest.raises(ValueError, match=r"/a --dx b\.tiff: .*choose one with slice 0 to 255"):
        arenite.read_phase_map(file, dx="1 um")


def test_nodes_are_of_the_kinds_that_pages_and_figures_name():
    phase = [[0, 1, 2], [2, 2, 2]]
    map = arenite.PhaseMap(phase, [[-1, -1, 0], [1, 1, 1]], dx=1e-3)
    kinds = [kind["id"] for kind in arenite._core._drawn["kinds"]]
    assert np.array_equal(np.array(kinds)[arenite._core._kinds_of_nodes(map)], np.array(kinds)[phase])
    from arenite.figures import fields

    labels = [entry.get_label() for entry in fields.phase_key(map)]
    assert labels == ["grains 66.7 %", "matrix 16.7 %", "void 16.7 %"]


def test_curves_and_cracks_look_into_the_field():
    phase = np.ones((48, 32), np.uint8)
    phase[20:28, 8:24] = 0
    field = arenite.load(arenite.PhaseMap(phase, dx="0.1 mm"), failure=True)
    assert len(field.cracks["x"]) == field.curve["broken"][-1] > 0
    for columns, again in [(field.curve, field.curve), (field.cracks, field.cracks)]:
        assert all(
            np.shares_memory(columns[name], again[name]) and not columns[name].flags.writeable for name in columns
        )
    assert np.all(np.diff(field.cracks["strain"]) >= 0) and set(field.cracks["type"]) == {1}
    assert np.all((field.cracks["x"] >= 0) & (field.cracks["x"] <= 3.2e-3))


def test_curves_of_statistics_are_arrays(result):
    sets = result.fields[-1].statistics()["sigma_yy"]["sets"]
    assert isinstance(sets["all"]["pdf"]["x"], np.ndarray) and sets["all"]["pdf"]["x"].dtype == float
