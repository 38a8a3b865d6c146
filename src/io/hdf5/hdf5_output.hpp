#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/files/open_directory.hpp"
#include "io/hdf5/hdf5_handle.hpp"
#include "io/hdf5/hdf5_memory_file.hpp"

namespace ljmd {

/// An HDF5 file being written, with the operations that a trajectory needs. Objects are named by their paths in the
/// file. Every failed call becomes a FileError with the name of the file and the operation. After it nothing more is
/// written, and the file on the disk stays as it was.
///
/// First all objects are created in memory. Then start_appending() writes the file and switches to
/// single-writer-multiple-reader (SWMR) mode, and entries are appended. In this mode HDF5 orders its writes so that the
/// file is readable after each of them.
///
/// The place of an entry in the file depends only on the objects, the number of entries and the version of HDF5: every
/// chunk and every record of chunks is put at the end of the file, and none is freed. So a file can be continued in
/// place, whatever state it was left in (continue_appending): the calls that first wrote HDF5's records are repeated up
/// to the same number of entries, and the entries themselves stay where they are.
class Hdf5Output {
  public:
    /// A dataset that grows by one entry along its first axis at each append.
    struct Series {
        std::string name;
        std::vector<hsize_t> entry;  ///< shape of one entry; empty: a scalar
        hid_t type;                  ///< H5T_NATIVE_DOUBLE or H5T_NATIVE_INT64, in memory
        hsize_t length = 0;
        hid_t dataset = -1;  ///< owned by the output
    };

    /// @param place  of the future file; nothing is written to it yet
    explicit Hdf5Output(OutputPlace place);
    Hdf5Output(const Hdf5Output&) = delete;
    Hdf5Output& operator=(const Hdf5Output&) = delete;

    /// Closes, but cannot report an error: call close() first.
    ~Hdf5Output();

    /// @pre the parent group exists
    void create_group(const std::string& name);

    void set_attribute(const std::string& object, const std::string& name, const std::vector<int>& values);
    void set_attribute(const std::string& object, const std::string& name, int value);
    void set_fixed_text(const std::string& object, const std::string& name, const std::string& text);
    void set_fixed_texts(const std::string& object, const std::string& name, const std::vector<std::string>& texts);
    void set_variable_text(const std::string& object, const std::string& name, const std::string& text);

    /// Fixed datasets with one axis.
    void write_numbers(const std::string& name, const std::vector<double>& values);
    void write_numbers(const std::string& name, const std::vector<std::int64_t>& values);
    void write_texts(const std::string& name, const std::vector<std::string>& texts);

    /// Create the dataset of a series, without entries.
    /// @param chunk  shape of a storage chunk: number of entries, then the axes of an entry
    void create_series(const Series& series, const std::vector<hsize_t>& chunk);

    /// Create a hard link: a second name for the same object.
    void link(const std::string& existing, const std::string& name);

    /// Hash of everything that determines the places of entries: all objects and the version of HDF5. No objects can be
    /// created after this call.
    [[nodiscard]] std::uint64_t layout();

    /// Create the file, replacing one of that name. After this call only append() and commit() are allowed.
    void start_appending();

    /// Continue a file of the same layout() after this number of entries of each series, whatever happened to it after
    /// these were committed. After this call only append() and commit() are allowed.
    /// @param series  all series, in the order in which write calls append to them
    /// @param stride  entries that fit into one chunk of every series; divides the length of each chunk
    /// @pre the file is at least as long as when these entries were committed
    void continue_appending(const std::vector<Series*>& series, hsize_t entries, hsize_t stride);

    /// Append one entry and hand it to the operating system.
    /// @param data  one entry, numbers of series.type
    void append(Series& series, const void* data);

    /// The same for an entry that comes in parts of its first axis.
    /// @param fill  calls write(first, count, data) with numbers of series.type for count places from `first` on
    using WritePart = std::function<void(hsize_t first, hsize_t count, const void* data)>;
    void append_in_parts(Series& series, const std::function<void(const WritePart&)>& fill);

    /// Offset of the last entry in the file. Slow: HDF5 searches all chunks, so do not call it for each entry.
    /// @pre there is an entry
    [[nodiscard]] std::uint64_t place_of_last(Series& series);

    /// Synchronise everything appended. @return length of the file in bytes
    std::int64_t commit();

    [[nodiscard]] std::filesystem::path path() const { return place_.path(); }

    /// Flush, close and fsync. Does nothing when closed. A file whose appending was not started is created first.
    void close();

  private:
    template <class Result>
    Result checked(Result result, const std::string& doing) {
        if (result < 0) {
            fail(doing, hdf5_error_text());
        }
        return result;
    }
    [[noreturn]] void fail(const std::string& doing, const std::string& cause);
    /// Leave the file as it is on the disk: HDF5 neither writes to it nor shortens it any more.
    void abandon();
    [[nodiscard]] Hdf5Handle fixed_text_type(const std::vector<std::string>& texts);
    /// Creation properties without time stamps: the same frames give the same file.
    [[nodiscard]] Hdf5Handle without_times(hid_t kind);
    [[nodiscard]] Hdf5Handle axis(std::size_t length);
    void write_attribute(const std::string& object, const std::string& name, hid_t type, hid_t space, const void* data);
    void write_dataset(const std::string& name, hid_t file_type, hid_t memory_type, std::size_t length,
                       const void* data);

    [[nodiscard]] Hdf5Handle access_properties();
    void finish_objects();
    /// @throws InUseError  the path of its directory leads elsewhere by now
    void open_file(const OutputPlace& place);
    void open_series(Series& series);
    void extend(Series& series, hsize_t entries);
    /// Extend all series to the end of a chunk before the next step: chunks then get the same places as when entries
    /// came one by one. See continue_appending().
    void repeat_records(const std::vector<Series*>& series, hsize_t entries, hsize_t stride);
    void switch_to_appending();

    [[nodiscard]] int descriptor();

    OutputPlace place_;
    Hdf5MemoryFile memory_;
    std::string objects_;  // the file without entries, from when all objects are created until it is on the disk
    std::optional<std::uint64_t> layout_;
    bool is_on_disk_ = false;
    Hdf5Handle file_;                   // in memory first, then on the disk
    std::vector<Hdf5Handle> datasets_;  // of the series; closed before the file
};

}  // namespace ljmd
