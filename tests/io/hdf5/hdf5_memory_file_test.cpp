#include "../../../src/io/hdf5/hdf5_memory_file.hpp"

#include "catch.hpp"

#include "io/hdf5/hdf5_handle.hpp"
#include "io/output_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

/// A file in the format of HDF5 1.10, with a group.
/// @param path    of a file on the disk
/// @param memory  or where it is made
void make_file(const std::filesystem::path& path, Hdf5MemoryFile* memory) {
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110);
    const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    H5Pset_obj_track_times(creation.get(), false);
    if (memory != nullptr) {
        REQUIRE(memory->use_for(access.get()) >= 0);
    }
    const std::string name = memory == nullptr ? path.string() : memory->name();
    Hdf5Handle file(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose);
    REQUIRE(file);
    const Hdf5Handle group_creation(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
    H5Pset_obj_track_times(group_creation.get(), false);
    Hdf5Handle group(H5Gcreate2(file.get(), "g", H5P_DEFAULT, group_creation.get(), H5P_DEFAULT), H5Gclose);
    REQUIRE(group.close() >= 0);
    if (memory != nullptr) {
        REQUIRE(memory->flush(file.get()) >= 0);
    }
    REQUIRE(file.close() >= 0);
}

}  // namespace

TEST_CASE("the bytes of a file in memory are those that it would have on the disk") {
    const TemporaryFolder folder;
    Hdf5MemoryFile memory;
    make_file({}, &memory);
    make_file(folder / "disk.h5", nullptr);
    CHECK(memory.take_bytes() == content_of(folder / "disk.h5"));
}
