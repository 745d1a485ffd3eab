"""Opens an exported loading in xarray and compares it with the stage file read by h5py."""
import sys

import h5py
import numpy as np
import xarray

stage_file, exported = sys.argv[1:3]
with h5py.File(stage_file) as file, xarray.open_dataset(exported) as loading:
    frames = list(file["frames"].values())
    sample = file["grains"]
    assert dict(loading.x.sizes) == {"time": len(frames), "grain": len(sample["id"])}, loading
    assert loading.x.dims == ("time", "grain") and loading.x.attrs["units"] == "m"
    assert loading.time.dtype == float and loading.time.attrs["units"] == "s"
    np.testing.assert_array_equal(loading.time, [f.attrs["time [s]"] for f in frames])
    np.testing.assert_array_equal(loading.grain, sample["id"])
    np.testing.assert_array_equal(loading.radius, sample["radius"])
    assert loading.stage.dims == ("time",) and [str(s) for s in loading.label.values] == [
        f.attrs["label"].decode() for f in frames
    ]
    for t, frame in enumerate(frames):
        now = loading.isel(time=t)
        for name in ("x", "y", "angle", "vx", "vy", "omega"):
            np.testing.assert_array_equal(now[name], frame["grains"][name])
        np.testing.assert_allclose(now.ux, frame["grains/x"][:] - frames[0]["grains/x"][:], atol=1e-15)
        np.testing.assert_array_equal(
            now.wall_force, [frame["domain"][side].attrs["force [N]"] for side in ("left", "right", "bottom", "top")]
        )
        assert now.unbalanced_ratio == frame["equilibrium"].attrs["unbalanced_ratio"]
        assert now.energy_elastic == frame["energies"].attrs["elastic [J]"]
        here = loading.isel(contact=np.flatnonzero(loading.contact_state.values == t))
        contacts = frame["contacts"]
        for name in ("fn", "ft", "nx", "ny", "overlap", "sliding_velocity", "glued"):
            np.testing.assert_array_equal(here["contact_" + name], contacts[name])
        i, j = contacts["i"][:], contacts["j"][:]
        np.testing.assert_array_equal(here.contact_i, sample["id"][:][i])
        np.testing.assert_array_equal(here.contact_j, np.where(j >= 0, sample["id"][:][np.maximum(j, 0)], j))
    assert loading.sigma_yy.dims == ("time", "grain") and np.isfinite(loading.sigma_yy).any()
    assert loading.attrs["input_hash"] == file["provenance"].attrs["input_hash"].decode()
    assert isinstance(loading.attrs["recipe"], str)
print("checked", len(frames), "states")
