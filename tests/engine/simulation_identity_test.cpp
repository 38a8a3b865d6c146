#include <functional>
#include <memory>
#include <string>
#include <vector>
#include "catch.hpp"

#include "engine/engine_fixtures.hpp"
#include "forces/made_external_force.hpp"
#include "ljmd/core/errors.hpp"

using Catch::Matchers::Contains;
using namespace ljmd;
using namespace ljmd::test;

namespace {

/// What a changed member means for a checkpoint of the specification before.
enum class Meaning {
    moves_otherwise,   ///< the rest of the trajectory or of the results is another: refused
    was_in_the_start,  ///< decides how the simulation begins, or what messages say: continued with the same bits
};

struct Change {
    std::string member;  ///< empty behind the last one
    Meaning meaning = Meaning::moves_otherwise;
};

/// Change the member with this number. All members are named, so that a new one does not compile until it is here.
Change change(Stage& stage, int member) {
    auto& [name, integrator, time_step, steps, temperature, sample, reverse, thermostat, barostat, seed, total_energy,
           until] = stage;
    switch (member) {
        case 0:
            name = "another";
            return {"name"};
        case 1:
            integrator = ljmd::integrator("leapfrog");
            return {"integrator"};
        case 2:
            time_step = 0.002;
            return {"time_step"};
        case 3:
            steps += 1;
            return {"steps"};
        case 4:
            temperature = 1.1;
            return {"temperature"};
        case 5:
            sample = !sample;
            return {"sample"};
        case 6:
            reverse = true;
            return {"reverse"};
        case 7:
            thermostat = ljmd::thermostat("langevin", {{"time", 0.25}});
            return {"thermostat"};
        case 8:
            barostat = ljmd::barostat("stochastic-cell-rescaling", {{"pressure", 1.0}});
            return {"barostat"};
        case 9:
            seed = 8;
            return {"seed"};
        case 10:
            total_energy = total_energy.value_or(-3.0) + 1.0;
            return {"total_energy"};
        case 11:
            until.push_back({"pressure", 0.01});
            return {"until"};
        default:
            return {};
    }
}

Change change(NeighborSpec& neighbors, int member) {
    auto& [method, skin, every, tile] = neighbors;
    switch (member) {
        case 0:
            method = "all-pairs";
            return {"method"};
        case 1:
            skin = 0.4;
            return {"skin"};
        case 2:
            every = 7;
            return {"every"};
        case 3:
            tile = 60;
            return {"tile"};
        default:
            return {};
    }
}

Change change(FluidSpec& spec, int member) {
    auto& [start, density, temperature, keep_velocities, seed, potential, tail, neighbors, external, stages,
           sample_every, analyses, units] = spec;
    switch (member) {
        case 0:
            start = RandomStart{108};
            return {"start", Meaning::was_in_the_start};
        case 1:
            density = 0.7;
            return {"density", Meaning::was_in_the_start};
        case 2:
            temperature = 1.2;
            return {"temperature", Meaning::was_in_the_start};
        case 3:
            keep_velocities = false;
            return {"keep_velocities", Meaning::was_in_the_start};
        case 4:
            seed = 8;
            return {"seed"};
        case 5:
            potential = PairPotential::lennard_jones("shifted", potential.cutoff());
            return {"potential"};
        case 6:
            tail = false;
            return {"tail"};
        case 7:
            change(neighbors, 1);
            return {"neighbors"};
        case 8:
            external = std::make_shared<MadeForce>([](const AtomPositions&, auto&) { return ExternalEnergy(); });
            return {"external"};
        case 9:
            stages.push_back(stages.back());
            stages.back().name = "more";
            return {"stages"};
        case 10:
            sample_every = 5;
            return {"sample_every"};
        case 11:
            analyses = {analysis("rdf")};
            return {"analyses"};
        case 12:
            units = SubstanceUnits(3.4e-10, 1.65e-21, 6.63e-26);
            return {"units", Meaning::was_in_the_start};
        default:
            return {};
    }
}

/// With a canonical thermostat, beside which a barostat is allowed, and with a stage at an energy that is asked for.
FluidSpec with_everything() {
    FluidSpec spec = small_spec();
    spec.potential = PairPotential::lennard_jones("cut", {2.0, 0.0});
    spec.stages[0].thermostat = thermostat("langevin", {{"time", 0.5}});
    Stage last = spec.stages[1];
    last.name = "at an energy";
    last.total_energy = -3.0;
    spec.stages.push_back(last);
    return spec;
}

using Part = std::function<Change(FluidSpec&, int)>;

/// Change each member of parts of one kind and restore a checkpoint of before: refused. Each can be changed in one of
/// the parts at least.
void check_each_member_refused(const std::vector<Part>& same_part) {
    const FluidSpec spec = with_everything();
    Simulation first(spec);
    first.advance(10);
    const std::string checkpoint = first.checkpoint();
    for (int member = 0;; ++member) {
        int tried = 0;
        for (const Part& part : same_part) {
            FluidSpec other = spec;
            const Change made = part(other, member);
            if (made.member.empty()) {
                CHECK(member > 3);
                return;
            }
            CAPTURE(made.member);
            if (mistakes(other).empty()) {  // not every stage can have everything
                ++tried;
                CHECK_THROWS_WITH(Simulation(other).restore(checkpoint), Contains("another specification"));
            }
        }
        CAPTURE(member);
        CHECK(tried > 0);
    }
}

}  // namespace

TEST_CASE("a checkpoint is refused when any member of a stage has changed") {
    const auto stage = [](std::size_t index) {
        return [index](FluidSpec& spec, int member) { return change(spec.stages[index], member); };
    };
    check_each_member_refused({stage(0), stage(1), stage(2)});
}

TEST_CASE("a checkpoint is refused when any member of the neighbour search has changed") {
    check_each_member_refused({[](FluidSpec& spec, int member) { return change(spec.neighbors, member); }});
}

TEST_CASE("a checkpoint is refused when a member of the specification has changed that the rest of the run needs") {
    const FluidSpec spec = with_everything();
    Simulation first(spec);
    first.advance(10);
    const std::string checkpoint = first.checkpoint();
    first.run();
    for (int member = 0;; ++member) {
        FluidSpec other = spec;
        const Change made = change(other, member);
        if (made.member.empty()) {
            CHECK(member == 13);
            return;
        }
        CAPTURE(made.member);
        REQUIRE(mistakes(other).empty());
        Simulation second(other);
        if (made.meaning == Meaning::moves_otherwise) {
            CHECK_THROWS_WITH(second.restore(checkpoint), Contains("another specification"));
        } else {
            second.restore(checkpoint);
            second.run();
            check_same(second, first);
        }
    }
}

TEST_CASE("a checkpoint is refused when a stage asks for an energy and did not, or the other way round") {
    const FluidSpec with = with_everything();
    FluidSpec without = with;
    without.stages[2].total_energy.reset();
    Simulation ours(with);
    ours.advance(10);
    Simulation theirs(without);
    theirs.advance(10);
    CHECK_THROWS_WITH(Simulation(without).restore(ours.checkpoint()), Contains("another specification"));
    CHECK_THROWS_WITH(Simulation(with).restore(theirs.checkpoint()), Contains("another specification"));
}
