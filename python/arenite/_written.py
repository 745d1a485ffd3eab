"""Files that are there whole or not at all."""

import contextlib
import os
import pathlib
import tempfile


@contextlib.contextmanager
def written_whole(path):
    """Gives the path of a new file beside `path` and with its ending, which takes the place of `path` when it has been
    written, and is removed where that fails."""
    path = pathlib.Path(path)
    number, beside = tempfile.mkstemp(suffix=path.suffix, prefix=f".{path.stem}.", dir=path.parent)
    os.close(number)
    try:
        yield pathlib.Path(beside)
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(beside, 0o666 & ~mask)
        os.replace(beside, path)
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(beside)
        raise
