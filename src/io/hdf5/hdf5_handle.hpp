#pragma once

#include <hdf5.h>

#include <cstddef>
#include <string>
#include <utility>

namespace ljmd {

/// Memory that must be available (require_memory) when a file is opened: HDF5 crashes when an allocation fails there
/// (seen with 1.10.8).
inline constexpr std::size_t hdf5_file_memory = std::size_t{4} << 20;

/// Owns one identifier of the HDF5 C API and closes it with the function that belongs to its kind.
///
/// HDF5 cannot close a file after a failed write: it crashes, at once or when it tries again at the exit of the program
/// (seen with 1.10.8 and a full disk). Abandon such handles. Hdf5Output lets HDF5 close what it abandons without the
/// disk; where memory cannot be written either (a limit on the size of files), leave_hdf5_files_at_exit() is what
/// helps.
class Hdf5Handle {
  public:
    using Closer = herr_t (*)(hid_t);

    Hdf5Handle() = default;

    /// @param id      result of an HDF5 call; a negative one (failure) is not owned
    /// @param closer  H5Fclose, H5Dclose, H5Sclose, ...
    Hdf5Handle(hid_t id, Closer closer) : id_(id), closer_(closer) {}

    Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), closer_(other.closer_) {}
    Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(closer_, other.closer_);
        return *this;
    }
    Hdf5Handle(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(const Hdf5Handle&) = delete;

    /// Closes; errors are lost, so close a written file with close().
    ~Hdf5Handle() { close(); }

    [[nodiscard]] hid_t get() const { return id_; }
    [[nodiscard]] explicit operator bool() const { return id_ >= 0; }

    /// Forget the identifier without closing it.
    void abandon() { id_ = -1; }

    /// Close now. @return negative when HDF5 reports an error; the handle is empty in either case
    herr_t close() {
        const hid_t id = std::exchange(id_, -1);
        return id >= 0 ? closer_(id) : 0;
    }

  private:
    hid_t id_ = -1;
    Closer closer_ = nullptr;
};

/// Suppresses HDF5's own error output during its lifetime; the previous setting is restored.
class Hdf5Silence {
  public:
    Hdf5Silence() {
        H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }
    ~Hdf5Silence() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
    Hdf5Silence(const Hdf5Silence&) = delete;
    Hdf5Silence& operator=(const Hdf5Silence&) = delete;

  private:
    H5E_auto2_t function_ = nullptr;
    void* data_ = nullptr;
};

/// Why the last HDF5 call failed: the message of the operating system if there is one ("No space left on device"), else
/// HDF5's innermost description. Call it right after the failed call.
[[nodiscard]] std::string hdf5_error_text();

}  // namespace ljmd
