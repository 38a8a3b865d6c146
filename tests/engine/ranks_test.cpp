#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>
#include "catch.hpp"

#include "engine/engine_fixtures.hpp"
#include "execution/rank_team.hpp"
#include "ljmd/engine/choices.hpp"
#include "ljmd/engine/simulation.hpp"
#include "ljmd/model/lattice.hpp"
#include "model/checksum.hpp"
#include "neighbors/cluster_grid.hpp"

using namespace ljmd;

namespace {

/// What a run leaves, to the last bit.
struct Left {
    std::vector<ThermoRow> rows;
    std::string checkpoint;
    std::string positions;
    Index atoms_here = 0;  ///< the fewest that a rank had at the end
};

Left left_by(Simulation& simulation) {
    Left left{simulation.samples(), simulation.checkpoint(), checksum(simulation.state()), simulation.state().count()};
    return left;
}

Left run_alone(const FluidSpec& spec, ExecutionOptions options = {}) {
    Simulation simulation(spec, Execution(options));
    simulation.run();
    return left_by(simulation);
}

Left run_by(int ranks, const FluidSpec& spec, ExecutionOptions options = {}) {
    Left left;
    test::RankTeam team(ranks);
    std::mutex mutex;
    Index fewest = atoms_of(spec);
    team.run([&](std::shared_ptr<Ranks> here) {
        const bool is_root = here->is_root();
        ExecutionOptions mine = options;
        mine.ranks = std::move(here);
        Simulation simulation(spec, Execution(mine));
        simulation.run();
        Left found = left_by(simulation);
        const std::lock_guard lock(mutex);
        fewest = std::min(fewest, found.atoms_here);
        if (is_root) {
            left = std::move(found);
        }
    });
    left.atoms_here = fewest;
    return left;
}

/// Rows without the names of their values.
std::vector<double> numbers_of(const std::vector<ThermoRow>& rows) {
    std::vector<double> numbers;
    for (const ThermoRow& row : rows) {
        const Thermodynamics& v = row.values;
        for (const double x : {v.potential_energy, v.kinetic_energy, v.total_energy, v.temperature.value_or(-1.0),
                               v.pressure.value_or(-1.0), v.virial, v.density, row.conserved_energy.value_or(-1.0),
                               row.order.value_or(-1.0), row.time}) {
            numbers.push_back(x);
        }
    }
    return numbers;
}

void check_same(const Left& found, const Left& expected) {
    CHECK(numbers_of(found.rows) == numbers_of(expected.rows));
    CHECK(found.positions == expected.positions);
}

FluidSpec liquid(Index cells) {
    FluidSpec spec;
    spec.start = LatticeStart{.cells = cells};
    spec.density = 0.8442;
    spec.temperature = 1.5;
    spec.neighbors.tile = 50;
    spec.stages = {
        {.name = "melt", .time_step = 0.004, .steps = 40, .temperature = 1.5, .thermostat = thermostat("langevin")},
        {.name = "go", .time_step = 0.004, .steps = 60, .sample = true}};
    spec.sample_every = 5;
    return spec;
}

/// What ranks have said to each other after some steps. @param atoms  becomes the number of atoms of each
test::RankTeam::Traffic traffic_of(int size, const FluidSpec& spec, Index steps, std::vector<Index>& atoms) {
    test::RankTeam team(size);
    team.run([&](std::shared_ptr<Ranks> here) {
        const auto rank = static_cast<std::size_t>(here->rank());
        Simulation simulation(spec, Execution(ExecutionOptions{.ranks = std::move(here)}));
        simulation.advance(steps);
        atoms[rank] = simulation.state().count();
    });
    return team.traffic();
}

}  // namespace

TEST_CASE("a step without a new list takes two messages from each rank to each near one, as long at every step") {
    FluidSpec spec = liquid(5);
    spec.neighbors.every = 100;
    spec.sample_every = 1000;
    spec.stages = {{.name = "go", .time_step = 0.004, .steps = 60}};
    const int size = GENERATE(2, 3, 4);
    std::vector<Index> atoms(static_cast<std::size_t>(size));
    const test::RankTeam::Traffic before = traffic_of(size, spec, 20, atoms);
    const test::RankTeam::Traffic after = traffic_of(size, spec, 50, atoms);
    const Index steps = 30;
    CAPTURE(size, atoms, (after.messages - before.messages) / steps, (after.reductions - before.reductions) / steps,
            (after.bytes - before.bytes) / steps);
    for (const Index here : atoms) {
        CHECK(here >= 80);  // two tiles
    }
    CHECK((after.messages - before.messages) % steps == 0);
    CHECK((after.messages - before.messages) / steps == 2 * size * (size - 1));  // all are near in a box so small
    CHECK((after.bytes - before.bytes) % steps == 0);
    // With a list for so many steps nothing is agreed on, but every ten steps whether an atom is too fast.
    CHECK(after.reductions - before.reductions == size * steps / 10);
}

TEST_CASE("a step of a fluid sends as many bytes as the volumes of its grid tell") {
    FluidSpec spec = liquid(10);
    spec.temperature = 4.0;     // of the crystal, which melts at once
    spec.neighbors.every = 40;  // the third list is shared by the work of the second, no longer by that of a crystal
    spec.neighbors.tile = 200;
    spec.sample_every = 1000;
    spec.stages = {{.name = "go", .time_step = 0.004, .steps = 150}};
    const int size = GENERATE(2, 3, 6);
    std::vector<Index> atoms(static_cast<std::size_t>(size));
    const Index before = traffic_of(size, spec, 85, atoms).bytes;
    const Index after = traffic_of(size, spec, 115, atoms).bytes;
    const auto found = static_cast<double>(after - before) / 30.0;
    CAPTURE(size, atoms);

    const Box box = cubic_box(atoms_of(spec), spec.density);
    const double range = 2.5 + spec.neighbors.skin;
    // Of a column that is cut off between clusters of four, no, one, two or three atoms more are taken.
    const auto atoms_in = [&](const std::vector<ClusterGrid::HaloPart>& parts) {
        double sum = 0.0;
        for (const ClusterGrid::HaloPart& part : parts) {
            sum += spec.density * part.volume + 1.5 * static_cast<double>(part.cuts);
        }
        return sum;
    };
    double expected = 0.0;
    std::mutex mutex;
    test::RankTeam(size).run([&](std::shared_ptr<Ranks> here) {
        ClusterGrid grid;
        grid.configure(box, range, atoms_of(spec), spec.neighbors.tile, range, *here);
        const std::lock_guard lock(mutex);
        expected += 32.0 * atoms_in(grid.halo_parts()) + 24.0 * atoms_in(grid.force_parts());
    });
    CHECK(found == Approx(expected).epsilon(0.02));
}

TEST_CASE("ranks that go on from a checkpoint of others have the bits of one process") {
    FluidSpec spec = liquid(5);
    spec.analyses = {analysis("rdf", {{"every", 10}}), analysis("msd", {{"max_time", 0.08}, {"every", 2}})};
    Simulation whole(spec);
    whole.run();
    const int first = GENERATE(1, 2, 5);
    const int second = GENERATE(1, 3);
    std::string checkpoint;
    std::string positions;
    std::vector<double> rdf;
    const auto with = [&](int size, const std::function<void(Simulation&, bool)>& work) {
        test::RankTeam(size).run([&](std::shared_ptr<Ranks> here) {
            const bool is_root = here->is_root();
            Simulation simulation(spec, Execution(ExecutionOptions{.ranks = std::move(here)}));
            work(simulation, is_root);
        });
    };
    with(first, [&](Simulation& simulation, bool is_root) {
        simulation.advance(57);
        std::string written = simulation.checkpoint();
        if (is_root) {
            checkpoint = std::move(written);
        }
    });
    with(second, [&](Simulation& simulation, bool is_root) {
        simulation.restore(checkpoint);
        simulation.run();
        const std::string found = checksum(simulation.state());
        const RunResult result = simulation.result();
        if (is_root) {
            positions = found;
            for (const auto& row : result.tables.front().rows) {
                rdf.push_back(row[1]);
            }
        }
    });
    CHECK(positions == checksum(whole.state()));
    std::vector<double> expected;
    const RunResult whole_result = whole.result();
    for (const auto& row : whole_result.tables.front().rows) {
        expected.push_back(row[1]);
    }
    CHECK(rdf == expected);
    CHECK(!expected.empty());
}

TEST_CASE("ranks of a long box sum inner tiles while messages are under way, and have the bits of one process") {
    FluidSpec spec = liquid(4);
    spec.start = LatticeStart{.cells = 4, .layers = 32};
    spec.neighbors.tile = 200;  // slabs; the last one of each rank has ghosts of another rank
    const Left found = run_by(GENERATE(2, 3), spec, {.threads = GENERATE(1, 2)});
    check_same(found, run_alone(spec));
}

TEST_CASE("a run by several ranks has the bits of one process") {
    const int ranks = GENERATE(1, 2, 3, 4, 7, 8);
    const int threads = GENERATE(1, 2);
    const FluidSpec spec = liquid(6);
    const Left found = run_by(ranks, spec, {.threads = threads});
    check_same(found, run_alone(spec));
    CHECK(found.atoms_here > 0);
}
