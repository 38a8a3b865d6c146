#include "io/hdf5/hdf5_output.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "core/memory_at_hand.hpp"
#include "io/files/file_calls.hpp"
#include "io/files/output_file.hpp"
#include "io/files/replacement_file.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// Texts end to end, each padded with zeros to `length`.
std::string padded(const std::vector<std::string>& texts, std::size_t length) {
    std::string block(texts.size() * length, '\0');
    for (std::size_t i = 0; i < texts.size(); ++i) {
        texts[i].copy(block.data() + i * length, length);
    }
    return block;
}

/// While it lives, files may become as large as the system allows at most.
class LargestFiles {
  public:
    LargestFiles() {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit most{before_.rlim_max, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &most);
    }
    ~LargestFiles() { ::setrlimit(RLIMIT_FSIZE, &before_); }
    LargestFiles(const LargestFiles&) = delete;
    LargestFiles& operator=(const LargestFiles&) = delete;

    [[nodiscard]] bool are_unlimited() const { return before_.rlim_max == RLIM_INFINITY; }

  private:
    rlimit before_ = {};
};

/// From now on HDF5 writes into memory what it writes to the file, which stays as it is. @return whether that is so
bool write_into_memory(hid_t file) {
    void* descriptor = nullptr;
    if (H5Fget_vfd_handle(file, H5P_DEFAULT, &descriptor) < 0) {
        return false;
    }
    const int memory = ::memfd_create("ljmd", MFD_CLOEXEC);
    const bool done = memory >= 0 && ::dup2(memory, *static_cast<int*>(descriptor)) >= 0;
    if (memory >= 0) {
        ::close(memory);
    }
    return done;
}

}  // namespace

void Hdf5Output::abandon() {
    // HDF5 crashes on closing a file that it cannot write (seen with 1.10.8 and a full disk). Into memory it can. A
    // file that stays open is one more danger: HDF5 knows files by their inodes, and takes the next that gets the same
    // one, or the same file when it is opened again, for the one that it has.
    const LargestFiles largest;
    const bool can_close = is_on_disk_ && file_ && write_into_memory(file_.get()) && largest.are_unlimited();
    if (!is_on_disk_ && file_) {
        memory_.abandon();
    }
    for (Hdf5Handle& dataset : datasets_) {
        can_close ? static_cast<void>(dataset.close()) : dataset.abandon();
    }
    can_close ? static_cast<void>(file_.close()) : file_.abandon();
}

void Hdf5Output::fail(const std::string& doing, const std::string& cause) {
    abandon();
    throw FileError(fmt::format("cannot write '{}': {}: {}", path().string(), doing, cause));
}

Hdf5Output::Hdf5Output(OutputPlace place) : place_(std::move(place)) {
    const Hdf5Silence silence;
    const std::string doing = "creating its objects";
    const Hdf5Handle access = access_properties();
    checked(memory_.use_for(access.get()), doing);
    const Hdf5Handle creation = without_times(H5P_FILE_CREATE);
    require_memory(hdf5_file_memory);
    file_ = Hdf5Handle(checked(H5Fcreate(memory_.name().c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), doing),
                       H5Fclose);
}

Hdf5Output::~Hdf5Output() {
    if (!is_on_disk_) {
        return;
    }
    try {
        close();
    } catch (const FileError&) {  // a destructor cannot report it
    }
}

Hdf5Handle Hdf5Output::access_properties() {
    const std::string doing = "preparing to write";
    Hdf5Handle access(checked(H5Pcreate(H5P_FILE_ACCESS), doing), H5Pclose);
    // The format of HDF5 1.10: the first that can be appended to safely, and all later versions read it.
    checked(H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110), doing);
    // Not locked: the directory of a run is locked, and some file systems have no locks.
    checked(H5Pset_file_locking(access.get(), false, true), doing);
    // No space is reserved for later metadata: where it is left over would depend on when the file was flushed.
    checked(H5Pset_meta_block_size(access.get(), 0), doing);
    checked(H5Pset_small_data_block_size(access.get(), 0), doing);
    return access;
}

Hdf5Handle Hdf5Output::without_times(hid_t kind) {
    const std::string doing = "describing an object";
    Hdf5Handle properties(checked(H5Pcreate(kind), doing), H5Pclose);
    checked(H5Pset_obj_track_times(properties.get(), false), doing);
    return properties;
}

void Hdf5Output::create_group(const std::string& name) {
    const Hdf5Silence silence;
    const Hdf5Handle creation = without_times(H5P_GROUP_CREATE);
    const Hdf5Handle group(checked(H5Gcreate2(file_.get(), name.c_str(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
                                   "creating group " + name),
                           H5Gclose);
}

Hdf5Handle Hdf5Output::axis(std::size_t length) {
    const hsize_t extent = length;
    return {checked(H5Screate_simple(1, &extent, nullptr), "describing an array"), H5Sclose};
}

Hdf5Handle Hdf5Output::fixed_text_type(const std::vector<std::string>& texts) {
    std::size_t length = 0;
    for (const auto& text : texts) {
        length = std::max(length, text.size());
    }
    Hdf5Handle type(checked(H5Tcopy(H5T_C_S1), "describing a text"), H5Tclose);
    checked(H5Tset_size(type.get(), length + 1), "describing a text");  // readers in C expect a terminating zero
    checked(H5Tset_cset(type.get(), H5T_CSET_UTF8), "describing a text");
    return type;
}

void Hdf5Output::write_attribute(const std::string& object, const std::string& name, hid_t type, hid_t space,
                                 const void* data) {
    const std::string doing = fmt::format("writing attribute {} of {}", name, object);
    const Hdf5Handle attribute(checked(H5Acreate_by_name(file_.get(), object.c_str(), name.c_str(), type, space,
                                                         H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                                       doing),
                               H5Aclose);
    checked(H5Awrite(attribute.get(), type, data), doing);
}

void Hdf5Output::set_attribute(const std::string& object, const std::string& name, const std::vector<int>& values) {
    const Hdf5Silence silence;
    write_attribute(object, name, H5T_NATIVE_INT, axis(values.size()).get(), values.data());
}

void Hdf5Output::set_attribute(const std::string& object, const std::string& name, int value) {
    const Hdf5Silence silence;
    const Hdf5Handle scalar(checked(H5Screate(H5S_SCALAR), "describing a number"), H5Sclose);
    write_attribute(object, name, H5T_NATIVE_INT, scalar.get(), &value);
}

void Hdf5Output::set_fixed_text(const std::string& object, const std::string& name, const std::string& text) {
    const Hdf5Silence silence;
    const Hdf5Handle scalar(checked(H5Screate(H5S_SCALAR), "describing a text"), H5Sclose);
    write_attribute(object, name, fixed_text_type({text}).get(), scalar.get(), text.c_str());
}

void Hdf5Output::set_fixed_texts(const std::string& object, const std::string& name,
                                 const std::vector<std::string>& texts) {
    const Hdf5Silence silence;
    const Hdf5Handle type = fixed_text_type(texts);
    write_attribute(object, name, type.get(), axis(texts.size()).get(), padded(texts, H5Tget_size(type.get())).data());
}

void Hdf5Output::set_variable_text(const std::string& object, const std::string& name, const std::string& text) {
    const Hdf5Silence silence;
    const Hdf5Handle type(checked(H5Tcopy(H5T_C_S1), "describing a text"), H5Tclose);
    checked(H5Tset_size(type.get(), H5T_VARIABLE), "describing a text");
    checked(H5Tset_cset(type.get(), H5T_CSET_UTF8), "describing a text");
    const Hdf5Handle scalar(checked(H5Screate(H5S_SCALAR), "describing a text"), H5Sclose);
    const char* characters = text.c_str();
    write_attribute(object, name, type.get(), scalar.get(), &characters);
}

void Hdf5Output::write_dataset(const std::string& name, hid_t file_type, hid_t memory_type, std::size_t length,
                               const void* data) {
    const std::string doing = "writing " + name;
    const Hdf5Handle space = axis(length);
    const Hdf5Handle creation = without_times(H5P_DATASET_CREATE);
    Hdf5Handle dataset(
        checked(H5Dcreate2(file_.get(), name.c_str(), file_type, space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
                doing),
        H5Dclose);
    checked(H5Dwrite(dataset.get(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), doing);
    checked(dataset.close(), doing);  // a small array is written to the file only now
}

void Hdf5Output::write_numbers(const std::string& name, const std::vector<double>& values) {
    const Hdf5Silence silence;
    write_dataset(name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values.size(), values.data());
}

void Hdf5Output::write_numbers(const std::string& name, const std::vector<std::int64_t>& values) {
    const Hdf5Silence silence;
    write_dataset(name, H5T_STD_I64LE, H5T_NATIVE_INT64, values.size(), values.data());
}

void Hdf5Output::write_texts(const std::string& name, const std::vector<std::string>& texts) {
    const Hdf5Silence silence;
    const Hdf5Handle type = fixed_text_type(texts);
    write_dataset(name, type.get(), type.get(), texts.size(), padded(texts, H5Tget_size(type.get())).data());
}

void Hdf5Output::create_series(const Series& series, const std::vector<hsize_t>& chunk) {
    const Hdf5Silence silence;
    const std::string doing = "creating " + series.name;
    std::vector<hsize_t> extent{0};
    extent.insert(extent.end(), series.entry.begin(), series.entry.end());
    std::vector<hsize_t> limit = extent;
    limit[0] = H5S_UNLIMITED;
    const int rank = static_cast<int>(extent.size());
    const Hdf5Handle space(checked(H5Screate_simple(rank, extent.data(), limit.data()), doing), H5Sclose);
    const Hdf5Handle creation = without_times(H5P_DATASET_CREATE);
    checked(H5Pset_chunk(creation.get(), rank, chunk.data()), doing);
    // A chunk is allocated when its first entry is appended, and is not filled: entries are written one by one.
    checked(H5Pset_alloc_time(creation.get(), H5D_ALLOC_TIME_EARLY), doing);
    checked(H5Pset_fill_time(creation.get(), H5D_FILL_TIME_NEVER), doing);
    const hid_t file_type = series.type == H5T_NATIVE_DOUBLE ? H5T_IEEE_F64LE : H5T_STD_I64LE;
    const Hdf5Handle dataset(checked(H5Dcreate2(file_.get(), series.name.c_str(), file_type, space.get(), H5P_DEFAULT,
                                                creation.get(), H5P_DEFAULT),
                                     doing),
                             H5Dclose);
}

void Hdf5Output::link(const std::string& existing, const std::string& name) {
    const Hdf5Silence silence;
    checked(H5Lcreate_hard(file_.get(), existing.c_str(), H5L_SAME_LOC, name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
            "linking " + name);
}

void Hdf5Output::finish_objects() {
    if (layout_) {
        return;
    }
    const Hdf5Silence silence;
    const std::string doing = "creating its objects";
    checked(memory_.flush(file_.get()), doing);
    checked(file_.close(), doing);
    objects_ = memory_.take_bytes();
    std::array<unsigned, 3> version{};
    H5get_libversion(&version[0], &version[1], &version[2]);
    layout_ = XXH3_64bits_withSeed(objects_.data(), objects_.size(), XXH3_64bits(version.data(), sizeof version));
}

std::uint64_t Hdf5Output::layout() {
    finish_objects();
    return *layout_;
}

void Hdf5Output::open_file(const OutputPlace& place) {
    is_on_disk_ = true;
    const std::string doing = "opening the file";
    const Hdf5Handle access = access_properties();
    require_memory(hdf5_file_memory);
    place.directory.require_at_its_path();  // HDF5 takes only paths
    file_ = Hdf5Handle(checked(H5Fopen(place.path().c_str(), H5F_ACC_RDWR, access.get()), doing), H5Fclose);
    if (!place.holds(descriptor())) {
        fail(doing,
             "its directory was replaced meanwhile, or HDF5 still has open a file that it could not write before");
    }
}

void Hdf5Output::start_appending() {
    finish_objects();
    ReplacementFile replacement(place_);
    OutputFile file(replacement);
    file.write(objects_);
    file.close();
    objects_ = {};
    const Hdf5Silence silence;
    open_file(replacement.growing());
    switch_to_appending();
    replacement.take_place();
}

void Hdf5Output::continue_appending(const std::vector<Series*>& series, hsize_t entries, hsize_t stride) {
    finish_objects();
    overwrite_beginning(place_, objects_);
    objects_ = {};
    const Hdf5Silence silence;
    try {
        open_file(place_);
        repeat_records(series, entries, stride);
        switch_to_appending();
    } catch (...) {
        // If HDF5 closed the file now, it would cut it off behind the records that it has made so far.
        abandon();
        throw;
    }
}

void Hdf5Output::switch_to_appending() {
    checked(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), "flushing");
    checked(H5Fstart_swmr_write(file_.get()), "switching to appending");
    commit();
}

int Hdf5Output::descriptor() {
    void* descriptor = nullptr;
    checked(H5Fget_vfd_handle(file_.get(), H5P_DEFAULT, &descriptor), "asking for the descriptor");
    return *static_cast<int*>(descriptor);
}

std::int64_t Hdf5Output::commit() {
    const Hdf5Silence silence;
    if (const int error = sync_descriptor(descriptor()); error != 0) {
        fail("waiting for the disk", std::generic_category().message(error));
    }
    struct stat status {};
    if (::fstat(descriptor(), &status) != 0) {
        fail("asking for its length", std::generic_category().message(errno));
    }
    return status.st_size;
}

void Hdf5Output::close() {
    if (!is_on_disk_ && file_) {
        start_appending();
    }
    if (!file_) {
        return;
    }
    const Hdf5Silence silence;
    const std::string doing = "closing the file";
    checked(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), doing);
    for (Hdf5Handle& dataset : datasets_) {
        checked(dataset.close(), doing);
    }
    // HDF5 writes while it closes, so synchronising needs a second descriptor that is still open then.
    const int kept_open = ::dup(descriptor());
    if (kept_open < 0) {
        fail(doing, std::generic_category().message(errno));
    }
    const herr_t closed = file_.close();
    const int error = sync_descriptor(kept_open);
    ::close(kept_open);
    checked(closed, doing);
    if (error != 0) {
        fail(doing, std::generic_category().message(error));
    }
}

}  // namespace ljmd
