# Film formats and the functions that read them, each a fuzz target and a replayed corpus.
set(ARENITE_FILM_READERS ptw:open_ptw sfmov:open_sfmov hcc:open_hcc npy:open_npy tiff:open_tiff_film hdf5:open_hdf5_film
  raw:open_sidecar text:open_text_film)
