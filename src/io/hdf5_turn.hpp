#pragma once

namespace arenite::io {

/// HDF5 may be built without locks of its own: one thread at a time speaks to it, the one that has its turn. Who has it
/// may take it again, also in a process that is forked meanwhile.
class Hdf5Turn {
 public:
  Hdf5Turn();
  ~Hdf5Turn();
  Hdf5Turn(const Hdf5Turn&) = delete;
  Hdf5Turn& operator=(const Hdf5Turn&) = delete;
};

}  // namespace arenite::io
