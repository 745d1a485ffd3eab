"""What a figure shows is one description: page and print begin with the same numbers, units and ends of colours."""

import arenite
import arenite.figures as figures
import numpy as np
import pytest
from arenite import _core
from arenite.figures import fields, samples
from empty_axes import axes
from test_pages import content_of


@pytest.fixture(scope="module")
def page(result, tmp_path_factory):
    path = tmp_path_factory.mktemp("page") / "page.html"
    arenite.page(result, str(path))
    return content_of(path)


@pytest.fixture(scope="module")
def state(result):
    return next(part for _, part in figures.figures_of(result))


def test_grains_are_set_against_each_other_alike(page, state):
    (shown,) = page["run"]["grain-scatter"]
    on_page, in_print = shown["scatter"], samples.scatter_of(state)
    assert (on_page["across"], on_page["up"], on_page["every"]) == ("size", "stress", 1)
    assert [axis["quantity"] for axis in on_page["axes"]] == [axis["quantity"] for axis in in_print["axes"]]
    for one, other in zip(on_page["axes"], in_print["axes"]):
        assert one == {**other, "factor": pytest.approx(other["factor"])}
    drawn = axes()
    samples.grain_scatter(drawn.figure, state)
    (drawn,) = [a for a in drawn.figure.axes if a.get_xlabel()]
    assert drawn.get_xlabel() == "$d$, mm" or drawn.get_xlabel() == "d, mm"
    heights = np.concatenate([line.get_ydata() for line in drawn.lines])
    assert np.sort(heights) == pytest.approx(np.sort(page["snapshots"][-1]["sigma_norm"]), rel=1e-5)


def test_units_of_grains_suit_all_but_a_hundredth_of_them(state):
    axis = {axis["quantity"]: axis for axis in samples.scatter_of(state)["axes"]}["pressure"]
    most = np.sort(np.abs(arenite.grain_values(state.packing, "pressure")))
    assert axis["factor"] <= 1.001 * most[int(0.99 * len(most))] < 1001 * axis["factor"]


def test_other_grains_numbers_are_chosen_by_name(state):
    shot = samples.Shot(state.stage, state.snapshot)
    drawn = axes()
    figures.draw_grains_against(drawn, shot, "coordination", "displacement")
    assert np.concatenate([line.get_xdata() for line in drawn.lines]).max() == max(
        arenite.grain_values(state.packing, "coordination")
    )
    with pytest.raises(ValueError, match="have no colour; there are x, y,"):
        figures.draw_grains_against(axes(), shot, "colour")


def test_the_stress_of_a_packing_over_its_mean_is_what_it_is_measured_to_be(state):
    packing = state.packing
    assert arenite.grain_values(packing, "stress") == pytest.approx(_core.measure_grains(packing)["sigma_norm"])
    with pytest.raises(ValueError, match="mobilisation.*coefficient of friction"):
        arenite.grain_values(packing, "mobilisation")
    with pytest.raises(ValueError, match="displacement.*states before"):
        arenite.grain_values(packing, "displacement")


def test_coarse_fields_end_alike(page, state):
    ends = page["snapshots"][-1]["fields"]["ends"]
    found = samples.fields_of(state)
    assert set(found["ends"]) == set(ends)
    for name, (low, high) in ends.items():
        assert (low, high) == pytest.approx(found["ends"][name], rel=1e-5)
        picture, _ = figures.draw_coarse_field(axes(), found, name)
        at = np.array(picture.get_clim())
        assert at / at[1] == pytest.approx(np.array([low, high]) / high, rel=1e-5)
    assert ends["pressure"][0] == min(0, ends["pressure"][0]) and ends["solid_fraction"][0] > 0


def test_fields_leave_out_the_same_share_of_their_nodes(page, result):
    field, quantities = result.fields[-1], page["fields"][-1]["quantities"]
    for component, id in (("u", "displacement"), ("sigma_yy", "yy")):
        low, high = next(q for q in quantities.values() if q["name"] == component)["ends"]
        values = fields.values_of(field, component)[field.map.phase > 0]
        share = page["drawn"]["beyond"]["nodes"]
        assert np.mean(values < low) <= share and np.mean(values > high) <= share
        assert low <= np.quantile(values, share + 2 / len(values)) and high >= np.quantile(values, 1 - share)
    values, centre, _ = fields.scale_of(field, "u")
    clim = np.array(figures.draw_field(axes(), field, "u").get_clim())
    low, high = next(q for q in quantities.values() if q["name"] == "u")["ends"]
    assert clim / clim[1] == pytest.approx(np.array([low, high]) / high, rel=1e-5)


def test_units_are_prefixed_by_one_table(page):
    units = page["drawn"]["units"]
    for unit in units["prefixed"]:
        for factor, prefix in units["prefixes"]:
            found, written = _core._scale_of(factor, unit)
            assert found == factor and written.startswith(prefix)
    assert _core._scale_of(999.9, "N") == (1000, "kN") and _core._scale_of(5000, "DL") == (1, "DL")
