#include "io/hdf5/hdf5_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <type_traits>

#include "core/memory_at_hand.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// Upper bound of the compression ratio; deflate reaches 1032.
constexpr double largest_compression = 1100.0;
/// HDF5 unpacks a compressed chunk as a whole. Its unpacked size must not exceed this, or this multiple of the stored
/// size of all chunks, whichever is larger.
constexpr double default_chunk_bytes = 16 << 20;
constexpr double chunk_compression = 100.0;
/// HDF5's default chunk cache of a dataset.
constexpr std::size_t default_cache = std::size_t{1} << 20;
constexpr int max_axes = 8;
/// Attempts to read metadata that another program is writing. HDF5 doubles the wait before each: milliseconds in all,
/// and no endless loop for a damaged file.
constexpr unsigned read_attempts = 20;
constexpr Index max_attribute_elements = 64;

template <class T>
hid_t native_type() {
    return std::is_same_v<T, double> ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT64;
}

double product(const std::vector<Index>& extent) {
    return std::accumulate(extent.begin(), extent.end(), 1.0,
                           [](double sum, Index n) { return sum * static_cast<double>(n); });
}

/// Refuse links to other files, which may be pipes or devices.
herr_t refuse_to_follow(const char*, const char*, const char*, const char*, unsigned*, hid_t, void*) {
    return -1;
}

bool holds_numbers(hid_t type) {
    const H5T_class_t kind = H5Tget_class(type);
    return kind == H5T_FLOAT || kind == H5T_INTEGER || kind == H5T_ENUM;
}

}  // namespace

bool is_hdf5(const std::filesystem::path& path) {
    const Hdf5Silence silence;
    const htri_t found = H5Fis_hdf5(path.c_str());
    if (found < 0) {
        throw DataError(fmt::format("{}: cannot be read: {}", path.string(), hdf5_error_text()));
    }
    return found > 0;
}

Hdf5Input::Hdf5Input(const std::filesystem::path& path) : name_(path.string()) {
    const Hdf5Silence silence;
    links_ = Hdf5Handle(checked(H5Pcreate(H5P_LINK_ACCESS), "preparing to open it"), H5Pclose);
    checked(H5Pset_elink_cb(links_.get(), refuse_to_follow, nullptr), "preparing to open it");
    require_memory(hdf5_file_memory);
    const Hdf5Handle access(checked(H5Pcreate(H5P_FILE_ACCESS), "preparing to open it"), H5Pclose);
    // Not locked: some file systems have no locks, and the writer of the file takes none either.
    checked(H5Pset_file_locking(access.get(), false, true), "preparing to open it");
    file_ = Hdf5Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose);
    if (file_) {
        return;
    }
    const std::string cause = hdf5_error_text();
    checked(H5Pset_metadata_read_attempts(access.get(), read_attempts), "opening it");
    file_ = Hdf5Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access.get()), H5Fclose);
    was_closed_ = false;
    if (!file_) {
        fail(fmt::format("HDF5 cannot open it: {}", cause));
    }
}

void Hdf5Input::fail(const std::string& message) const {
    throw DataError(fmt::format("{}: {}", name_, message));
}

hid_t Hdf5Input::checked(hid_t id, const std::string& doing) const {
    if (id < 0) {
        fail(fmt::format("{}: {}", doing, hdf5_error_text()));
    }
    return id;
}

bool Hdf5Input::exists(const std::string& object) const {
    if (object.empty()) {
        return false;
    }
    const Hdf5Silence silence;
    for (std::size_t end = object.find('/'); true; end = object.find('/', end + 1)) {
        const std::string part = object.substr(0, end);
        if (checked(H5Lexists(file_.get(), part.c_str(), links_.get()), "looking for " + part) == 0) {
            return false;
        }
        if (end == std::string::npos) {
            return true;
        }
        if (H5Iget_type(open(part).get()) != H5I_GROUP) {
            return false;
        }
    }
}

Hdf5Handle Hdf5Input::open(const std::string& object) const {
    return {checked(H5Oopen(file_.get(), object.c_str(), links_.get()), "opening " + object), H5Oclose};
}

hid_t Hdf5Input::open_dataset(const std::string& dataset) const {
    const auto known = datasets_.find(dataset);
    if (known != datasets_.end()) {
        return known->second.get();
    }
    Hdf5Handle handle = open(dataset);
    if (H5Iget_type(handle.get()) != H5I_DATASET) {
        fail(fmt::format("{} is no dataset", dataset));
    }
    require_stored(handle.get(), dataset);
    if (const double bytes = packed_chunk_bytes(handle.get(), dataset); bytes > 0.0) {
        // Room for a chunk, else it is unpacked again for each entry in it. Closed first: the cache is set at the first
        // opening.
        handle.close();
        const std::string doing = "opening " + dataset;
        const Hdf5Handle access(checked(H5Pcreate(H5P_DATASET_ACCESS), doing), H5Pclose);
        checked(H5Pset_elink_cb(access.get(), refuse_to_follow, nullptr), doing);
        checked(H5Pset_chunk_cache(access.get(), H5D_CHUNK_CACHE_NSLOTS_DEFAULT,
                                   std::max<std::size_t>(default_cache, static_cast<std::size_t>(bytes)),
                                   H5D_CHUNK_CACHE_W0_DEFAULT),
                doing);
        handle = Hdf5Handle(checked(H5Dopen2(file_.get(), dataset.c_str(), access.get()), doing), H5Dclose);
    }
    return datasets_.emplace(dataset, std::move(handle)).first->second.get();
}

bool Hdf5Input::is_dataset(const std::string& object) const {
    const Hdf5Silence silence;
    return exists(object) && H5Iget_type(open(object).get()) == H5I_DATASET;
}

std::vector<std::string> Hdf5Input::members(const std::string& group) const {
    const Hdf5Silence silence;
    const Hdf5Handle handle = open(group);
    std::vector<std::string> names;
    const auto note = [](hid_t, const char* name, const H5L_info_t*, void* data) -> herr_t {
        static_cast<std::vector<std::string>*>(data)->emplace_back(name);
        return 0;
    };
    checked(H5Literate(handle.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, note, &names), "looking into " + group);
    return names;
}

std::vector<Index> Hdf5Input::extent_of(hid_t space, const std::string& what) const {
    const auto axes = static_cast<int>(checked(H5Sget_simple_extent_ndims(space), "asking for the extent of " + what));
    if (axes > max_axes || H5Sget_simple_extent_type(space) == H5S_NULL) {
        fail(fmt::format("{} is no array of numbers", what));
    }
    std::vector<hsize_t> lengths(static_cast<std::size_t>(axes));
    checked(H5Sget_simple_extent_dims(space, lengths.data(), nullptr), "asking for the extent of " + what);
    return {lengths.begin(), lengths.end()};
}

std::vector<Index> Hdf5Input::extent(const std::string& dataset) const {
    const Hdf5Silence silence;
    const Hdf5Handle space(checked(H5Dget_space(open_dataset(dataset)), "reading " + dataset), H5Sclose);
    return extent_of(space.get(), dataset);
}

/// Refuse a dataset whose extent is larger than its stored data can explain.
void Hdf5Input::require_stored(hid_t dataset, const std::string& name) const {
    const Hdf5Handle type(checked(H5Dget_type(dataset), "reading " + name), H5Tclose);
    const Hdf5Handle space(checked(H5Dget_space(dataset), "reading " + name), H5Sclose);
    if (!holds_numbers(type.get())) {
        fail(fmt::format("{} holds no numbers", name));
    }
    const Hdf5Handle creation(checked(H5Dget_create_plist(dataset), "reading " + name), H5Pclose);
    if (H5Pget_external_count(creation.get()) != 0 || H5Pget_layout(creation.get()) == H5D_VIRTUAL) {
        fail(fmt::format("the numbers of {} lie in another file", name));
    }
    const double claimed = product(extent_of(space.get(), name)) * static_cast<double>(H5Tget_size(type.get()));
    if (claimed > largest_compression * static_cast<double>(H5Dget_storage_size(dataset))) {
        fail(fmt::format("{} is larger than what is stored of it", name));
    }
}

/// Unpacked size of a chunk of a compressed dataset; else 0. @throws DataError  the chunks unpack to too much
double Hdf5Input::packed_chunk_bytes(hid_t dataset, const std::string& name) const {
    const Hdf5Handle creation(checked(H5Dget_create_plist(dataset), "reading " + name), H5Pclose);
    if (H5Pget_layout(creation.get()) != H5D_CHUNKED || H5Pget_nfilters(creation.get()) == 0) {
        return 0.0;
    }
    std::array<hsize_t, max_axes> chunk{};
    const int axes = H5Pget_chunk(creation.get(), max_axes, chunk.data());
    const Hdf5Handle type(checked(H5Dget_type(dataset), "reading " + name), H5Tclose);
    auto bytes = static_cast<double>(H5Tget_size(type.get()));
    for (int axis = 0; axis < axes; ++axis) {
        bytes *= static_cast<double>(chunk[static_cast<std::size_t>(axis)]);
    }
    const auto stored = static_cast<double>(H5Dget_storage_size(dataset));
    if (bytes > std::max(default_chunk_bytes, chunk_compression * stored)) {
        fail(fmt::format("a chunk of {} unpacks to {:.3g} MB, and {:.3g} MB are stored of all of it", name, bytes / 1e6,
                         stored / 1e6));
    }
    return bytes;
}

template <class T>
std::vector<T> Hdf5Input::read(const std::string& dataset, std::optional<Entries> entries) const {
    const Hdf5Silence silence;
    const std::string doing = "reading " + dataset;
    const hid_t source = open_dataset(dataset);
    const Hdf5Handle space(checked(H5Dget_space(source), doing), H5Sclose);
    std::vector<Index> wanted = extent_of(space.get(), dataset);
    if (entries) {
        if (wanted.empty() || entries->end > wanted[0]) {
            fail(fmt::format("{} has no entry {}", dataset, entries->end - 1));
        }
        wanted[0] = entries->end - entries->begin;
        std::vector<hsize_t> start(wanted.size());
        start[0] = static_cast<hsize_t>(entries->begin);
        const std::vector<hsize_t> count(wanted.begin(), wanted.end());
        checked(H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr), doing);
    }
    std::vector<T> values(static_cast<std::size_t>(product(wanted)));
    const hsize_t length = values.size();
    const Hdf5Handle memory(checked(H5Screate_simple(1, &length, nullptr), doing), H5Sclose);
    const hid_t file_space = entries ? space.get() : H5S_ALL;
    const hid_t memory_space = entries ? memory.get() : H5S_ALL;
    checked(H5Dread(source, native_type<T>(), memory_space, file_space, H5P_DEFAULT, values.data()), doing);
    return values;
}

std::vector<double> Hdf5Input::numbers(const std::string& dataset) const {
    return read<double>(dataset, std::nullopt);
}

std::vector<double> Hdf5Input::first_numbers(const std::string& dataset, Index entries) const {
    const std::vector<Index> all = extent(dataset);
    return all.empty() ? numbers(dataset) : numbers_between(dataset, 0, std::min(entries, all[0]));
}

std::vector<double> Hdf5Input::numbers_between(const std::string& dataset, Index begin, Index end) const {
    return read<double>(dataset, Entries{begin, end});
}

std::vector<double> Hdf5Input::numbers_at(const std::string& dataset, Index entry) const {
    return read<double>(dataset, Entries{entry, entry + 1});
}

std::vector<std::int64_t> Hdf5Input::integers(const std::string& dataset) const {
    return read<std::int64_t>(dataset, std::nullopt);
}

std::vector<std::int64_t> Hdf5Input::integers_at(const std::string& dataset, Index entry) const {
    return read<std::int64_t>(dataset, Entries{entry, entry + 1});
}

struct Hdf5Input::Attribute {
    std::string what;  ///< for messages
    Hdf5Handle handle;
    Hdf5Handle type;
    Hdf5Handle space;
    std::size_t count;  ///< number of elements
};

/// Nothing if there is no such attribute. @throws DataError  it has too many elements
std::optional<Hdf5Input::Attribute> Hdf5Input::open_attribute(const std::string& object,
                                                              const std::string& name) const {
    if (!exists(object)) {
        return std::nullopt;
    }
    const Hdf5Handle owner = open(object);
    if (checked(H5Aexists(owner.get(), name.c_str()), fmt::format("looking for {} of {}", name, object)) == 0) {
        return std::nullopt;
    }
    const std::string what = fmt::format("{} of {}", name, object);
    const std::string reading = "reading " + what;
    Hdf5Handle handle(checked(H5Aopen(owner.get(), name.c_str(), H5P_DEFAULT), reading), H5Aclose);
    Hdf5Handle type(checked(H5Aget_type(handle.get()), reading), H5Tclose);
    Hdf5Handle space(checked(H5Aget_space(handle.get()), reading), H5Sclose);
    const double count = product(extent_of(space.get(), what));
    if (count > max_attribute_elements) {
        fail(fmt::format("{} has more than {} elements", what, max_attribute_elements));
    }
    return Attribute{what, std::move(handle), std::move(type), std::move(space), static_cast<std::size_t>(count)};
}

std::vector<double> Hdf5Input::number_attribute(const std::string& object, const std::string& name) const {
    const Hdf5Silence silence;
    const auto attribute = open_attribute(object, name);
    if (!attribute) {
        return {};
    }
    if (!holds_numbers(attribute->type.get())) {
        fail(fmt::format("{} holds no numbers", attribute->what));
    }
    std::vector<double> values(attribute->count);
    checked(H5Aread(attribute->handle.get(), H5T_NATIVE_DOUBLE, values.data()), "reading " + attribute->what);
    return values;
}

std::vector<std::string> Hdf5Input::text_attribute(const std::string& object, const std::string& name) const {
    const Hdf5Silence silence;
    const auto attribute = open_attribute(object, name);
    if (!attribute) {
        return {};
    }
    const auto& [what, handle, type, space, count] = *attribute;
    if (H5Tget_class(type.get()) != H5T_STRING) {
        fail(fmt::format("{} holds no texts", what));
    }
    std::vector<std::string> values;
    if (H5Tis_variable_str(type.get()) > 0) {
        std::vector<char*> pointers(count, nullptr);
        checked(H5Aread(handle.get(), type.get(), pointers.data()), "reading " + what);
        for (const char* text : pointers) {
            values.emplace_back(text == nullptr ? "" : text);
        }
        H5Dvlen_reclaim(type.get(), space.get(), H5P_DEFAULT, pointers.data());
        return values;
    }
    const std::size_t length = H5Tget_size(type.get());
    std::string characters(count * length, '\0');
    checked(H5Aread(handle.get(), type.get(), characters.data()), "reading " + what);
    for (std::size_t k = 0; k < count; ++k) {
        const std::string text = characters.substr(k * length, length);
        values.push_back(text.substr(0, text.find('\0')));
    }
    return values;
}

}  // namespace ljmd
