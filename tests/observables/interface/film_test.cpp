#include "observables/interface/film.hpp"

#include <map>
#include <random>
#include "catch.hpp"

#include "neighbors/sample_states.hpp"

using namespace ljmd;
using Catch::Contains;

namespace {

const Box box(Vec3(10.0, 10.0, 40.0));
const Interaction shifted{PairPotential::lennard_jones("shifted", {2.5, 0.0}), TailCorrection()};

std::map<std::string, ObservableAverage> by_name(const Film& film) {
    std::map<std::string, ObservableAverage> found;
    for (const ObservableAverage& average : film.observables()) {
        found.emplace(average.name, average);
    }
    return found;
}

/// Atoms of an ideal liquid 12 sigma thick, whose middle moves about, in a vapour. They are too far from each other to
/// overlap only by luck, so their pressures mean nothing.
State film_state(unsigned seed, Index liquid, Index vapour) {
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const double middle = 40.0 * uniform(generator);
    std::vector<Vec3> positions;
    for (Index i = 0; i < liquid + vapour; ++i) {
        const double z =
            i < liquid ? middle + 12.0 * (uniform(generator) - 0.5) : middle + 6.0 + 28.0 * uniform(generator);
        positions.emplace_back(10.0 * uniform(generator), 10.0 * uniform(generator), z - 40.0 * std::floor(z / 40.0));
    }
    State state = test::state_of(positions, box);
    state.wrap();
    return state;
}

void check_none(const Film& film, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        CAPTURE(name);
        const ObservableAverage found = by_name(film).at(name);
        CHECK_FALSE(found.estimate);
        CHECK(found.remark == "no layer of liquid and layer of vapour can be told apart");
    }
}

/// The same with the surfaces normal to an axis.
State along(Index axis, const State& film) {
    const auto turned = [axis](Vec3 r) {
        std::swap(r[axis], r[2]);
        return r;
    };
    std::vector<Vec3> positions;
    for (Index i = 0; i < film.count(); ++i) {
        positions.push_back(turned(film.positions().col(i)));
    }
    return test::state_of(positions, Box(turned(film.box().edges())));
}

}  // namespace

TEST_CASE("the surface tension is that of two surfaces, from the virial alone") {
    const Index axis = GENERATE(0, 1, 2);
    const State state = along(axis, film_state(1, 480, 112));
    Film film(shifted, state.box(), axis, 40, Every(5));
    CHECK(film.due(10));
    CHECK_FALSE(film.due(12));
    Evaluation evaluation;
    for (const double normal : {3.0, 5.0, 4.0, 4.0}) {
        evaluation.virial = Vec3(1.0, 1.0, 1.0).asDiagonal();
        evaluation.virial(axis, axis) = normal;
        film.sample(state, evaluation);
    }
    const Estimate tension = by_name(film).at("surface_tension").estimate.value();
    CHECK(tension.mean == Approx(0.5 * 40.0 * 3.0 / 4000.0));
    CHECK(tension.standard_error > 0.0);
}

TEST_CASE("densities of liquid and vapour are found where the film is") {
    Film film(shifted, box, 2, 80, Every(1));
    for (unsigned seed = 0; seed < 64; ++seed) {
        film.sample(film_state(seed, 480, 112), {});
    }
    const auto found = by_name(film);
    const Estimate liquid = found.at("liquid_density").estimate.value();
    const Estimate vapour = found.at("vapour_density").estimate.value();
    CHECK(liquid.mean == Approx(480.0 / 1200.0).epsilon(0.02));
    CHECK(vapour.mean == Approx(112.0 / 2800.0).epsilon(0.05));
    CHECK(liquid.standard_error == Approx(0.003).epsilon(0.5));  // 240 of 480 atoms, binomial, in 64 samples
    const DataTable table = film.tables().at(0);
    REQUIRE(table.rows.size() == 80);
    CHECK(table.rows.front()[0] == Approx(-19.75));
    CHECK(table.rows.back()[0] == Approx(19.75));
    CHECK(table.rows[40][1] == Approx(0.4).epsilon(0.1));
    CHECK(table.rows[2][1] == Approx(0.04).epsilon(0.3));
}

TEST_CASE("where there is no film there are no densities, no tension and no pressure of one") {
    const std::vector<std::string> all{"liquid_density", "vapour_density", "surface_tension", "normal_pressure"};
    Film film(shifted, box, 2, 80, Every(1));
    SECTION("a gas") {
        for (unsigned seed = 0; seed < 16; ++seed) {
            film.sample(test::random_state(400, box, seed), {});
        }
    }
    SECTION("two films so close that their middle is empty") {
        std::mt19937_64 generator(3);
        std::uniform_real_distribution<double> uniform(1.0, 6.0);
        for (int n = 0; n < 16; ++n) {
            std::vector<Vec3> positions;
            for (int i = 0; i < 400; ++i) {
                const double z = uniform(generator);
                positions.emplace_back(uniform(generator), uniform(generator), 20.0 + (i % 2 == 0 ? z : -z));
            }
            film.sample(test::state_of(positions, box), {});
        }
    }
    SECTION("a film with next to no room for vapour") {
        for (unsigned seed = 0; seed < 16; ++seed) {
            State state = test::random_state(400, box, seed);
            auto r = state.write_positions();
            r.row(2) *= 38.0 / 40.0;
            for (Index i = 0; i < state.count(); ++i) {
                r.col(i) = state.snapped(r.col(i));
            }
            film.sample(state, {});
        }
        check_none(film, {"vapour_density", "surface_tension", "normal_pressure"});
        return;
    }
    SECTION("a film seen along its surfaces") {
        Film across(shifted, box, 0, 80, Every(1));
        for (unsigned seed = 0; seed < 16; ++seed) {
            film.sample(film_state(seed, 480, 112), {});
            across.sample(film_state(seed, 480, 112), {});
        }
        CHECK(by_name(film).at("surface_tension").estimate);
        check_none(across, all);
        return;
    }
    check_none(film, all);
}

TEST_CASE("a tail correction leaves the tension without a value, and so does a single atom") {
    const PairPotential cut = PairPotential::lennard_jones("cut", {2.5, 0.0});
    Film with_tail({cut, TailCorrection(cut)}, box, 2, 10, Every(1));
    with_tail.sample(test::random_state(4, box, 1), {});
    CHECK_FALSE(by_name(with_tail).at("surface_tension").estimate);
    CHECK_THAT(by_name(with_tail).at("surface_tension").remark, Contains("homogeneous"));

    Film one(shifted, box, 2, 10, Every(1));
    CHECK(one.observables().empty());
    one.sample(test::random_state(1, box, 1), {});
    CHECK(one.samples() == 1);
    CHECK(one.tables().empty());
    CHECK_THAT(by_name(one).at("surface_tension").remark, Contains("single atom"));
}

TEST_CASE("where the vapour's density is a guess, so is what follows from how many atoms are in the liquid") {
    const auto average = [](const std::string& name, bool converged) {
        return ObservableAverage{name, "", "", Estimate{1.0, 0.1, 20.0, 100, converged}};
    };
    const auto sure_of = [&](bool vapour) {
        std::vector<ObservableAverage> all{average("temperature", true),     average("potential_energy", true),
                                           average("total_energy", true),    average("heat_capacity_cv", true),
                                           average("surface_tension", true), average("liquid_density", true),
                                           average("vapour_density", vapour)};
        mark_slow_exchange(all);
        std::vector<std::string> sure;
        for (const ObservableAverage& each : all) {
            if (each.estimate->converged) {
                sure.push_back(each.name);
            }
        }
        return sure;
    };
    CHECK(sure_of(true).size() == 7);
    CHECK(sure_of(false) == std::vector<std::string>{"temperature", "surface_tension"});
    std::vector<ObservableAverage> no_film{average("potential_energy", true)};
    mark_slow_exchange(no_film);
    CHECK(no_film[0].estimate->converged);
}
