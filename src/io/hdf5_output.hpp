#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "ljmd/io/hdf5_handle.hpp"
#include "ljmd/io/replacement_file.hpp"

namespace ljmd {

/// An HDF5 file being written, in the few verbs that a trajectory needs. Objects are named by their paths in the file.
/// Every failed call becomes a FileError with the name of the file and what was being done; after it nothing is written
/// any more, and the file on disk stays as it was.
///
/// First all objects are created. Then start_appending() switches to single-writer-multiple-reader mode, in which HDF5
/// orders its writes so that the file is sound after each of them, and frames are appended.
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

    /// Create the file, under a name of its own until take_place(). @throws FileError, InUseError
    explicit Hdf5Output(const OutputPlace& place);
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

    /// From here on only append() and commit().
    void start_appending();

    /// Append one entry and hand it to the operating system.
    /// @param data  as many numbers of series.type as an entry has
    void append(Series& series, const void* data);

    /// Where the chunks of the last entry lie in the file, along its second axis. @pre one entry a chunk
    [[nodiscard]] std::vector<std::uint64_t> places_of_last(const Series& series);

    /// Wait until everything appended is on the disk.
    void commit();

    /// From now on the file lies in its place, where it replaces another one. @pre it was committed
    void take_place() { replacement_.take_place(); }

    [[nodiscard]] std::filesystem::path path() const { return replacement_.place().path(); }

    /// Flush, close and fsync. A second call does nothing.
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

    [[nodiscard]] int descriptor();

    ReplacementFile replacement_;
    Hdf5Handle file_;
    std::vector<Hdf5Handle> datasets_;  // of the series; closed before the file
};

}  // namespace ljmd
