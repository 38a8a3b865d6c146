#include "ljmd/model/box.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <vector>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Int3 = Eigen::Matrix<Index, 3, 1>;

/// Coordinates in units of the grid: exact for every grid point, because the spacing is a power of two.
Int3 in_grid_units(const Vec3& r, const Box& box) {
    return (r / box.resolution()).cast<Index>();
}

bool on_grid(const Vec3& r, const Box& box) {
    const Vec3 units = r / box.resolution();
    return units == Vec3(units.array().rint());
}

/// Edges of every size and shape: random ones, elongated ones, and those at the two places where the grid changes,
/// powers of two and two thirds of them, with their neighbours among the doubles.
std::vector<Vec3> many_edges() {
    std::vector<Vec3> all;
    std::mt19937_64 generator(11);
    std::uniform_real_distribution<double> exponent(-6.0, 14.0);
    for (int k = 0; k < 300; ++k) {
        const double edge = std::exp2(exponent(generator));
        all.push_back(Vec3::Constant(edge));
        all.push_back({edge, std::exp2(exponent(generator)), std::exp2(exponent(generator))});
    }
    for (const double power : {0.125, 1.0, 8.0, 16.0, 1024.0}) {
        for (const double edge : {power, power / 1.5, power * 1.5}) {
            double below = edge;
            double above = edge;
            for (int k = 0; k < 4; ++k) {
                all.push_back({below, above, edge});
                below = std::nextafter(below, 0.0);
                above = std::nextafter(above, infinity);
                all.push_back({below, below, below});
                all.push_back({above, above, above});
                all.push_back({above, 0.37 * below, 1e-6 * edge});
            }
        }
    }
    return all;
}

/// A point of the grid inside the box; every few times one at a wall.
Vec3 grid_point(const Box& box, std::mt19937_64& generator) {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    Vec3 r;
    for (int a = 0; a < 3; ++a) {
        const double choice = uniform(generator);
        r[a] = choice < 0.1   ? 0.0
               : choice < 0.2 ? box.edges()[a] - box.resolution()
                              : uniform(generator) * box.edges()[a];
    }
    r = box.snap(r);
    return r - box.crossings(r).cwiseProduct(box.edges());
}

/// Whole numbers of edges, each from -low to high.
Vec3 shift(int low, int high, std::mt19937_64& generator) {
    std::uniform_int_distribution<int> uniform(-low, high);
    return Vec3(uniform(generator), uniform(generator), uniform(generator));
}

}  // namespace

TEST_CASE("the grid: a power of two above 1.5 L 2^-52, on which the edges lie") {
    for (const Vec3& given : many_edges()) {
        const Box box(given);
        const double g = box.resolution();
        CAPTURE(given.transpose(), g);
        int exponent = 0;
        REQUIRE(std::frexp(g, &exponent) == 0.5);
        const double reach = 1.5 * given.maxCoeff();
        REQUIRE(0x1p52 * g > reach);
        REQUIRE(0x1p51 * g <= reach);
        REQUIRE(on_grid(box.edges(), box));
        REQUIRE((box.edges() - given).cwiseAbs().maxCoeff() <= 0.5 * g);
        REQUIRE((box.edges() - given).cwiseAbs().maxCoeff() < 1e-15 * given.maxCoeff());
        REQUIRE(Box(box.edges()).edges() == box.edges());  // what a file gives back is the same box
    }
}

TEST_CASE("a periodic image is the atom plus whole edges to the last bit, and separations are antisymmetric") {
    std::mt19937_64 generator(12);
    for (const Vec3& given : many_edges()) {
        const Box box(given);
        const Int3 edges = in_grid_units(box.edges(), box);
        int wrong = 0;
        for (int k = 0; k < 100; ++k) {
            const Vec3 a = grid_point(box, generator);
            const Vec3 b = grid_point(box, generator);
            const Vec3 n = shift(2, 1, generator);
            const Vec3 image_of_a = a + n.cwiseProduct(box.edges());
            const Vec3 image_of_b = b - n.cwiseProduct(box.edges());
            const Int3 exact = in_grid_units(a, box) + n.cast<Index>().cwiseProduct(edges);
            const bool image_is_exact = in_grid_units(image_of_a, box) == exact && on_grid(image_of_a, box);
            const Vec3 seen_from_a = image_of_b - a;
            const Vec3 seen_from_b = image_of_a - b;
            const bool separation_is_exact = in_grid_units(seen_from_b, box) == exact - in_grid_units(b, box);
            wrong += !(image_is_exact && separation_is_exact && seen_from_a == -seen_from_b);
        }
        CAPTURE(given.transpose());
        REQUIRE(wrong == 0);
    }
}

TEST_CASE("wrapping a point of the grid within 3 L is exact") {
    std::mt19937_64 generator(13);
    for (const Vec3& given : many_edges()) {
        const Box box(given);
        int wrong = 0;
        for (int k = 0; k < 100; ++k) {
            const Vec3 inside = grid_point(box, generator);
            const Vec3 n = shift(3, 2, generator);
            const Vec3 r = inside + n.cwiseProduct(box.edges());
            wrong += box.crossings(r) != n || r - n.cwiseProduct(box.edges()) != inside;
        }
        CAPTURE(given.transpose());
        REQUIRE(wrong == 0);
    }
}

TEST_CASE("crossings at the walls") {
    for (const Vec3& given : many_edges()) {
        const Box box(given);
        for (int a = 0; a < 3; ++a) {
            const double edge = box.edges()[a];
            const double g = box.resolution();
            const struct {
                double r, crossings;
            } cases[] = {
                {0.0, 0.0},
                {-0.0, 0.0},
                {edge, 1.0},
                {std::nextafter(edge, 0.0), 0.0},
                {edge - g, 0.0},
                {edge + g, 1.0},
                {-g, -1.0},
                {-edge, -1.0},
                {-edge - g, -2.0},
                {-edge + g, -1.0},
                {2.0 * edge, 2.0},
                {2.0 * edge - g, 1.0},
                {3.0 * edge - g, 2.0},
                {-3.0 * edge, -3.0},
            };
            for (const auto& c : cases) {
                CAPTURE(given.transpose(), a, c.r / edge);
                const double found = box.crossings(Vec3::Unit(a) * c.r)[a];
                REQUIRE(found == c.crossings);
                REQUIRE(c.r - found * edge >= 0.0);
                REQUIRE(c.r - found * edge < edge);
            }
        }
    }
}

TEST_CASE("crossings where the division alone rounds to the wrong side") {
    const struct {
        double edge;
        double r;  // in edges, before the step to the neighbouring double
        double direction;
        double division, crossings;
    } cases[] = {
        {1.1, 7.0, 0.0, 7.0, 6.0},
        {1.1, -5.0, -infinity, -5.0, -6.0},
        {1.2, -55.0, -55.0 * Box(Vec3::Constant(1.2)).edges()[0], -56.0, -55.0},  // no step
    };
    for (const auto& c : cases) {
        const Box box(Vec3::Constant(c.edge));
        const double r = std::nextafter(c.r * box.edges()[0], c.direction);
        CAPTURE(c.edge, c.r);
        REQUIRE(std::floor(r / box.edges()[0]) == c.division);
        CHECK(box.crossings(Vec3::Constant(r)) == Vec3::Constant(c.crossings));
    }
}

TEST_CASE("far outside, wrapping misses the box by rounding at most") {
    std::mt19937_64 generator(14);
    std::uniform_real_distribution<double> exponent(0.0, 6.0);
    for (const Vec3& given : many_edges()) {
        const Box box(given);
        const double n = std::floor(std::pow(10.0, exponent(generator)));
        for (const double far : {n, -n}) {
            Vec3 r = far * box.edges();
            r[1] = std::nextafter(r[1], infinity);
            r[2] = std::nextafter(r[2], -infinity);
            const Vec3 inside = r - box.crossings(r).cwiseProduct(box.edges());
            const double rounding = 0x1p-52 * n * box.edges().maxCoeff();
            CAPTURE(given.transpose(), far);
            REQUIRE(inside.minCoeff() >= -rounding);
            REQUIRE((inside - box.edges()).maxCoeff() <= rounding);
        }
    }
}

TEST_CASE("snap takes the nearest point of the grid, ties to even") {
    std::mt19937_64 generator(15);
    std::uniform_real_distribution<double> uniform(-0.3, 1.1);
    for (const Vec3& given : many_edges()) {
        const Box box(given);
        const double g = box.resolution();
        int wrong = 0;
        for (int k = 0; k < 100; ++k) {
            const Vec3 r = box.edges().cwiseProduct(Vec3(uniform(generator), uniform(generator), uniform(generator)));
            const Vec3 snapped = box.snap(r);
            const Vec3 nearest = g * Vec3((r / g).array().rint());  // the division is exact, rint takes ties to even
            wrong += snapped != nearest || box.snap(snapped) != snapped;
        }
        const double even = 2.0 * std::floor(box.edges().minCoeff() / (16.0 * g));
        const Vec3 ties(even + 0.5, even + 1.5, -even - 0.5);
        CAPTURE(given.transpose());
        REQUIRE(wrong == 0);
        REQUIRE(box.snap(g * ties) == g * Vec3(even, even + 2.0, -even));
    }
}

TEST_CASE("the minimum image is the shortest, and antisymmetric") {
    std::mt19937_64 generator(16);
    for (const Vec3& given : many_edges()) {
        const Box box(given);
        int wrong = 0;
        for (int k = 0; k < 100; ++k) {
            const Vec3 d = grid_point(box, generator) - grid_point(box, generator);
            const Vec3 found = box.minimum_image(d);
            for (int a = 0; a < 3; ++a) {
                const double edge = box.edges()[a];
                const double shortest = std::min({std::abs(d[a]), std::abs(d[a] - edge), std::abs(d[a] + edge)});
                const double edges_taken = std::round((d[a] - found[a]) / edge);
                wrong +=
                    std::abs(found[a]) != shortest || 2.0 * shortest > edge || found[a] + edges_taken * edge != d[a];
            }
            wrong += box.minimum_image(-d) != -found;
        }
        CAPTURE(given.transpose());
        REQUIRE(wrong == 0);
    }
    const Box box(Vec3(8.0, 10.0, 12.0));
    CHECK(box.minimum_image({4.0, -5.0, 6.0}) == Vec3(4.0, -5.0, 6.0));  // half an edge stays on its side
    CHECK(box.minimum_image({4.5, -5.5, 0.0}) == Vec3(-3.5, 4.5, 0.0));
    CHECK(box.minimum_image({7.75, -9.75, 11.0}) == Vec3(-0.25, 0.25, -1.0));
}

TEST_CASE("volume and shortest edge") {
    const Box box(Vec3(8.0, 5.0, 12.5));
    CHECK(box.edges() == Vec3(8.0, 5.0, 12.5));
    CHECK(box.volume() == 500.0);
    CHECK(box.shortest_edge() == 5.0);
}

TEST_CASE("a box needs finite, positive edges") {
    for (const double wrong : {0.0, -0.0, -1.0, infinity, -infinity, std::nan("")}) {
        for (int a = 0; a < 3; ++a) {
            Vec3 edges(3.0, 4.0, 5.0);
            edges[a] = wrong;
            CHECK_THROWS_AS(Box(edges), InputError);
        }
    }
    CHECK_THROWS_AS(Box(Vec3(1e17, 1.0, 1.0)), InputError);  // 1 is below half the grid spacing
    CHECK_THROWS_AS(Box(Vec3::Constant(1.7e308)), InputError);
    CHECK_THROWS_AS(Box(Vec3::Constant(1e-310)), InputError);
    CHECK(Box(Vec3(1e6, 1.0, 1.0)).edges() == Vec3(1e6, 1.0, 1.0));
}
