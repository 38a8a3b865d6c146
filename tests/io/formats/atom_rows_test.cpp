#include "io/formats/atom_rows.hpp"

#include <cmath>
#include <limits>
#include "catch.hpp"

#include "io/two_atoms.hpp"
#include "io/written_file.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;
using ljmd::test::data_error;
using ljmd::test::two_atoms;
using ljmd::test::WrittenFile;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What is said about it after a change; its atoms stand in the lines 8 (id 2) and 9 (id 1), its box in line 3.
template <class Change>
std::string complaint(Change&& change) {
    const WrittenFile written("");
    const TextFile file(written.path());
    Configuration configuration = two_atoms();
    change(configuration);
    return data_error([&] { check_configuration(file, configuration, AtomOrder{{1, 2}, {1, 0}, 8}, 3); });
}

}  // namespace

TEST_CASE("a number of atoms is a positive integer that the file has room for") {
    const auto read = [](const std::string& text) {
        const WrittenFile written(text);
        TextFile file(written.path());
        REQUIRE(file.next_line());
        Index count = 0;
        const std::string error = data_error([&] { count = read_atom_count(file, file.line()); });
        return count > 0 ? std::to_string(count) : error;
    };
    CHECK(read("2\na\nb\n") == "2");
    CHECK(read("2\na\nb") == "2");
    CHECK_THAT(read("0\na\n"), Contains(":1: the number of atoms must be at least 1, found 0"));
    CHECK_THAT(read("two\n"), Contains("must be an integer"));
    CHECK_THAT(read("3\na\nb\n"), Contains("announces 3 atoms"));
    CHECK_THAT(read("9000000000000000000\na\n"), Contains("announces 9000000000000000000 atoms"));
}

TEST_CASE("a frame has as many atoms as it must have, which is seen before its lines are counted") {
    const WrittenFile written("3\na\nb\n");
    TextFile file(written.path());
    REQUIRE(file.next_line());
    CHECK_THAT(data_error([&] { static_cast<void>(read_atom_count(file, file.line(), 2)); }),
               Contains(":1: 3 atoms, but frame 1 has 2"));
}

TEST_CASE("memory is reserved for no more atoms than the file can hold") {
    const WrittenFile written(std::string(800, 'x'));
    const TextFile file(written.path());
    CHECK(expected_atoms(file, 5) == 5);
    CHECK(expected_atoms(file, Index{1} << 60) == 101);
}

TEST_CASE("each atom has its line, which is not blank") {
    const WrittenFile written("1 0 0 0\n2 0 0 1\n \t\n");
    TextFile file(written.path());
    next_atom_line(file, 0, 4);
    CHECK(file.line() == "1 0 0 0");
    next_atom_line(file, 1, 4);
    CHECK_THAT(data_error([&] { next_atom_line(file, 2, 4); }),
               Contains(":3: blank line where atom 3 of 4 should stand"));
    CHECK_THAT(data_error([&] { next_atom_line(file, 3, 4); }), Contains(":3: the file ends after 3 of 4 atoms"));
}

TEST_CASE("a vector is read from where it stands in its line") {
    const WrittenFile written("");
    const TextFile file(written.path());
    CHECK(read_vector(file, {"7", "1", "-2.5", "3e-1", "x"}, 1) == Vec3(1.0, -2.5, 0.3));
    CHECK_THAT(data_error([&] { (void)read_vector(file, {"1", "2", "x"}, 0); }), Contains("'x'"));
}

TEST_CASE("without ids atoms stand in the order of the file") {
    const AtomOrder order = file_order(3, 10);
    CHECK(order.rows == std::vector<Index>{0, 1, 2});
    CHECK(order.id(0) == 1);
    CHECK(order.line(2) == 12);
}

TEST_CASE("with ids atoms stand in their order, whether they count from 1, from 0 or with gaps") {
    const WrittenFile written("");
    const TextFile file(written.path());
    const AtomOrder from_one = order_by_id(file, {3, 1, 2}, 10);
    CHECK(from_one.rows == std::vector<Index>{1, 2, 0});
    CHECK(from_one.id(0) == 1);
    CHECK(from_one.line(0) == 11);
    CHECK(arranged(std::vector<double>{30.0, 10.0, 20.0}, from_one.rows) == std::vector<double>{10.0, 20.0, 30.0});
    CHECK(arranged(std::vector<double>{}, from_one.rows).empty());
    const AtomOrder from_zero = order_by_id(file, {2, 0, 1}, 10);
    CHECK(from_zero.rows == std::vector<Index>{1, 2, 0});
    CHECK(from_zero.id(0) == 0);
    const AtomOrder sparse = order_by_id(file, {900, 5, std::numeric_limits<Index>::max()}, 10);
    CHECK(sparse.rows == std::vector<Index>{1, 0, 2});
    CHECK(sparse.ids == std::vector<Index>{5, 900, std::numeric_limits<Index>::max()});
    CHECK(sparse.line(0) == 11);
    const auto error = [&](const std::vector<Index>& ids) {
        return data_error([&] { (void)order_by_id(file, ids, 10); });
    };
    CHECK_THAT(error({1, 2, 2}), Contains(":12: id 2 occurs twice, first in line 11"));
    CHECK_THAT(error({7, 2, 7, 1}), Contains(":12: id 7 occurs twice, first in line 10"));
    CHECK_THAT(error({1, -1, 2}), Contains(":11: id -1: ids must not be negative"));
}

TEST_CASE("a configuration is checked as a whole, and atoms are named by their ids and lines") {
    CHECK(complaint([](Configuration&) {}) == "no DataError");
    const auto edge = [](double value) { return complaint([&](Configuration& c) { c.edges[1] = value; }); };
    for (const double bad : {0.0, -5.0, infinity, std::nan("")}) {
        CHECK_THAT(edge(bad), Contains(":3: the edges of the box must be positive and finite"));
    }
    CHECK_THAT(edge(4.1e6), Contains(":3: ") && Contains("differ by more than a factor"));
    CHECK(edge(3.9e6) == "no DataError");
    CHECK_THAT(complaint([](Configuration& c) { c.edges *= 1e-110; }), Contains(":3: the volume of the box"));
    CHECK_THAT(complaint([](Configuration& c) { c.time = infinity; }), Contains(":3: the time is not finite"));

    CHECK_THAT(complaint([](Configuration& c) { c.positions[1][0] = std::nan(""); }),
               Contains(":8: atom 2 has a position that is not finite"));
    CHECK_THAT(complaint([](Configuration& c) { c.positions[0][0] = -4.1e6; }), Contains(":9: atom 1 is more than"));
    CHECK_THAT(complaint([](Configuration& c) { c.velocities[1][2] = infinity; }),
               Contains(":8: atom 2 has a velocity"));
    CHECK_THAT(complaint([](Configuration& c) { c.masses[0] = 0.0; }), Contains(":9: atom 1 has the mass 0"));
    CHECK_THAT(complaint([](Configuration& c) {
                   c.positions[1] = {-3.5, 6.0, 13.5};
               }),
               Contains(":9: atoms 1 and 2 are at the same place in the periodic box"));
    CHECK(complaint([](Configuration& c) { c.positions[1] = {-3.5, 6.0, 13.5000001}; }) == "no DataError");
    // a hair below the far wall is on the wall once it is on the box's grid, and so at the near one
    CHECK_THAT(complaint([](Configuration& c) {
                   c.positions = {{0.0, 1.0, 1.0}, {3.9999999999999996, 1.0, 1.0}};
               }),
               Contains("same place"));
    CHECK(complaint([](Configuration& c) {
              c.velocities.clear();
              c.masses.clear();
          }) == "no DataError");
}
