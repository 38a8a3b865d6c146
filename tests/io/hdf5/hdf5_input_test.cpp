#include "io/hdf5/hdf5_input.hpp"

#include "catch.hpp"

#include "io/hdf5/hdf5_output.hpp"
#include "io/output_fixtures.hpp"
#include "io/written_file.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// A file with one of each.
/// @param open_copy  as a kill would leave the file; may be empty
void write_all(const std::filesystem::path& path, const std::filesystem::path& open_copy = {}) {
    Hdf5Output output(path);
    output.create_group("g");
    output.create_group("g/h");
    output.write_numbers("g/numbers", std::vector<double>{0.5, -1.0, 1e300});
    output.write_numbers("g/integers", std::vector<std::int64_t>{7, -3});
    output.write_texts("g/texts", {"one", "two"});
    output.set_attribute("g", "version", std::vector<int>{1, 1});
    output.set_fixed_texts("g", "boundary", {"periodic", "none"});
    output.set_variable_text("g", "unit", "nm ps-1");
    Hdf5Output::Series series{"g/h/value", {2, 3}, H5T_NATIVE_DOUBLE};
    output.create_series(series, {1, 2, 3});
    output.start_appending();
    for (double first : {10.0, 20.0}) {
        const std::vector<double> entry{first, first + 1, first + 2, first + 3, first + 4, first + 5};
        output.append(series, entry.data());
    }
    output.commit();
    if (!open_copy.empty()) {
        std::filesystem::copy_file(path, open_copy);
    }
    output.close();
}

}  // namespace

TEST_CASE("numbers, extents, texts and members of an HDF5 file are read") {
    const TemporaryFolder folder;
    write_all(folder / "a.h5");
    CHECK(is_hdf5(folder / "a.h5"));
    const Hdf5Input input(folder / "a.h5");
    CHECK(input.was_closed());
    CHECK(input.name() == (folder / "a.h5").string());
    CHECK(input.exists("g/h/value"));
    CHECK_FALSE(input.exists("g/none/value"));
    CHECK_FALSE(input.exists(""));
    CHECK_FALSE(input.exists("g/numbers/value"));
    CHECK(input.is_dataset("g/numbers"));
    CHECK_FALSE(input.is_dataset("g/h"));
    CHECK_FALSE(input.is_dataset("none"));
    CHECK(input.members("g") == std::vector<std::string>{"h", "integers", "numbers", "texts"});
    CHECK(input.extent("g/h/value") == std::vector<Index>{2, 2, 3});
    CHECK(input.numbers("g/numbers") == std::vector<double>{0.5, -1.0, 1e300});
    CHECK(input.integers("g/integers") == std::vector<std::int64_t>{7, -3});
    CHECK(input.numbers("g/integers") == std::vector<double>{7, -3});
    CHECK(Hdf5Input(LJMD_TEST_DATA "/h5md/species_enum.h5md").integers("particles/all/species").at(26) == 0);
    CHECK(input.numbers_at("g/h/value", 1) == std::vector<double>{20, 21, 22, 23, 24, 25});
    CHECK(input.numbers_between("g/integers", 1, 2) == std::vector<double>{-3});
    CHECK(input.first_numbers("g/integers", 1) == std::vector<double>{7});
    CHECK(input.first_numbers("g/integers", 9) == std::vector<double>{7, -3});
    CHECK(input.integers_at("g/h/value", 0) == std::vector<std::int64_t>{10, 11, 12, 13, 14, 15});
    CHECK(input.number_attribute("g", "version") == std::vector<double>{1, 1});
    CHECK(input.number_attribute("g", "none").empty());
    CHECK(input.text_attribute("g", "boundary") == std::vector<std::string>{"periodic", "none"});
    CHECK(input.text_attribute("g", "unit") == std::vector<std::string>{"nm ps-1"});
    CHECK(input.text_attribute("none", "unit").empty());
}

TEST_CASE("a file that was not closed after appending is read all the same") {
    const TemporaryFolder folder;
    write_all(folder / "a.h5", folder / "open.h5");
    const Hdf5Input input(folder / "open.h5");
    CHECK_FALSE(input.was_closed());
    CHECK(input.extent("g/h/value") == std::vector<Index>{2, 2, 3});
    CHECK(input.numbers_at("g/h/value", 1)[0] == 20);
}

TEST_CASE("what cannot be read from an HDF5 file is an error with file, object and cause") {
    const TemporaryFolder folder;
    write_all(folder / "a.h5");
    const Hdf5Input input(folder / "a.h5");
    const auto complaint = [&](auto read) { return data_error([&] { static_cast<void>(read()); }); };
    CHECK_THAT(complaint([&] { return input.numbers("g/none"); }), Contains("a.h5: opening g/none: "));
    CHECK_THAT(complaint([&] { return input.numbers("g/h"); }), Contains("g/h is no dataset"));
    CHECK_THAT(complaint([&] { return input.numbers("g/texts"); }), Contains("g/texts holds no numbers"));
    CHECK_THAT(complaint([&] { return input.numbers_at("g/numbers", 3); }), Contains("g/numbers has no entry 3"));
    CHECK_THAT(complaint([&] { return input.members("none"); }), Contains("opening none"));
    CHECK_THAT(complaint([&] { return input.text_attribute("g", "version"); }), Contains("holds no texts"));
    CHECK_THAT(complaint([&] { return input.number_attribute("g", "unit"); }), Contains("holds no numbers"));
}

TEST_CASE("what is no HDF5 file, or a part of one, is refused") {
    const TemporaryFolder folder;
    write_all(folder / "a.h5");
    const std::string whole = content_of(folder / "a.h5");
    for (const std::size_t kept : {std::size_t{0}, std::size_t{8}, whole.size() / 3, whole.size() - 1}) {
        CAPTURE(kept);
        const WrittenFile cut(whole.substr(0, kept));
        CHECK_THAT(data_error([&] { static_cast<void>(Hdf5Input(cut.path())); }), Contains("HDF5 cannot open it: "));
    }
    const WrittenFile text("hello\n");
    CHECK_FALSE(is_hdf5(text.path()));
}

TEST_CASE("damage in a file that was not closed is not waited for") {
    const TemporaryFolder folder;
    write_all(folder / "a.h5", folder / "open.h5");
    std::string bytes = content_of(folder / "open.h5");
    constexpr std::size_t in_superblock = 20;
    bytes[in_superblock] = static_cast<char>(bytes[in_superblock] + 1);
    const WrittenFile damaged(bytes);
    CHECK_THAT(data_error([&] { static_cast<void>(Hdf5Input(damaged.path())); }), Contains("HDF5 cannot open it: "));
}

TEST_CASE("a file that leads to others is not followed") {
    const TemporaryFolder folder;
    write_all(folder / "other.h5");
    {
        const Hdf5Handle file(H5Fcreate((folder / "a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
        REQUIRE(H5Lcreate_external("other.h5", "g/numbers", file.get(), "elsewhere", H5P_DEFAULT, H5P_DEFAULT) >= 0);
        REQUIRE(H5Lcreate_soft("elsewhere", file.get(), "by two steps", H5P_DEFAULT, H5P_DEFAULT) >= 0);
        const hsize_t three = 3;
        const Hdf5Handle space(H5Screate_simple(1, &three, nullptr), H5Sclose);
        const auto create = [&](const char* name, const Hdf5Handle& creation) {
            const Hdf5Handle dataset(
                H5Dcreate2(file.get(), name, H5T_NATIVE_DOUBLE, space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
                H5Dclose);
            REQUIRE(dataset);
        };
        const Hdf5Handle raw(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
        REQUIRE(H5Pset_external(raw.get(), "/dev/zero", 0, H5F_UNLIMITED) >= 0);
        create("raw", raw);
        const Hdf5Handle virtual_one(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
        REQUIRE(H5Pset_virtual(virtual_one.get(), space.get(), "other.h5", "g/numbers", space.get()) >= 0);
        create("virtual", virtual_one);
    }
    const Hdf5Input input(folder / "a.h5");
    for (const char* name : {"elsewhere", "by two steps"}) {
        CHECK_THAT(data_error([&] { static_cast<void>(input.numbers(name)); }),
                   Contains(std::string("a.h5: opening ") + name + ": "));
        CHECK_THAT(data_error([&] { static_cast<void>(input.exists(std::string(name) + "/value")); }),
                   Contains(std::string("a.h5: opening ") + name + ": "));
    }
    for (const char* name : {"raw", "virtual"}) {
        CHECK_THAT(data_error([&] { static_cast<void>(input.numbers(name)); }),
                   Contains(std::string("a.h5: the numbers of ") + name + " lie in another file"));
    }
}

TEST_CASE("an extent that nothing stands behind is not believed") {
    const TemporaryFolder folder;
    {
        const Hdf5Handle file(H5Fcreate((folder / "a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
        const std::vector<hsize_t> extent{1, 1000000000000, 3};
        const std::vector<hsize_t> chunk{1, 2, 3};
        const Hdf5Handle space(H5Screate_simple(3, extent.data(), nullptr), H5Sclose);
        const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
        H5Pset_chunk(creation.get(), 3, chunk.data());
        const Hdf5Handle dataset(
            H5Dcreate2(file.get(), "huge", H5T_NATIVE_DOUBLE, space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
            H5Dclose);
        REQUIRE(dataset);
    }
    const Hdf5Input input(folder / "a.h5");
    CHECK_THAT(data_error([&] { static_cast<void>(input.numbers_at("huge", 0)); }),
               Contains("huge is larger than what is stored of it"));
}

TEST_CASE("a compressed chunk that unpacks to far more than what is stored is refused") {
    const TemporaryFolder folder;
    const auto write = [&](hsize_t chunk) {
        const Hdf5Handle file(H5Fcreate((folder / "a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
        constexpr hsize_t extent = 4;
        const hsize_t limit = H5S_UNLIMITED;
        const Hdf5Handle space(H5Screate_simple(1, &extent, &limit), H5Sclose);
        const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
        H5Pset_chunk(creation.get(), 1, &chunk);
        H5Pset_deflate(creation.get(), 6);
        const Hdf5Handle dataset(
            H5Dcreate2(file.get(), "few", H5T_NATIVE_DOUBLE, space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
            H5Dclose);
        const std::vector<double> values{1, 2, 3, 4};
        REQUIRE(H5Dwrite(dataset.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
    };
    const auto last_two = [&] { return Hdf5Input(folder / "a.h5").numbers_between("few", 2, 4); };
    constexpr hsize_t numbers_of_16_mib = hsize_t{2} << 20;
    write(numbers_of_16_mib);
    CHECK(last_two() == std::vector<double>{3, 4});
    write(numbers_of_16_mib + 1);
    CHECK_THAT(data_error([&] { static_cast<void>(last_two()); }), Contains("a chunk of few unpacks to 16.8 MB"));
}
