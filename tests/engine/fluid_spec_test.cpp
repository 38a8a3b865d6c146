#include "ljmd/engine/fluid_spec.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include "catch.hpp"

#include "core/text.hpp"
#include "engine/engine_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

std::string complaint(const std::function<void(FluidSpec&)>& spoil) {
    FluidSpec spec = small_spec();
    spoil(spec);
    const std::vector<std::string> found = mistakes(spec);
    CAPTURE(found);
    CHECK(found.size() == 1);
    return found.empty() ? "" : found.front();
}

}  // namespace

TEST_CASE("a specification has the atoms and the box that its start says") {
    FluidSpec spec = small_spec();
    CHECK(mistakes(spec).empty());
    CHECK(atoms_of(spec) == 108);
    CHECK(box_of(spec).volume() == Approx(108 / 0.8).epsilon(1e-14));
    spec.start = RandomStart{50};
    CHECK(atoms_of(spec) == 50);
    spec.start = Configuration{.edges = Vec3(4.0, 5.0, 6.0), .positions = {Vec3::Zero(), Vec3::Ones()}};
    CHECK(atoms_of(spec) == 2);
    CHECK(box_of(spec).edges() == Vec3(4.0, 5.0, 6.0));
    CHECK(total_steps(spec.stages) == 60);
}

TEST_CASE("an edge that is twice the cutoff but for rounding counts as twice the cutoff") {
    FluidSpec spec = small_spec();
    const double edge = 4.0 * (1.0 - 1e-15);
    spec.start = Configuration{.edges = Vec3::Constant(edge), .positions = {Vec3::Zero()}};
    CHECK(box_of(spec).shortest_edge() >= 4.0);
    CHECK(mistakes(spec).empty());
}

TEST_CASE("each mistake of a specification is one sentence that says where it is") {
    CHECK_THAT(complaint([](FluidSpec& s) { s.temperature.reset(); }), Contains("start: a temperature is needed"));
    CHECK_THAT(complaint([](FluidSpec& s) { s.temperature = -1.0; }), Contains("the temperature is -1"));
    CHECK_THAT(complaint([](FluidSpec& s) { s.density = 0.0; }), Contains("the density is 0"));
    CHECK_THAT(complaint([](FluidSpec& s) { s.start = RandomStart{0}; }), Contains("0 atoms: allowed are 1 to"));
    CHECK_THAT(complaint([](FluidSpec& s) { s.start = Configuration{.positions = {Vec3::Zero()}}; }),
               Contains("edges of the box"));
    CHECK_THAT(complaint([](FluidSpec& s) { s.density = 3.0; }),
               Contains("potential: cutoff is 2, more than half the box (L = "));
    CHECK_THAT(complaint([](FluidSpec& s) { s.tail = true; }),
               Contains("potential: tail has no meaning for truncation = \"force-shifted\""));
    CHECK_THAT(complaint([](FluidSpec& s) { s.sample_every = 0; }), Contains("sample_every"));
    CHECK_THAT(complaint([](FluidSpec& s) { s.stages.clear(); }), Contains("at least one is needed"));
    CHECK_THAT(complaint([](FluidSpec& s) { s.stages[1].name = "equilibrate"; }),
               Contains("stage 'equilibrate': two stages are called 'equilibrate'"));
    CHECK_THAT(complaint([](FluidSpec& s) { s.stages[1].name.clear(); }), Contains("stage '': name must be 1 to 64"));
    CHECK_THAT(complaint([](FluidSpec& s) { s.stages[1].time_step = 0.0; }), Contains("the time step is 0"));
    CHECK_THAT(complaint([](FluidSpec& s) { s.stages[1].steps = -1; }), Contains("-1 steps"));
    CHECK_THAT(complaint([](FluidSpec& s) { s.stages[1].integrator = integrator("prince-dormand"); }),
               Contains("for few bodies only"));
    CHECK_THAT(complaint([](FluidSpec& s) {
                   s.stages[1].barostat = barostat("stochastic-cell-rescaling", {{"pressure", 1.0}});
               }),
               Contains("a barostat needs a canonical thermostat"));
    CHECK_THAT(complaint([](FluidSpec& s) {
                   s.stages[1].thermostat = thermostat("langevin");
                   s.stages[1].temperature = 0.0;
               }),
               Contains("langevin needs a temperature above 0"));
    CHECK_THAT(complaint([](FluidSpec& s) {
                   s.stages[1].thermostat = thermostat("langevin");
                   s.stages[1].integrator = integrator("leapfrog");
               }),
               Contains("a part of the steps of velocity-verlet"));
    CHECK_THAT(complaint([](FluidSpec& s) {
                   s.analyses = {analysis("rdf"), analysis("rdf")};
               }),
               Contains("analysis rdf: it is there twice"));
    CHECK_THAT(complaint([](FluidSpec& s) {
                   s.analyses = {analysis("rdf", {{"radius", 100.0}})};
               }),
               Contains("analysis rdf: "));
    CHECK_THAT(complaint([](FluidSpec& s) {
                   s.stages[1].thermostat = thermostat("langevin");
                   s.stages[1].barostat = barostat("stochastic-cell-rescaling", {{"pressure", 1.0}});
                   s.analyses = {analysis("msd")};
               }),
               Contains("a box that stays as it is"));
    CHECK_THAT(complaint([](FluidSpec& s) {
                   s.stages[0].sample = true;
                   s.stages[0].time_step = 0.002;
                   s.analyses = {analysis("msd", {{"max_time", 0.08}, {"every", 1}})};
               }),
               Contains("equal times apart"));
}

TEST_CASE("numbers that are none, or nonsense, are mistakes") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double nonsense : {nan, infinity, -1.0}) {
        CAPTURE(nonsense);
        CHECK_THAT(complaint([=](FluidSpec& s) { s.density = nonsense; }), Contains("start: the density is"));
        CHECK_THAT(complaint([=](FluidSpec& s) { s.temperature = nonsense; }), Contains("start: the temperature is"));
        CHECK_THAT(complaint([=](FluidSpec& s) { s.neighbors.skin = nonsense; }), Contains("neighbors: the skin is"));
        CHECK_THAT(complaint([=](FluidSpec& s) { s.stages[1].time_step = nonsense; }), Contains("the time step is"));
        CHECK_THAT(complaint([=](FluidSpec& s) { s.stages[0].temperature = nonsense; }),
                   Contains("rescale needs a temperature of 0 or more"));
        CHECK_THAT(complaint([=](FluidSpec& s) {
                       s.potential = PairPotential::lennard_jones("cut", {nonsense, 0.0});
                   }),
                   Contains("potential: the cutoff is"));
        CHECK_THAT(complaint([=](FluidSpec& s) {
                       s.potential = PairPotential::lennard_jones("switched", {2.0, nonsense});
                   }),
                   Contains("potential: ") && Contains("switch"));
    }
    CHECK_THAT(complaint([](FluidSpec& s) { s.start = LatticeStart{.cells = -1}; }), Contains("-1 cells"));
    CHECK_THAT(complaint([](FluidSpec& s) { s.start = RandomStart{Index{1} << 41U}; }), Contains("atoms: allowed"));
    CHECK_THAT(complaint([](FluidSpec& s) { s.neighbors.method = "x"; }),
               Contains("unknown method 'x', allowed: ") && Contains("verlet-list"));
    CHECK_THAT(complaint([](FluidSpec& s) { s.neighbors.every = 0; }), Contains("neighbors: every is 0"));
    CHECK_THAT(complaint([](FluidSpec& s) {
                   s.stages[0].steps = std::numeric_limits<Index>::max();
                   s.stages[1].steps = std::numeric_limits<Index>::max();
               }),
               Contains("more than 2^62"));
    CHECK_THAT(complaint([](FluidSpec& s) { s.stages[1].thermostat = Choice{"rescaling"}; }),
               Contains("stage 'production': unknown thermostat 'rescaling', allowed: "));
    CHECK_THAT(complaint([](FluidSpec& s) { s.stages[0].integrator = {"leapfrog", {{"xi", 0.1}}}; }), Contains("xi"));
    CHECK_THAT(complaint([](FluidSpec& s) {
                   s.analyses = {{"rdf", {{"bins", 0}}}};
               }),
               Contains("analyses: 'bins' in rdf"));
}

TEST_CASE("a configuration has one velocity and one mass for each atom, or none") {
    const Configuration two{.edges = Vec3::Constant(5.0), .positions = {Vec3::Zero(), Vec3::Ones()}};
    const auto spoilt = [&](const std::function<void(Configuration&)>& spoil) {
        Configuration configuration = two;
        spoil(configuration);
        return complaint([&](FluidSpec& s) { s.start = configuration; });
    };
    CHECK_THAT(spoilt([](Configuration& c) { c.velocities = {Vec3::Zero()}; }), Contains("1 velocities for 2 atoms"));
    CHECK_THAT(spoilt([](Configuration& c) { c.masses = {1.0}; }), Contains("1 masses for 2 atoms"));
    CHECK_THAT(spoilt([](Configuration& c) { c.masses = {1.0, std::nan("")}; }), Contains("mass 1"));
    CHECK_THAT(spoilt([](Configuration& c) { c.positions[1][0] = std::nan(""); }), Contains("must be finite"));
    CHECK_THAT(spoilt([](Configuration& c) { c.edges[0] = std::nan(""); }), Contains("edges of the box"));
}

TEST_CASE("mistakes are reported together") {
    FluidSpec spec = small_spec();
    spec.temperature.reset();
    spec.stages[1].steps = -1;
    CHECK(mistakes(spec).size() == 2);
}

TEST_CASE("velocities of a configuration need no temperature, unless they are not kept") {
    FluidSpec spec = small_spec();
    spec.temperature.reset();
    spec.start = Configuration{.edges = Vec3::Constant(5.0),
                               .positions = {Vec3::Zero(), Vec3::Ones()},
                               .velocities = {Vec3::Ones(), -Vec3::Ones()}};
    CHECK(mistakes(spec).empty());
    spec.keep_velocities = false;
    CHECK(mistakes(spec).size() == 1);
}
