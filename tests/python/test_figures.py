import os
import subprocess
import sys

import arenite.figures as figures
import pytest


def test_every_figure_of_a_run_is_drawn_and_embeds_its_fonts(result, tmp_path):
    paths = figures.save_all(result, tmp_path, ("pdf", "svg"))
    names = {p.stem for p in paths}
    for name in ["rest-packing", "rest-force-network", "rest-contact-directions", "rest-sigma-norm", "rest-forces", "tension-stress", "tension-stress-pdf", "tension-convergence"]:
        assert name in names
    for path in paths:
        bytes = path.read_bytes()
        assert len(bytes) > 2000
        if path.suffix == ".pdf":
            assert bytes.startswith(b"%PDF") and (b"/FontFile2" in bytes or b"/Type /Font" not in bytes)


def test_the_same_result_gives_the_same_bytes(result, tmp_path):
    a, = figures.save_all(result, tmp_path / "a", ("pdf",), ["coordination"])
    b, = figures.save_all(result, tmp_path / "b", ("pdf",), ["coordination"])
    assert a.read_bytes() == b.read_bytes()


def test_widths_are_those_of_columns(result, tmp_path):
    (one,) = figures.save_all(result, tmp_path, ("svg",), ["coordination"])
    assert f'width="{72 * figures.column_width:g}pt"' in one.read_text()


def test_the_command_draws(result, tmp_path):
    run = subprocess.run([os.environ["ARENITE"], "figures", result.path, "--out", str(tmp_path), "--format", "png", "--only", "packing", "--width", "60 mm"], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert (tmp_path / "rest-packing.png").exists()


def test_bad_requests_are_refused_in_one_sentence(result, tmp_path):
    with pytest.raises(ValueError, match="no figure"):
        figures.save_all(result, tmp_path, names=["nothing"])
    run = subprocess.run([sys.executable, "-m", "arenite.figures", str(tmp_path)], capture_output=True, text=True, env={**os.environ, "PYTHONPATH": os.environ["ARENITE_PYTHONPATH"]})
    assert run.returncode == 2 and run.stderr.count("\n") == 1 and "Traceback" not in run.stderr
