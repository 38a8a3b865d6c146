#include "observables/transport/mean_square_displacement.hpp"

#include <numeric>
#include <random>
#include "catch.hpp"

#include "core/through_archive.hpp"
#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

constexpr LagTimes lags{.every = 4, .count = 12, .spacing = 0.1};
constexpr double from_half = 0.6;

MeanSquareDisplacement displacement_of(Index atoms, Index origins, double fit_start = from_half) {
    return {atoms, lags, origins, fit_start};
}

/// Atoms that go on from step to step by independent normal displacements: msd = 6 D t.
class Walk {
  public:
    Walk(Index atoms, double diffusion, unsigned seed)
        : length_(std::sqrt(2.0 * diffusion * lags.spacing)),
          generator_(seed),
          state_(test::random_state(atoms, Box(Vec3::Constant(6.0)), 1)) {}

    const State& next() {
        auto r = state_.write_positions();
        for (Index i = 0; i < state_.count(); ++i) {
            r.col(i) += length_ * Vec3(normal_(generator_), normal_(generator_), normal_(generator_));
            r.col(i) = state_.snapped(r.col(i));
        }
        state_.wrap();
        std::vector<Index> order(static_cast<std::size_t>(state_.count()));
        std::iota(order.begin(), order.end(), 0);
        std::shuffle(order.begin(), order.end(), generator_);
        state_.reorder(order);
        return state_;
    }

  private:
    double length_;
    std::mt19937_64 generator_;
    std::normal_distribution<double> normal_;
    State state_;
};

/// About the centre of mass.
Eigen::Matrix3Xd unwrapped_by_id(const State& state) {
    Eigen::Matrix3Xd r(3, state.count());
    for (Index i = 0; i < state.count(); ++i) {
        r.col(state.ids()[static_cast<std::size_t>(i)]) = state.unwrapped(i);
    }
    return r.colwise() - r.rowwise().mean();
}

}  // namespace

TEST_CASE("displacements are those from the time origins, through walls and whatever the order of atoms") {
    const Index origins = GENERATE(1, 3, 5, 12, 50);
    const Index between = std::max<Index>((12 + origins - 1) / origins, 1);
    CAPTURE(origins, between);
    constexpr Index frames = 40;
    MeanSquareDisplacement msd = displacement_of(20, origins);
    Walk walk(20, 1.5, 2);
    std::vector<Eigen::Matrix3Xd> seen;
    for (Index t = 0; t < frames; ++t) {
        const State& state = walk.next();
        seen.push_back(unwrapped_by_id(state));
        msd.sample(state, {});
        CHECK(msd.tables().empty() == (t < 12));
    }
    const DataTable table = msd.tables().at(0);
    CHECK(table.name == "msd");
    REQUIRE(table.rows.size() == 13);
    for (Index k = 0; k <= 12; ++k) {
        double sum = 0.0;
        Index count = 0;
        for (Index t = 0; t + 12 < frames; t += between) {
            const auto origin = static_cast<std::size_t>(t);
            sum += (seen[origin + static_cast<std::size_t>(k)] - seen[origin]).squaredNorm() / 20.0;
            ++count;
        }
        const auto& row = table.rows[static_cast<std::size_t>(k)];
        CHECK(row[0] == Approx(0.1 * static_cast<double>(k)));
        CHECK(row[1] == Approx(sum / static_cast<double>(count)).margin(1e-12));
    }
}

TEST_CASE("a random walk has the diffusion it was made with, but for that of the centre of mass") {
    constexpr double walked = 0.4;
    constexpr double diffusion = walked * (1.0 - 1.0 / 100.0);
    MeanSquareDisplacement msd = displacement_of(100, 12);
    Walk walk(100, walked, 3);
    for (int t = 0; t < 4000; ++t) {
        msd.sample(walk.next(), {});
    }
    CHECK(msd.samples() == 4000);
    const auto found = msd.observables();
    REQUIRE(found.size() == 1);
    CHECK(found[0].name == "diffusion");
    CHECK(found[0].unit == "sigma^2/tau");
    CHECK(std::abs(found[0].estimate->mean - diffusion) < 3.0 * found[0].estimate->standard_error);
    CHECK(found[0].estimate->standard_error < 0.01);
    const DataTable table = msd.tables().at(0);
    for (const auto& row : table.rows) {
        CHECK(std::abs(row[1] - 6.0 * diffusion * row[0]) <= 4.0 * row[2]);
    }
}

TEST_CASE("diffusion is the slope from the start of the fit on: straight flight has twice its time") {
    // msd = v^2 t^2; the least-squares line through points from t1 to t2 has the slope v^2 (t1 + t2).
    const double start = GENERATE(0.0, 0.6, 0.61, 1.1);
    const double first = start == 0.61 ? 0.7 : start;
    MeanSquareDisplacement msd = displacement_of(2, 1, start);
    State state = test::random_state(2, Box(Vec3::Constant(6.0)), 1);
    const Eigen::Matrix3Xd begin = state.positions();
    const Vec3 velocity(3.0, -1.0, 2.0);
    for (int t = 0; t <= 12; ++t) {
        state.write_positions().col(0) = begin.col(0) + velocity * (0.1 * t);
        state.write_positions().col(1) = begin.col(1) - velocity * (0.1 * t);
        msd.sample(state, {});
    }
    CHECK(msd.observables().at(0).estimate->mean == Approx(14.0 * (first + 1.2) / 6.0).epsilon(1e-9));
}

TEST_CASE("a frame that moves, however it does, sees the same displacements") {
    const auto seen_from = [](const auto& place) {
        MeanSquareDisplacement msd = displacement_of(20, 5);
        Walk walk(20, 1.5, 4);
        for (int t = 0; t < 60; ++t) {
            State state = walk.next();
            state.write_positions().colwise() += place(0.1 * t);
            msd.sample(state, {});
        }
        return msd;
    };
    const MeanSquareDisplacement still = seen_from([](double) -> Vec3 { return Vec3::Zero(); });
    const MeanSquareDisplacement moving = seen_from([](double t) -> Vec3 { return Vec3(7.0, -3.0, 0.5 * t) * t; });
    CHECK(moving.observables().at(0).estimate->mean == Approx(still.observables().at(0).estimate->mean).epsilon(1e-9));
    for (std::size_t k = 0; k < still.tables().at(0).rows.size(); ++k) {
        CHECK(moving.tables().at(0).rows[k][1] == Approx(still.tables().at(0).rows[k][1]).margin(1e-10));
    }
}

TEST_CASE("a single atom has no diffusion, because it is its own centre of mass") {
    MeanSquareDisplacement msd = displacement_of(1, 1);
    Walk walk(1, 1.5, 4);
    for (int t = 0; t <= 12; ++t) {
        msd.sample(walk.next(), {});
    }
    CHECK_FALSE(msd.observables().at(0).estimate.has_value());
    CHECK(msd.observables().at(0).remark == "a single atom has no motion about the centre of mass");
}

TEST_CASE("displacements go on from an archive bit for bit, and begin anew where they are interrupted") {
    const Index origins = GENERATE(1, 5, 12);
    const auto sampled = [origins](int first, int archived_at) {
        auto msd = std::make_unique<MeanSquareDisplacement>(displacement_of(20, origins));
        Walk walk(20, 1.5, 4);
        for (int t = 0; t < 60; ++t) {
            if (t == first) {
                msd->interrupt();
            }
            if (t == archived_at) {
                auto restored = std::make_unique<MeanSquareDisplacement>(displacement_of(20, origins));
                test::through_archive(*msd, *restored);
                msd = std::move(restored);
            }
            msd->sample(walk.next(), {});
        }
        return msd->tables().at(0).rows;
    };
    const auto whole = sampled(-1, -1);
    for (const int step : {0, 1, 11, 12, 13, 14, 40}) {
        CAPTURE(step);
        CHECK(sampled(-1, step) == whole);
    }
    CHECK(sampled(0, -1) == whole);
    CHECK(sampled(10, -1) != whole);
}

TEST_CASE("an archive of other displacements is refused") {
    MeanSquareDisplacement msd = displacement_of(20, 5);
    Walk walk(20, 1.5, 5);
    for (int t = 0; t < 20; ++t) {
        msd.sample(walk.next(), {});
    }
    const auto read_by = [&msd](MeanSquareDisplacement other) { test::through_archive(msd, other); };
    CHECK_NOTHROW(read_by(displacement_of(20, 5)));
    CHECK_THROWS_AS(read_by(displacement_of(21, 5)), CheckpointError);
    CHECK_THROWS_AS(read_by(displacement_of(20, 12)), CheckpointError);
    CHECK_THROWS_AS(read_by(displacement_of(20, 1)), CheckpointError);
    CHECK_THROWS_AS(read_by({20, {.every = 4, .count = 11, .spacing = 0.1}, 5, from_half}), CheckpointError);
}

TEST_CASE("a fit needs two times") {
    CHECK_THROWS_AS(displacement_of(20, 5, 1.2), ContractViolation);
    CHECK_NOTHROW(displacement_of(20, 5, 1.1));
}
