// Forces do not depend on where the box begins, which image an atom is, how axes are called, or in which order atoms
// are numbered.
#include <algorithm>
#include <functional>
#include <numeric>
#include <random>
#include "catch.hpp"

#include "physics/liquid.hpp"

using namespace ljmd;

namespace {

using Vectors = Eigen::Matrix3Xd;

Vectors forces_by_id(const Vectors& positions, const Box& box, const std::string& search) {
    State state(positions.cols(), box, test::test_execution());
    for (Index i = 0; i < state.count(); ++i) {
        const Vec3 n = box.crossings(positions.col(i));
        state.write_positions().col(i) = box.snap(positions.col(i) - n.cwiseProduct(box.edges()));
    }
    auto force_field = test::lennard_jones("cut", search);
    force_field.evaluate(state, Request::forces);
    return test::by_id(state, state.forces());
}

}  // namespace

TEST_CASE("forces follow translation, wrapping, mirroring, exchange of axes and renumbering") {
    const State liquid = test::liquid(4, 5);
    const Box box = liquid.box();
    const Vectors start = test::by_id(liquid, liquid.positions());
    std::mt19937_64 generator(3);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);

    for (const std::string search : {"verlet-list", "cells", "all-pairs"}) {
        const Vectors reference = forces_by_id(start, box, search);
        const auto check = [&](const Vectors& moved, const std::function<Vectors(const Vectors&)>& back) {
            CHECK(test::largest_difference_over_rms(back(forces_by_id(moved, box, search)), reference) < 1e-12);
        };
        const auto same = [](const Vectors& f) { return f; };

        SECTION(search + ": translation") {
            for (int k = 0; k < 5; ++k) {
                const Vec3 shift = box.snap(Vec3(uniform(generator), uniform(generator), uniform(generator)));
                check(start.colwise() + shift, same);
            }
        }
        SECTION(search + ": whole edges") {
            Vectors moved = start;
            for (Index i = 0; i < moved.cols(); ++i) {
                moved.col(i) +=
                    Vec3(static_cast<double>(i % 5 - 2), static_cast<double>(i % 3 - 1), 1.0) * box.edges()[0];
            }
            check(moved, same);
        }
        SECTION(search + ": mirror") {
            const auto mirror = [](const Vectors& r) { return Vectors(Vec3(-1.0, 1.0, 1.0).asDiagonal() * r); };
            check(mirror(start), mirror);
        }
        SECTION(search + ": exchange of axes") {
            const auto exchange = [](const Vectors& r) {
                Vectors swapped = r;
                swapped.row(0) = r.row(2);
                swapped.row(2) = r.row(0);
                return swapped;
            };
            check(exchange(start), exchange);
        }
        SECTION(search + ": renumbering") {
            std::vector<Index> order(static_cast<std::size_t>(start.cols()));
            std::iota(order.begin(), order.end(), Index{0});
            std::shuffle(order.begin(), order.end(), generator);
            Vectors moved(3, start.cols());
            for (Index i = 0; i < start.cols(); ++i) {
                moved.col(i) = start.col(order[static_cast<std::size_t>(i)]);
            }
            check(moved, [&](const Vectors& f) {
                Vectors back(3, f.cols());
                for (Index i = 0; i < f.cols(); ++i) {
                    back.col(order[static_cast<std::size_t>(i)]) = f.col(i);
                }
                return back;
            });
        }
    }
}

TEST_CASE("a trajectory does not depend on how pairs are found, up to the order of sums") {
    const State start = test::liquid(4, 6);
    std::vector<Vectors> ends;
    for (const std::string search : {"all-pairs", "cells", "verlet-list"}) {
        State state = start;
        auto force_field = test::lennard_jones("cut", search);
        test::advance(state, force_field, 0.004, 100);
        ends.push_back(test::unwrapped_by_id(state));
    }
    CHECK((ends[1] - ends[0]).colwise().norm().maxCoeff() < 1e-11);
    CHECK((ends[2] - ends[0]).colwise().norm().maxCoeff() < 1e-11);
}
