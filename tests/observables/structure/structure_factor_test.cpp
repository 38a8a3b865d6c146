#include "observables/structure/structure_factor.hpp"

#include <cmath>
#include <numbers>
#include "catch.hpp"

#include "core/through_archive.hpp"
#include "execution/test_execution.hpp"
#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

using std::numbers::pi;
using Method = StructureFactor::Method;

DataTable measured(const State& state, double k_max, double width, Method method) {
    StructureFactor s(state.box(), k_max, width, method, Every(1));
    s.sample(state, {});
    return s.tables().at(0);
}

/// k, S and number of vectors of each shell, by sums over all atoms and the half of all wave vectors that comes last.
std::vector<std::vector<double>> by_definition(const State& state, double k_max, double width) {
    std::vector<std::vector<double>> shells(static_cast<std::size_t>(k_max / width) + 1, {0.0, 0.0, 0.0});
    const Vec3 unit = 2.0 * pi / state.box().edges().array();
    const int most = 20;
    for (int x = -most; x <= most; ++x) {
        for (int y = -most; y <= most; ++y) {
            for (int z = -most; z <= most; ++z) {
                const Vec3 k = Vec3(x, y, z).cwiseProduct(unit);
                const bool of_half = std::array{z, y, x} > std::array{0, 0, 0};
                if (!of_half || k.norm() > k_max) {
                    continue;
                }
                std::complex<double> sum = 0.0;
                for (Index i = 0; i < state.count(); ++i) {
                    sum += std::polar(1.0, -k.dot(state.positions().col(i)));
                }
                auto& shell = shells[static_cast<std::size_t>(k.norm() / width)];
                shell[0] += k.norm();
                shell[1] += std::norm(sum) / static_cast<double>(state.count());
                shell[2] += 1.0;
            }
        }
    }
    std::erase_if(shells, [](const auto& shell) { return shell[2] == 0.0; });
    for (auto& shell : shells) {
        shell[0] /= shell[2];
        shell[1] /= shell[2];
    }
    return shells;
}

}  // namespace

TEST_CASE("the structure factor is the mean over all wave vectors of a shell, by sums and by the grid") {
    const Method method = GENERATE(Method::direct, Method::grid);
    const Vec3 edges = GENERATE(Vec3(5.0, 5.0, 5.0), Vec3(4.0, 5.5, 7.0));
    const State state = test::random_state(30, Box(edges), 4);
    const auto expected = by_definition(state, 6.3, 0.17);
    const DataTable table = measured(state, 6.3, 0.17, method);
    CHECK(table.name == "sk");
    REQUIRE(table.rows.size() == expected.size());
    for (std::size_t row = 0; row < expected.size(); ++row) {
        CHECK(table.rows[row][0] == Approx(expected[row][0]).epsilon(1e-12));
        CHECK(table.rows[row][1] == Approx(expected[row][1]).epsilon(1e-10).margin(1e-10));
        CHECK(table.rows[row][3] == expected[row][2]);
    }
}

TEST_CASE("a crystal scatters at its reciprocal lattice alone") {
    const State crystal = test::crystal_state(Lattice::fcc, 3, cubic_box(108, 1.0));
    const double cell = crystal.box().edges()[0] / 3.0;
    const double first = std::sqrt(3.0) * 2.0 * pi / cell;  // (111)
    const double second = 2.0 * 2.0 * pi / cell;            // (200)
    // A width that tells wave vectors of different lengths apart: N for the 8/2 and 6/2 vectors, zero elsewhere.
    for (const auto& row : measured(crystal, 1.05 * second, 1e-3, Method::grid).rows) {
        const bool peak = std::abs(row[0] - first) < 1e-9 || std::abs(row[0] - second) < 1e-9;
        const double others = std::abs(row[0] - second) < 1e-9 ? row[3] - 3.0 : row[3] - 4.0;
        CHECK(row[1] == Approx(peak ? 108.0 * (row[3] - others) / row[3] : 0.0).margin(1e-9));
    }
}

TEST_CASE("the structure factor of an ideal gas is 1 within its errors") {
    StructureFactor s(Box(Vec3::Constant(5.0)), 8.0, 0.5, Method::grid, Every(1));
    for (std::uint64_t k = 0; k < 400; ++k) {
        s.sample(test::random_state(40, Box(Vec3::Constant(5.0)), k), {});
    }
    CHECK(s.samples() == 400);
    const DataTable table = s.tables().at(0);
    for (const auto& row : table.rows) {
        CHECK(std::abs(row[1] - 1.0) < 4.0 * row[2]);
        CHECK(row[2] == Approx(1.0 / std::sqrt(400.0 * row[3])).epsilon(0.3));
    }
}

TEST_CASE("threads and archives change no bit of a structure factor") {
    const Method method = GENERATE(Method::direct, Method::grid);
    const Box box(Vec3(6.0, 7.0, 8.0));
    const auto rows = [&](int threads, std::uint64_t archived_at) {
        auto s = std::make_unique<StructureFactor>(box, 9.0, 0.2, method, Every(1));
        for (std::uint64_t k = 0; k < 6; ++k) {
            if (k == archived_at) {
                auto restored = std::make_unique<StructureFactor>(box, 9.0, 0.2, method, Every(1));
                test::through_archive(*s, *restored);
                s = std::move(restored);
            }
            s->sample(test::random_state(200, box, k, test::with_threads(threads)), {});
        }
        return s->tables().at(0).rows;
    };
    const auto whole = rows(1, 6);
    CHECK(rows(3, 6) == whole);
    CHECK(rows(1, 0) == whole);
    CHECK(rows(1, 3) == whole);
}

TEST_CASE("a box without wave vectors is refused") {
    CHECK_THROWS_AS(StructureFactor(Box(Vec3::Constant(2.0)), 3.0, 0.1, Method::direct, Every(1)), ContractViolation);
    CHECK_THROWS_AS(StructureFactor(Box(Vec3::Constant(2.0)), 4.0, 0.0, Method::direct, Every(1)), ContractViolation);
}
