#include "../../../src/io/hdf5/hdf5_output.hpp"

#include <algorithm>
#include <tuple>

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// Full disks, and what other readers see while a file is written, are tested in h5md_test.cpp.

namespace {

Hdf5Handle open_file(const std::filesystem::path& path) {
    Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    REQUIRE(file);
    return file;
}

std::vector<double> numbers_in(const Hdf5Handle& file, const std::string& name) {
    const Hdf5Handle dataset(H5Dopen2(file.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
    REQUIRE(dataset);
    const Hdf5Handle space(H5Dget_space(dataset.get()), H5Sclose);
    std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())));
    REQUIRE(H5Dread(dataset.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
    return values;
}

}  // namespace

TEST_CASE("groups, attributes, arrays and links are in the file") {
    const TemporaryFolder folder;
    {
        Hdf5Output output(folder / "a.h5md");
        CHECK(output.path() == folder / "a.h5md");
        output.create_group("g");
        output.set_attribute("g", "version", std::vector<int>{1, 1});
        output.set_attribute("g", "dimension", 3);
        output.set_fixed_texts("g", "boundary", {"periodic", "none"});
        output.set_variable_text("g", "unit", "nm ps-1");
        output.write_numbers("g/x", std::vector<double>{0.1, -2.0});
        output.write_numbers("g/n", std::vector<std::int64_t>{std::int64_t{1} << 40});
        output.link("g/x", "g/y");
        output.close();
        CHECK_NOTHROW(output.close());
    }
    const Hdf5Handle file = open_file(folder / "a.h5md");
    CHECK(numbers_in(file, "g/x") == std::vector<double>{0.1, -2.0});
    CHECK(numbers_in(file, "g/y") == std::vector<double>{0.1, -2.0});
    CHECK(numbers_in(file, "g/n") == std::vector<double>{1099511627776.0});
    int version[2] = {0, 0};
    const Hdf5Handle attribute(H5Aopen_by_name(file.get(), "g", "version", H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    REQUIRE(H5Aread(attribute.get(), H5T_NATIVE_INT, version) >= 0);
    CHECK(version[0] == 1);
    CHECK(version[1] == 1);
    const Hdf5Handle boundary(H5Aopen_by_name(file.get(), "g", "boundary", H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    const Hdf5Handle type(H5Aget_type(boundary.get()), H5Tclose);
    CHECK(H5Tis_variable_str(type.get()) == 0);
    CHECK(H5Tget_size(type.get()) == 9);  // "periodic" and the zero that readers in C expect
}

TEST_CASE("a series grows by one entry at each append, and keeps its shape") {
    const TemporaryFolder folder;
    Hdf5Output::Series scalar{.name = "t", .entry = {}, .type = H5T_NATIVE_INT64};
    Hdf5Output::Series matrix{.name = "m", .entry = {2, 2}, .type = H5T_NATIVE_DOUBLE};
    {
        Hdf5Output output(folder / "a.h5md");
        output.create_series(scalar, {4});
        output.create_series(matrix, {1, 2, 2});
        output.start_appending();
        for (std::int64_t k = 0; k < 5; ++k) {
            const auto x = static_cast<double>(k);
            const double values[4] = {x, x + 0.1, x + 0.2, x + 0.3};
            output.append(scalar, &k);
            output.append(matrix, values);
            output.commit();
        }
    }  // closed by the destructor
    CHECK(scalar.length == 5);
    const Hdf5Handle file = open_file(folder / "a.h5md");
    CHECK(numbers_in(file, "t") == std::vector<double>{0.0, 1.0, 2.0, 3.0, 4.0});
    const auto all = numbers_in(file, "m");
    REQUIRE(all.size() == 20);
    CHECK(all[0] == 0.0);
    CHECK(all[17] == 4.1);
}

TEST_CASE("a failed call is an error that names the file and what was being done") {
    const TemporaryFolder folder;
    CHECK_THROWS_WITH(Hdf5Output(folder / "none" / "a.h5md").start_appending(),
                      Contains("none/a.h5md'") && Contains("No such file or directory"));
    Hdf5Output output(folder / "a.h5md");
    CHECK_THROWS_AS(output.create_group("no/parent"), FileError);
    Hdf5Output other(folder / "b.h5md");
    CHECK_THROWS_WITH(other.create_group("no/parent"), Contains("b.h5md': creating group no/parent"));
}

TEST_CASE("a file is there when its objects are complete, not before") {
    const TemporaryFolder folder;
    {
        Hdf5Output output(folder / "a.h5md");
        output.create_group("g");
        CHECK(folder.count_files() == 0);
    }
    CHECK(folder.count_files() == 0);
    Hdf5Output output(folder / "a.h5md");
    output.create_group("g");
    output.start_appending();
    CHECK(folder.count_files() == 1);
}

TEST_CASE("the layout is known by the objects") {
    const TemporaryFolder folder;
    const auto layout = [&folder](const std::string& group) {
        Hdf5Output output(folder / "a.h5md");
        output.create_group(group);
        return output.layout();
    };
    CHECK(layout("a") == layout("a"));
    CHECK(layout("a") != layout("b"));
}

namespace {

/// Numbers and pairs of numbers with chunks of eight and two entries, from `kept` on; none: a new file.
/// @param left_open  as in a program that is killed
void append_until(const std::filesystem::path& path, std::optional<int> kept, int end, bool left_open = false) {
    Hdf5Output output(path);
    Hdf5Output::Series number{.name = "t", .entry = {}, .type = H5T_NATIVE_INT64};
    Hdf5Output::Series pair{.name = "p", .entry = {2}, .type = H5T_NATIVE_DOUBLE};
    output.create_series(number, {8});
    output.create_series(pair, {2, 2});
    if (kept) {
        output.continue_appending({&number, &pair}, static_cast<hsize_t>(*kept), 2);
    } else {
        output.start_appending();
    }
    for (std::int64_t k = kept.value_or(0); k < end; ++k) {
        const double values[2] = {static_cast<double>(k), 0.5};
        output.append(number, &k);
        output.append(pair, values);
    }
    if (left_open) {
        // The copy is what a kill leaves. HDF5 would find the file itself still open.
        const std::filesystem::path copy = path.string() + ".copy";
        std::filesystem::copy_file(path, copy);
        output.close();
        std::filesystem::rename(copy, path);
    } else {
        output.close();
    }
}

}  // namespace

TEST_CASE("a file is continued in place, from any number of entries, and is byte for byte the one written at once") {
    const TemporaryFolder folder;
    append_until(folder / "whole", std::nullopt, 150);
    const std::string whole = content_of(folder / "whole");
    for (const int kept : {0, 1, 2, 3, 8, 9, 16, 17, 99, 100, 149, 150}) {
        for (const bool left_open : {false, true}) {
            INFO(kept << (left_open ? ", left open" : ", closed"));
            append_until(folder / "parts", std::nullopt, kept == 150 ? 150 : kept + 1, left_open);
            append_until(folder / "parts", kept, 150);
            REQUIRE((content_of(folder / "parts") == whole));  // in brackets: not to be printed
        }
    }
}

TEST_CASE("a file is continued whatever became of what HDF5 keeps about its entries") {
    const TemporaryFolder folder;
    append_until(folder / "whole", std::nullopt, 40);
    append_until(folder / "parts", std::nullopt, 20);
    std::string bytes = content_of(folder / "parts");
    std::vector<bool> is_entry(bytes.size(), false);
    {
        const Hdf5Handle file = open_file(folder / "parts");
        for (const auto& [name, entries, size] : {std::tuple{"t", 8, 8}, std::tuple{"p", 2, 16}}) {
            const Hdf5Handle series(H5Dopen2(file.get(), name, H5P_DEFAULT), H5Dclose);
            for (int first = 0; first < 20; first += entries) {
                const hsize_t corner[2] = {static_cast<hsize_t>(first), 0};
                unsigned filters = 0;
                haddr_t place = 0;
                hsize_t length = 0;
                REQUIRE(H5Dget_chunk_info_by_coord(series.get(), corner, &filters, &place, &length) >= 0);
                std::fill_n(is_entry.begin() + static_cast<std::ptrdiff_t>(place), entries * size, true);
            }
        }
    }
    for (std::size_t k = 0; k < bytes.size(); ++k) {
        if (!is_entry[k]) {
            bytes[k] = 'x';
        }
    }
    std::ofstream(folder / "parts", std::ios::binary) << bytes;
    append_until(folder / "parts", 20, 40);
    CHECK((content_of(folder / "parts") == content_of(folder / "whole")));
}

TEST_CASE("nothing is appended to a closed file") {
    const TemporaryFolder folder;
    Hdf5Output output(folder / "a.h5md");
    Hdf5Output::Series series{.name = "t", .entry = {}, .type = H5T_NATIVE_DOUBLE};
    output.create_series(series, {1});
    output.start_appending();
    output.close();
    const double value = 1.0;
    CHECK_THROWS_AS(output.append(series, &value), ContractViolation);
    CHECK(numbers_in(open_file(folder / "a.h5md"), "t").empty());
}

TEST_CASE("a file takes the place of a link when it is begun, and leaves what that led to") {
    const TemporaryFolder folder;
    std::ofstream(folder / "precious") << "mine";
    std::filesystem::create_symlink(folder / "precious", folder / "a.h5md");
    {
        Hdf5Output never(folder / "a.h5md");
        never.create_group("g");
    }
    CHECK(std::filesystem::is_symlink(folder / "a.h5md"));
    Hdf5Output output(folder / "a.h5md");
    output.start_appending();
    CHECK_FALSE(std::filesystem::is_symlink(folder / "a.h5md"));
    output.close();
    CHECK(open_file(folder / "a.h5md"));
    CHECK(content_of(folder / "precious") == "mine");
    CHECK(folder.count_files() == 2);
}
