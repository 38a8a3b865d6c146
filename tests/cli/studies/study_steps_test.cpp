#include "cli/studies/study_steps.hpp"

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// That workers bring runs to their ends is tried by tests/cli/workers.py, which runs the program.

namespace {

class Line : public RunLine {
  public:
    /// @param finished  whether nothing is left to do
    Line(const TemporaryFolder& folder, std::string name, bool finished) : finished_(finished) {
        run_.directory = folder / name;
        run_.log = folder / (name + ".log");
        run_.name = std::move(name);
    }
    [[nodiscard]] const ChildRun& run() const override { return run_; }

  private:
    std::optional<Job> first_job() override { return finished_ ? std::nullopt : std::optional(Job{}); }
    std::optional<Job> next_job() override { return std::nullopt; }

    bool finished_;
    ChildRun run_;
};

}  // namespace

TEST_CASE("a study has ended when each of its runs is finished or has failed") {
    const TemporaryFolder folder;
    std::vector<Line> lines{{folder, "a", true}, {folder, "b", false}, {folder, "c", false}};
    std::ofstream(folder / "a.log") << "error: of an earlier attempt\nended with exit code 5\n";
    std::ofstream(folder / "b.log") << "error: blown up\nended with exit code 5\n";
    Gathered found = gathered(pointers_to(lines));
    CHECK(found.finished == std::vector<bool>{true, false, false});
    CHECK(found.missing == 2);
    CHECK(found.failed == 1);
    CHECK_FALSE(found.ended());
    CHECK(lines[0].failure().empty());
    CHECK(lines[1].failure() == "b: exit code 5: error: blown up");
    CHECK(lines[2].failure().empty());
    std::ofstream(folder / "c.log") << "killed\nended with exit code 137\n";
    found = gathered(pointers_to(lines));
    CHECK(found.ended());
    CHECK(lines[2].failure() == "c: exit code 137 (signal 9): killed");
}

TEST_CASE("failures are counted and told") {
    CHECK_NOTHROW(throw_failures(sweep_words(), {}, 3, "again"));
    CHECK_THROWS_WITH(throw_failures(sweep_words(), {"b: x", "c: y"}, 3, "again"),
                      "2 of 3 points failed; again\n  b: x\n  c: y");
    CHECK_THROWS_AS(throw_failures(reproduction_words(), {"b: x"}, 3, "again"), PhysicsError);
}

TEST_CASE("a share that cannot be read is refused before anything is run") {
    const TemporaryFolder folder;
    std::vector<Line> lines{{folder, "a", true}};
    const auto tell = [](const RunLine&, std::size_t, std::size_t) {};
    const OpenDirectory directory(folder / "");
    CHECK_THROWS_AS(work_on(sweep_words(), {.work = "2/1"}, pointers_to(lines), directory, 1, tell), InputError);
    CHECK_THROWS_AS(work_on(sweep_words(), {.work = "1/1", .walltime = "soon"}, pointers_to(lines), directory, 1, tell),
                    InputError);
    CHECK_THROWS_WITH(print_status(sweep_words(), folder / "", false), Contains("holds no study"));
}
