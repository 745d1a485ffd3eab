# Film formats and what reads them, each a fuzz target and a replayed corpus.
set(ARENITE_FILM_READERS ptw:ptw_format.open sfmov:sfmov_format.open hcc:hcc_format.open npy:npy_format.open tiff:tiff_format.open
  hdf5:hdf5_format.open raw:raw_format.open text:text_format.open)
