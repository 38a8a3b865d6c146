#include "io/hdf5/hdf5_memory_file.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace ljmd {

struct Hdf5MemoryFile::Image {
    std::string bytes;
    std::size_t length = 0;

    static void* allocate(std::size_t size, H5FD_file_image_op_t, void*) { return std::malloc(size); }
    static void* copy(void* to, const void* from, std::size_t size, H5FD_file_image_op_t, void*) {
        return std::memcpy(to, from, size);
    }
    static void* reallocate(void* buffer, std::size_t size, H5FD_file_image_op_t, void*) {
        return std::realloc(buffer, size);
    }
    /// HDF5 releases the memory. When the file is closed, it is complete at that moment.
    static herr_t release(void* buffer, H5FD_file_image_op_t operation, void* image) {
        if (operation == H5FD_FILE_IMAGE_OP_FILE_CLOSE) {
            auto* self = static_cast<Image*>(image);
            self->bytes.assign(static_cast<const char*>(buffer), self->length);
        }
        std::free(buffer);
        return 0;
    }
    static void* share(void* image) { return image; }
    static herr_t forget(void*) { return 0; }
};

void Hdf5MemoryFile::Free::operator()(Image* image) const {
    delete image;
}

Hdf5MemoryFile::Hdf5MemoryFile() : image_(new Image) {
    static std::atomic<int> files = 0;  // HDF5 would take files of the same name for one file
    name_ = fmt::format("/dev/null/file {} in memory", ++files);
}

herr_t Hdf5MemoryFile::use_for(hid_t access) {
    constexpr std::size_t growth = std::size_t{64} << 10;
    H5FD_file_image_callbacks_t callbacks{&Image::allocate, &Image::copy,   &Image::reallocate, &Image::release,
                                          &Image::share,    &Image::forget, image_.get()};
    const herr_t in_memory = H5Pset_fapl_core(access, growth, hbool_t{false});
    return in_memory < 0 ? in_memory : H5Pset_file_image_callbacks(access, &callbacks);
}

herr_t Hdf5MemoryFile::flush(hid_t file) {
    if (H5Fflush(file, H5F_SCOPE_GLOBAL) < 0) {
        return -1;
    }
    const ssize_t length = H5Fget_file_image(file, nullptr, 0);
    image_->length = length < 0 ? 0 : static_cast<std::size_t>(length);
    return length < 0 ? -1 : 0;
}

std::string Hdf5MemoryFile::take_bytes() {
    return std::move(image_->bytes);
}

}  // namespace ljmd
