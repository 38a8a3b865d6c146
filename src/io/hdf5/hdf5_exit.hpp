#pragma once

namespace ljmd {

/// HDF5 does not touch files when the program ends: one that is not closed stays as it was last flushed. For programs
/// alone: a library would leave the files of its host unfinished. @pre HDF5 has not been used
void leave_hdf5_files_at_exit();

}  // namespace ljmd
