#include <fmt/format.h>

#include <fstream>
#include "catch.hpp"

#include "compare/lammps.hpp"
#include "compare/peers.hpp"
#include "compare/small_fluid.hpp"
#include "core/environment_guard.hpp"
#include "execution/thread_team.hpp"
#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/potentials/tail_correction.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

/// Energy, virial and forces of a small fluid, pair by pair.
PeerPoint pair_by_pair(const Fluid& fluid) {
    PeerPoint point{{0.0, kinetic_energy(fluid), 0.0}, std::vector<Vec3>(fluid.positions.size(), Vec3::Zero())};
    const Box box(fluid.edges);
    for (std::size_t i = 0; i < fluid.positions.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const Vec3 r = box.minimum_image(fluid.positions[i] - fluid.positions[j]);
            const PairTerm<double> term = fluid.potential(r.norm());
            point.totals.potential_energy += term.u;
            point.totals.virial += term.w * r.squaredNorm();
            point.forces[i] += term.w * r;
            point.forces[j] -= term.w * r;
        }
    }
    return point;
}

double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    REQUIRE(a.size() == b.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, (a[i] - b[i]).norm());
    }
    return largest;
}

/// A program that says what LAMMPS says of itself, and does something else.
class FalseLammps {
  public:
    FalseLammps(const std::string& packages, const std::string& text) : path_(folder_ / "false-lmp") {
        std::ofstream(path_) << "#!/bin/sh\nif [ \"$1\" = -h ]; then\n"
                                "echo 'Massively Parallel Simulator - 1 Jan 2030'\n"
                                "printf 'Installed packages:\\n\\n"
                             << packages << "\\n\\n'\nexit 0\nfi\n"
                             << text << '\n';
        fs::permissions(path_, fs::perms::owner_all);
        guard_.emplace("LJMD_LAMMPS", path_.string());
    }
    [[nodiscard]] fs::path operator/(const std::string& name) const { return folder_ / name; }

  private:
    TemporaryFolder folder_;
    fs::path path_;
    std::optional<EnvironmentGuard> guard_;
};

}  // namespace

TEST_CASE("LAMMPS evaluates a few atoms as they are summed by hand") {
    if (!lammps_is_here()) {
        return;
    }
    for (const char* truncation : {"cut", "shifted", "force-shifted", "switched"}) {
        INFO(truncation);
        Fluid fluid = small_fluid("lennard-jones", truncation);
        fluid.masses[1] = 2.5;
        const PeerPoint expected = pair_by_pair(fluid);
        const PeerPoint found = make_lammps_peer(fluid, 1)->point();
        CHECK(found.totals.potential_energy == Approx(expected.totals.potential_energy).epsilon(1e-13).margin(1e-15));
        CHECK(found.totals.kinetic_energy == Approx(expected.totals.kinetic_energy).epsilon(1e-14));
        CHECK(found.totals.virial == Approx(expected.totals.virial).epsilon(1e-13));
        CHECK(largest_difference(found.forces, expected.forces) < 1e-13 * expected.forces[0].norm());
        CHECK_FALSE(found.tail_energy.has_value());
        CHECK_FALSE(found.tail_pressure.has_value());
    }
}

TEST_CASE("LAMMPS' tail corrections are ours, and stay out of the totals") {
    if (!lammps_is_here()) {
        return;
    }
    const Fluid fluid = small_fluid("lennard-jones", "cut", true);
    const PeerPoint found = make_lammps_peer(fluid, 1)->point();
    const TailCorrection tail(fluid.potential);
    const double density = 3.0 / (6.0 * 7.0 * 8.0);
    REQUIRE(found.tail_energy.has_value());
    REQUIRE(found.tail_pressure.has_value());
    CHECK(*found.tail_energy == Approx(tail.energy(density)).epsilon(1e-11));
    CHECK(*found.tail_pressure == Approx(tail.pressure(density)).epsilon(1e-11));
    CHECK(found.totals.potential_energy == Approx(pair_by_pair(fluid).totals.potential_energy).epsilon(1e-13));
    CHECK_FALSE(make_lammps_peer(small_fluid("lennard-jones", "switched", true), 1)->point().tail_energy.has_value());
}

TEST_CASE("LAMMPS follows the steps that are asked for, and samples the same") {
    if (!lammps_is_here()) {
        return;
    }
    const Fluid fluid = small_fluid("lennard-jones", "force-shifted");
    const auto peer = make_lammps_peer(fluid, 1);
    CHECK_THAT(peer->name(), Catch::StartsWith("LAMMPS "));
    REQUIRE(peer->methods().size() == 1);
    CHECK(peer->methods()[0].name == "fix nve");
    CHECK(peer->methods()[0].ours == std::vector<std::string>{"velocity-verlet", "leapfrog"});
    CHECK_THROWS_AS(peer->follow("fix nvt", 0.004, {0}), ContractViolation);

    const std::vector<PeerFrame> frames = peer->follow("fix nve", 0.004, {0, 1, 100, 800});
    REQUIRE(frames.size() == 4);
    CHECK(frames[0].positions == fluid.positions);
    CHECK(frames[0].kinetic_energy == Approx(kinetic_energy(fluid)).epsilon(1e-14));
    for (std::size_t k = 0; k < 4; ++k) {
        CHECK(frames[k].step == std::vector<Index>{0, 1, 100, 800}[k]);
        CHECK(frames[k].potential_energy + frames[k].kinetic_energy ==
              Approx(frames[0].potential_energy + frames[0].kinetic_energy).epsilon(5e-3));
    }

    std::vector<Index> rows;
    std::vector<Index> with_positions;
    peer->sample(0.004, 105, 10, 50, [&](Index step, const Totals& totals, const std::vector<Vec3>* positions) {
        rows.push_back(step);
        if (positions != nullptr) {
            with_positions.push_back(step);
        }
        if (step == 100) {
            CHECK(totals.potential_energy == Approx(frames[2].potential_energy).epsilon(1e-13));
            CHECK(totals.kinetic_energy == Approx(frames[2].kinetic_energy).epsilon(1e-13));
            REQUIRE(positions != nullptr);
            CHECK(largest_difference(*positions, frames[2].positions) < 1e-13);
        }
    });
    CHECK(rows == std::vector<Index>{10, 20, 30, 40, 50, 60, 70, 80, 90, 100});
    CHECK(with_positions == std::vector<Index>{50, 100});
    const double seconds = peer->seconds(0.004, 1000);
    CHECK(seconds > 0.0);
    CHECK(seconds < 60.0);
}

TEST_CASE("a single atom moves on through the walls and has a kinetic energy") {
    if (!lammps_is_here()) {
        return;
    }
    Fluid fluid = small_fluid();
    fluid.masses.resize(1);
    fluid.positions.resize(1);
    fluid.velocities = {Vec3(1.0, 0.0, 0.0)};
    const auto frames = make_lammps_peer(fluid, 1)->follow("fix nve", 0.125, {64});
    CHECK(frames.at(0).kinetic_energy == 0.5);
    CHECK(frames.at(0).potential_energy == 0.0);
    CHECK(frames.at(0).positions.at(0)[0] == Approx(9.0).epsilon(1e-15));
}

TEST_CASE("what LAMMPS refuses is told in its own words") {
    if (!lammps_is_here()) {
        return;
    }
    Fluid fluid = small_fluid();
    fluid.velocities[0] = Vec3(1e6, 0.0, 0.0);
    fluid.positions[0] = Vec3(6.5, 1.0, 1.0);
    fluid.masses[2] = -1.0;
    const auto peer = make_lammps_peer(fluid, 1);
    CHECK_THROWS_AS(peer->point(), DataError);
    CHECK_THROWS_WITH(peer->point(), Catch::StartsWith("LAMMPS failed with exit status 1:\n") &&
                                         Contains("ERROR: Invalid mass value") && Contains("Last command"));
}

TEST_CASE("no LAMMPS, or none with the potential, is an error before anything is run") {
    const Fluid fluid = small_fluid();
    {
        const EnvironmentGuard absent("LJMD_LAMMPS", "no-such-lammps");
        CHECK_THROWS_AS(make_lammps_peer(fluid, 1), InputError);
        CHECK_THROWS_WITH(make_lammps_peer(fluid, 1), Contains("no program 'no-such-lammps'") &&
                                                          Contains("apt-get install lammps") &&
                                                          Contains("LJMD_LAMMPS"));
    }
    {
        const EnvironmentGuard another("LJMD_LAMMPS", "/bin/echo");
        CHECK_THROWS_AS(make_lammps_peer(fluid, 1), InputError);
        CHECK_THROWS_WITH(make_lammps_peer(fluid, 1), Contains("does not answer as LAMMPS does:\n  -h"));
    }
    const FalseLammps program("KSPACE", "exit 0");
    CHECK_THROWS_WITH(make_lammps_peer(small_fluid("morse", "switched"), 1), Contains("has no potential 'morse'"));
    CHECK(make_lammps_peer(fluid, 1)->name() == "LAMMPS 1 Jan 2030");
}

TEST_CASE("threads are those of the package OPENMP") {
    const Fluid fluid = small_fluid();
    const std::string record = "echo \"$* threads $OMP_NUM_THREADS\" > \"$(dirname \"$0\")/call\"; echo oh; exit 3";
    {
        const FalseLammps plain("KSPACE OPT", record);
        CHECK_THROWS_WITH(make_lammps_peer(fluid, 4)->point(), "LAMMPS failed with exit status 3:\n  oh");
        CHECK(content_of(plain / "call") == "-in in.lammps -log none threads 1\n");
    }
    const FalseLammps threaded("KSPACE OPENMP", record);
    CHECK(make_lammps_peer(fluid, 4)->name() == "LAMMPS 1 Jan 2030, 4 threads");
    CHECK_THROWS_AS(make_lammps_peer(fluid, 4)->seconds(0.004, 1), DataError);
    CHECK(content_of(threaded / "call") == "-in in.lammps -log none -suffix omp -package omp 4 threads 4\n");
}

TEST_CASE("a LAMMPS that gets no threads is told from one that fails otherwise") {
    const Fluid fluid = small_fluid();
    for (const char* words : {"libgomp: Thread creation failed: Resource temporarily unavailable",
                              "OMP: Error #34: System unable to allocate necessary resources for OMP thread:"}) {
        INFO(words);
        const std::string text = fmt::format("echo '{}'; exit 1", words);
        const FalseLammps threaded("KSPACE OPENMP", text);
        CHECK_THROWS_AS(make_lammps_peer(fluid, 4)->point(), ThreadsError);
        CHECK_THROWS_WITH(make_lammps_peer(fluid, 4)->point(),
                          Catch::StartsWith("LAMMPS did not get the 4 threads that were asked for") && Contains(words));
    }
}

TEST_CASE("a LAMMPS that says something else is not believed") {
    const Fluid fluid = small_fluid();
    const FalseLammps silent("KSPACE", "exit 0");
    CHECK_THROWS_AS(make_lammps_peer(fluid, 1)->point(), DataError);
    const FalseLammps lacking("KSPACE", R"(echo 'Step PotEng c_kinetic c_virial'; echo '0 1 2 3'; echo '5 1 2 3'
echo 'Loop time of 1 on 1 procs'; echo 'ITEM: TIMESTEP' > frames.dump)");
    CHECK_THROWS_WITH(make_lammps_peer(fluid, 1)->sample(0.004, 6, 3, 0, [](Index, const Totals&, const auto*) {}),
                      "LAMMPS' log has no row of step 3");
    CHECK_THROWS_WITH(make_lammps_peer(fluid, 1)->follow("fix nve", 0.004, {0}),
                      Catch::StartsWith("LAMMPS' frames.dump"));
}
