#pragma once

#include <hdf5.h>

#include <memory>
#include <string>

namespace ljmd {

/// Catches the bytes of an HDF5 file that is made in memory: those that a file on the disk would have after closing.
///
/// (H5Fget_file_image would give the bytes of an open file. HDF5 1.10 then marks it as closed and leaves the checksum
/// of before, so that no reader accepts it.)
class Hdf5MemoryFile {
  public:
    Hdf5MemoryFile();

    /// Let a file be made in memory. @param access  H5P_FILE_ACCESS  @return negative when HDF5 reports an error
    herr_t use_for(hid_t access);

    /// To create the file under. No file on the disk has such a name: HDF5 would read all of it first.
    [[nodiscard]] const std::string& name() const { return name_; }

    /// Flush the file and note how long it is. Closing it then yields its bytes.
    /// @return negative when HDF5 reports an error
    herr_t flush(hid_t file);

    /// @pre  the file was flushed, then closed
    [[nodiscard]] std::string take_bytes();

  private:
    struct Image;
    struct Free {
        void operator()(Image* image) const;
    };
    std::string name_;
    std::unique_ptr<Image, Free> image_;  ///< at a fixed address: HDF5 knows it
};

}  // namespace ljmd
