#include <fmt/format.h>

#include <algorithm>

#include "io/hdf5/hdf5_output.hpp"
#include "ljmd/core/errors.hpp"

// The datasets of an Hdf5Output that grow.

namespace ljmd {

void Hdf5Output::repeat_records(const std::vector<Series*>& series, hsize_t entries, hsize_t stride) {
    for (hsize_t begin = 0; begin < entries; begin += stride) {
        for (Series* one : series) {
            extend(*one, std::min(begin + stride, entries));
        }
    }
    for (Series* one : series) {
        one->dataset = -1;
    }
    datasets_.clear();  // to be reopened in SWMR mode
}

void Hdf5Output::open_series(Series& series) {
    if (series.dataset >= 0) {
        return;
    }
    const std::string doing = "opening " + series.name;
    const Hdf5Handle access(checked(H5Pcreate(H5P_DATASET_ACCESS), doing), H5Pclose);
    // No cache: entries go straight to the file, while a cache would write the whole chunk for each of them.
    checked(H5Pset_chunk_cache(access.get(), 0, 0, H5D_CHUNK_CACHE_W0_DEFAULT), doing);
    series.dataset = checked(H5Dopen2(file_.get(), series.name.c_str(), access.get()), doing);
    datasets_.emplace_back(series.dataset, H5Dclose);
}

void Hdf5Output::extend(Series& series, hsize_t entries) {
    open_series(series);
    std::vector<hsize_t> extent{entries};
    extent.insert(extent.end(), series.entry.begin(), series.entry.end());
    checked(H5Dset_extent(series.dataset, extent.data()), fmt::format("making {} longer", series.name));
    series.length = entries;
}

void Hdf5Output::append(Series& series, const void* data) {
    const hsize_t all = series.entry.empty() ? 1 : series.entry.front();
    append_in_parts(series, [all, data](const WritePart& write) { write(0, all, data); });
}

void Hdf5Output::append_in_parts(Series& series, const std::function<void(const WritePart&)>& fill) {
    if (!file_ || !is_on_disk_) {
        throw ContractViolation(fmt::format("'{}' is not open for appending", path().string()));
    }
    const Hdf5Silence silence;
    extend(series, series.length + 1);
    const std::string doing = fmt::format("appending entry {} to {}", series.length, series.name);
    std::vector<hsize_t> start(series.entry.size() + 1, 0);
    start[0] = series.length - 1;
    std::vector<hsize_t> shape{1};
    shape.insert(shape.end(), series.entry.begin(), series.entry.end());
    fill([&](hsize_t first, hsize_t count, const void* data) {
        if (shape.size() > 1) {
            start[1] = first;
            shape[1] = count;
        }
        const Hdf5Handle where(checked(H5Dget_space(series.dataset), doing), H5Sclose);
        checked(H5Sselect_hyperslab(where.get(), H5S_SELECT_SET, start.data(), nullptr, shape.data(), nullptr), doing);
        const Hdf5Handle what(checked(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), doing),
                              H5Sclose);
        checked(H5Dwrite(series.dataset, series.type, what.get(), where.get(), H5P_DEFAULT, data), doing);
    });
    checked(H5Dflush(series.dataset), doing);
}

std::uint64_t Hdf5Output::place_of_last(Series& series) {
    const Hdf5Silence silence;
    open_series(series);
    const std::string doing = fmt::format("asking where entry {} of {} lies", series.length, series.name);
    const Hdf5Handle creation(checked(H5Dget_create_plist(series.dataset), doing), H5Pclose);
    std::vector<hsize_t> chunk(series.entry.size() + 1);
    checked(H5Pget_chunk(creation.get(), static_cast<int>(chunk.size()), chunk.data()), doing);
    std::vector<hsize_t> corner(chunk.size());
    const hsize_t before = (series.length - 1) % chunk[0];  // entries before it in the same chunk
    corner[0] = series.length - 1 - before;
    unsigned filters = 0;
    haddr_t place = HADDR_UNDEF;
    hsize_t bytes = 0;
    checked(H5Dget_chunk_info_by_coord(series.dataset, corner.data(), &filters, &place, &bytes), doing);
    if (place == HADDR_UNDEF) {
        fail(doing, "it has no place");
    }
    return place + before * (bytes / chunk[0]);
}

}  // namespace ljmd
