#pragma once

#include <hdf5.h>

#include <memory>
#include <string>

namespace ljmd {

/// Makes an HDF5 file in memory and returns the bytes that a file on the disk would have after closing.
///
/// (H5Fget_file_image would return the bytes of an open file. HDF5 1.10 then marks them as closed but keeps the earlier
/// checksum, so that no reader accepts them.)
class Hdf5MemoryFile {
  public:
    Hdf5MemoryFile();

    /// Set a file access property list to create the file in memory.
    /// @param access  H5P_FILE_ACCESS  @return negative when HDF5 reports an error
    herr_t use_for(hid_t access);

    /// The name to create the file under. No file on the disk has it: HDF5 would read all of that first.
    [[nodiscard]] const std::string& name() const { return name_; }

    /// Flush the file and record its length. Closing it then yields its bytes.
    /// @return negative when HDF5 reports an error
    herr_t flush(hid_t file);

    /// @pre  the file was flushed, then closed
    [[nodiscard]] std::string take_bytes();

    /// Leave the file open. HDF5 closes it, and uses what this holds, when the program ends.
    void abandon() { static_cast<void>(image_.release()); }

  private:
    struct Image;
    struct Free {
        void operator()(Image* image) const;
    };
    std::string name_;
    std::unique_ptr<Image, Free> image_;  ///< at a fixed address, because HDF5 holds a pointer to it
};

}  // namespace ljmd
