#include "ljmd/detail/core/archive.hpp"

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/aligned_vector.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

enum class Colour : std::uint8_t { red = 3, green = 7 };

struct Inner {
    int number = 0;
    std::string text;
    void archive(Archive& a) { a(number, text); }
    bool operator==(const Inner&) const = default;
};

/// One of everything.
struct Everything {
    bool flag = false;
    std::int64_t integer = 0;
    double real = 0.0;
    Colour colour = Colour::red;
    std::string text;
    std::vector<double> reals;
    AlignedVector<double> aligned;
    std::vector<Inner> inner;
    std::array<int, 3> triple{};
    std::pair<double, std::string> pair;
    std::optional<double> some;
    std::optional<Inner> none;
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::MatrixXd dynamic;
    Eigen::VectorXd vector;

    void archive(Archive& a) {
        a(flag, integer, real, colour, text, reals, aligned, inner, triple, pair, some, none, matrix, dynamic, vector);
    }
};

Everything example() {
    Everything all;
    all.flag = true;
    all.integer = std::numeric_limits<std::int64_t>::min();
    all.real = -0.0;
    all.colour = Colour::green;
    all.text = std::string("zero \0 inside", 13);
    all.reals = {1.0, std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::infinity()};
    all.aligned = {2.0, 3.0};
    all.inner = {{1, "one"}, {2, ""}};
    all.triple = {4, 5, 6};
    all.pair = {0.1, "tenth"};
    all.some = std::nan("");
    all.matrix << 1, 2, 3, 4, 5, 6, 7, 8, 9;
    all.dynamic = Eigen::MatrixXd::Constant(2, 5, 0.5);
    return all;
}

std::vector<std::byte> written(Everything all) {
    Archive archive;
    archive(all);
    return {archive.bytes().begin(), archive.bytes().end()};
}

}  // namespace

TEST_CASE("what is read from an archive is what was written, bit for bit") {
    const std::vector<std::byte> bytes = written(example());
    Archive archive(bytes);
    Everything read;
    read.reals = {7.0};  // what was there before is gone
    read.none = Inner{9, "nine"};
    archive(read);
    CHECK_NOTHROW(archive.expect_end());
    CHECK(read.flag);
    CHECK(read.integer == std::numeric_limits<std::int64_t>::min());
    CHECK(std::signbit(read.real));
    CHECK(read.colour == Colour::green);
    CHECK(read.text == example().text);
    CHECK(read.reals == example().reals);
    CHECK(read.aligned == example().aligned);
    CHECK(read.inner == example().inner);
    CHECK(read.triple == example().triple);
    CHECK(read.pair == example().pair);
    REQUIRE(read.some);
    CHECK(std::isnan(*read.some));
    CHECK_FALSE(read.none);
    CHECK(read.matrix == example().matrix);
    CHECK(read.dynamic == example().dynamic);
    CHECK(read.vector.size() == 0);
    CHECK(written(read) == bytes);
}

TEST_CASE("an archive that ends anywhere is refused, and so is one with something behind its end") {
    const std::vector<std::byte> bytes = written(example());
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        Archive archive(std::span<const std::byte>(bytes).first(length));
        Everything read;
        CHECK_THROWS_AS(archive(read), CheckpointError);
    }
    std::vector<std::byte> longer = bytes;
    longer.push_back(std::byte{0});
    Archive archive(longer);
    Everything read;
    archive(read);
    CHECK_THROWS_WITH(archive.expect_end(), Contains("something follows its end"));
}

TEST_CASE("no bit of an archive that is wrong makes it read beyond its end or ask for more memory than there can be") {
    const std::vector<std::byte> bytes = written(example());
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        std::vector<std::byte> damaged = bytes;
        damaged[bit / 8] ^= std::byte{1} << (bit % 8);
        Archive archive(damaged);
        Everything read;
        try {
            archive(read);
            CHECK(read.reals.size() <= bytes.size());
            CHECK(static_cast<std::size_t>(read.dynamic.size()) <= bytes.size());
        } catch (const CheckpointError&) {
            CHECK(true);
        }
    }
}

TEST_CASE("lengths that no file can have are refused") {
    Archive lengths;
    std::uint64_t huge = std::uint64_t{1} << 61;
    std::int64_t rows = std::int64_t{1} << 40;
    std::int64_t columns = std::int64_t{1} << 40;
    std::int64_t negative = -1;
    SECTION("of a list") {
        lengths(huge);
        Archive archive(lengths.bytes());
        std::vector<double> list;
        CHECK_THROWS_WITH(archive(list), Contains("a list is longer"));
    }
    SECTION("of a matrix") {
        lengths(rows, columns);
        Archive archive(lengths.bytes());
        Eigen::MatrixXd matrix;
        CHECK_THROWS_WITH(archive(matrix), Contains("a matrix is larger"));
    }
    SECTION("of a matrix, below zero") {
        lengths(negative, columns);
        Archive archive(lengths.bytes());
        Eigen::MatrixXd matrix;
        CHECK_THROWS_WITH(archive(matrix), Contains("a matrix is larger"));
    }
    SECTION("of a matrix of another shape") {
        Eigen::MatrixXd four = Eigen::MatrixXd::Zero(2, 2);
        lengths(four);
        Archive archive(lengths.bytes());
        Eigen::Matrix3d nine;
        CHECK_THROWS_WITH(archive(nine), Contains("another shape"));
    }
    SECTION("of a yes or no") {
        std::uint8_t two = 2;
        lengths(two);
        Archive archive(lengths.bytes());
        bool flag = false;
        CHECK_THROWS_WITH(archive(flag), Contains("neither"));
    }
}

TEST_CASE("a mark must be found again") {
    Archive archive;
    archive.mark("state");
    Archive same(archive.bytes());
    CHECK_NOTHROW(same.mark("state"));
    Archive other(archive.bytes());
    CHECK_THROWS_WITH(other.mark("list"), Contains("'list' was expected, and something else was found"));
}

TEST_CASE("an archive that passes its bytes on has those of one in memory, and is read in the same way") {
    const std::vector<std::byte> bytes = written(example());
    std::vector<double> many(100'000, 0.5);
    Archive in_memory;
    Everything all = example();
    in_memory(all, many, all);
    std::vector<std::byte> passed_on;
    std::size_t calls = 0;
    Archive through([&](std::span<const std::byte> piece) {
        passed_on.insert(passed_on.end(), piece.begin(), piece.end());
        ++calls;
    });
    through(all, many, all);
    through.flush();
    CHECK(std::ranges::equal(passed_on, in_memory.bytes()));
    CHECK(calls == 3);  // small values together, the long list by itself

    std::size_t next = 0;
    Archive back(passed_on.size(), [&](std::span<std::byte> piece) {
        std::copy_n(passed_on.begin() + static_cast<std::ptrdiff_t>(next), piece.size(), piece.begin());
        next += piece.size();
    });
    Everything first;
    Everything last;
    std::vector<double> list;
    back(first, list);
    CHECK(back.left() == bytes.size());
    back(last);
    CHECK_NOTHROW(back.expect_end());
    CHECK(list == many);
    CHECK(written(last) == bytes);
    CHECK_THROWS_WITH(back(last), Contains("ends too early"));
}
