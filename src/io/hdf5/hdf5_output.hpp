#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "hdf5_memory_file.hpp"
#include "ljmd/io/files/open_directory.hpp"
#include "ljmd/io/hdf5/hdf5_handle.hpp"

namespace ljmd {

/// An HDF5 file being written, in the few verbs that a trajectory needs. Objects are named by their paths in the file.
/// Every failed call becomes a FileError with the name of the file and what was being done; after it nothing is written
/// any more, and the file on disk stays as it was.
///
/// First all objects are created, in memory. Then start_appending() makes the file of them and switches to
/// single-writer-multiple-reader mode, in which HDF5 orders its writes so that the file is sound after each of them,
/// and entries are appended.
///
/// Where an entry lies in the file depends only on the objects, the number of entries and the version of HDF5: every
/// chunk and every record about chunks is put behind all that is there, and none is given up. So a file that was left
/// in any state is continued in place (continue_appending): all of HDF5's records are written again as they were after
/// so many entries, by the calls that wrote them first, and the entries themselves stay where they are.
class Hdf5Output {
  public:
    /// A dataset that grows by one entry along its first axis at each append.
    struct Series {
        std::string name;
        std::vector<hsize_t> entry;  ///< shape of one entry; empty: a number
        hid_t type;                  ///< H5T_NATIVE_DOUBLE or H5T_NATIVE_INT64, in memory
        hsize_t length = 0;
        hid_t dataset = -1;  ///< owned by the output
    };

    /// @param place  of the file that is to be; nothing is written to it yet
    explicit Hdf5Output(OutputPlace place);
    Hdf5Output(const Hdf5Output&) = delete;
    Hdf5Output& operator=(const Hdf5Output&) = delete;

    /// Closes, but cannot report an error: call close() first.
    ~Hdf5Output();

    /// The parent must exist.
    void create_group(const std::string& name);

    void set_attribute(const std::string& object, const std::string& name, const std::vector<int>& values);
    void set_attribute(const std::string& object, const std::string& name, int value);
    void set_fixed_text(const std::string& object, const std::string& name, const std::string& text);
    void set_fixed_texts(const std::string& object, const std::string& name, const std::vector<std::string>& texts);
    void set_variable_text(const std::string& object, const std::string& name, const std::string& text);

    /// Datasets that do not change with time: one axis.
    void write_numbers(const std::string& name, const std::vector<double>& values);
    void write_numbers(const std::string& name, const std::vector<std::int64_t>& values);
    void write_texts(const std::string& name, const std::vector<std::string>& texts);

    /// Create the dataset of a series, without entries.
    /// @param chunk  shape of a storage chunk: entries, then the axes of an entry
    void create_series(const Series& series, const std::vector<hsize_t>& chunk);

    /// A second name for the same object.
    void link(const std::string& existing, const std::string& name);

    /// What decides where entries will lie: a hash of all objects so far and of the version of HDF5. No object can be
    /// created after it.
    [[nodiscard]] std::uint64_t layout();

    /// Create the file, replacing one of that name. From here on only append() and commit().
    void start_appending();

    /// Continue a file with the same layout() from as many entries of each series, whatever else was done to it after
    /// these were committed. From here on only append() and commit().
    /// @param series  all, in the order in which each entry of them was appended
    /// @param stride  entries that are appended without a new chunk after the first: divides each chunk's entries
    /// @pre the file is at least as long as it was when these entries were committed
    void continue_appending(const std::vector<Series*>& series, hsize_t entries, hsize_t stride);

    /// Append one entry and hand it to the operating system.
    /// @param data  as many numbers of series.type as an entry has
    void append(Series& series, const void* data);

    /// Where the last entry begins in the file. Not for each entry: HDF5 looks through all chunks. @pre there is one
    [[nodiscard]] std::uint64_t place_of_last(Series& series);

    /// Wait until everything appended is on the disk. @return bytes in the file
    std::int64_t commit();

    [[nodiscard]] std::filesystem::path path() const { return place_.path(); }

    /// Flush, close and fsync. A second call does nothing. A file that nothing was to be appended to is created first.
    void close();

  private:
    template <class Result>
    Result checked(Result result, const std::string& doing);
    [[noreturn]] void fail(const std::string& doing, const std::string& cause);
    [[nodiscard]] Hdf5Handle fixed_text_type(const std::vector<std::string>& texts);
    /// Properties for creating an object that does not remember when: the same frames give the same file.
    [[nodiscard]] Hdf5Handle without_times(hid_t kind);
    [[nodiscard]] Hdf5Handle axis(std::size_t length);
    void write_attribute(const std::string& object, const std::string& name, hid_t type, hid_t space, const void* data);
    void write_dataset(const std::string& name, hid_t file_type, hid_t memory_type, std::size_t length,
                       const void* data);

    [[nodiscard]] Hdf5Handle access_properties();
    void finish_objects();
    /// @throws InUseError  its directory is another one by now
    void open_file(const OutputPlace& place);
    void open_series(Series& series);
    void extend(Series& series, hsize_t entries);
    void switch_to_appending();

    [[nodiscard]] int descriptor();

    OutputPlace place_;
    Hdf5MemoryFile memory_;
    std::string objects_;  // the file without entries, once all objects are created
    bool is_on_disk_ = false;
    Hdf5Handle file_;                   // in memory first, then on the disk
    std::vector<Hdf5Handle> datasets_;  // of the series; closed before the file
};

}  // namespace ljmd
