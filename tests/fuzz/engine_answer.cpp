#include <algorithm>
#include <array>
#include <string>

#include "fuzz_target.hpp"
#include "judge/answer_reader.hpp"
#include "judge/judge.hpp"
#include "ljmd/core/errors.hpp"
#include "model/velocities.hpp"

using namespace ljmd;

namespace {

/// Three atoms that move for ten steps.
Problem problem_of_three() {
    constexpr double edge = 6.0;
    State state(3, Box(Vec3::Constant(edge)));
    state.write_positions().col(1) = state.snapped(Vec3(1.1, 0.0, 0.0));
    state.write_positions().col(2) = state.snapped(Vec3(0.0, 1.2, 0.3));
    draw_velocities(state, 1.0, 1);
    Stage stage;
    stage.name = "production";
    stage.time_step = 0.004;
    stage.steps = 10;
    return {.fluid = fluid_of(state, PairPotential::lennard_jones("shifted", {2.5, 0.0}), false),
            .stage = stage,
            .steps_before = 0,
            .trajectory_steps = 5,
            .frames = {0, 1, 5},
            .thermo_every = 1};
}

OwnSide side_of(const Problem& problem) {
    FluidSpec spec;
    spec.potential = problem.fluid.potential;
    spec.neighbors.method = "all-pairs";
    return {spec, Execution{}, "all-pairs"};
}

/// The files of an answer, each behind a line with its name.
class AnswerFolder {
  public:
    static constexpr std::array<const char*, 5> names{"point.json", "point.xyz", "frames.xyz", "frames.dump",
                                                      "thermo.csv"};

    void write(std::string_view text) const {
        for (const char* name : names) {
            std::filesystem::remove(file_.directory() / name);
        }
        while (!text.empty()) {
            const auto found = std::ranges::find_if(
                names, [&](const char* name) { return text.starts_with(name + std::string("\n")); });
            if (found == names.end()) {
                return;
            }
            const std::string_view name = *found;
            const std::string_view rest = text.substr(name.size() + 1);
            std::size_t end = rest.size();
            for (const char* next : names) {
                end = std::min(end, rest.find('\n' + std::string(next) + '\n'));
            }
            std::ofstream(file_.directory() / name, std::ios::binary) << rest.substr(0, std::min(end + 1, rest.size()));
            text = end < rest.size() ? rest.substr(end + 1) : std::string_view();
        }
    }
    [[nodiscard]] const std::filesystem::path& path() const { return file_.directory(); }

  private:
    test::WrittenFile file_{"", "unused"};
};

}  // namespace

// What an engine answers, as the judge reads it, and what the judge makes of it.
LJMD_FUZZ_TARGET(engine_answer) {
    static const AnswerFolder folder;
    static const Problem problem = problem_of_three();
    static const OwnSide own = side_of(problem);
    folder.write(fuzz::text_of(data, size));
    try {
        const Answer answer = read_answer(folder.path(), problem);
        fuzz::require(answer.point.forces.empty() || answer.point.forces.size() == 3, "forces of other atoms");
        for (const Frame& frame : answer.frames) {
            fuzz::require(frame.configuration.positions.size() == 3, "a frame has other atoms");
        }
        const Judgement found = judge(problem, answer, own, [](const std::string&) {});
        fuzz::require(found.failures() <= std::ssize(found.checks), "more failures than checks");
        ++fuzz::inputs_accepted;
    } catch (const DataError&) {
    }
    return 0;
}
