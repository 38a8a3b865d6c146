#include "study/run_lines.hpp"

#include <fstream>
#include <functional>
#include <optional>

#include "io/files/claimed_file.hpp"
#include "io/files/directory_lock.hpp"
#include "io/output_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
namespace fs = std::filesystem;

namespace {

const Job help{{"-?"}, "unused"};  // of this test program, which then exits with 0

/// A line whose jobs are said by the test.
class Line : public RunLine {
  public:
    Line(const TemporaryFolder& folder, std::string name, std::vector<Job> jobs) : jobs_(std::move(jobs)) {
        run_.directory = folder / name;
        run_.log = folder / (name + ".log");
        run_.name = std::move(name);
    }

    [[nodiscard]] const ChildRun& run() const override { return run_; }

    int begun = 0;
    int ended_well = 0;  ///< jobs

  private:
    std::optional<Job> first_job() override {
        ++begun;
        return next();
    }
    std::optional<Job> next_job() override {
        ++ended_well;
        return next();
    }
    std::optional<Job> next() { return taken_ < jobs_.size() ? std::optional(jobs_[taken_++]) : std::nullopt; }

    ChildRun run_;
    std::vector<Job> jobs_;
    std::size_t taken_ = 0;
};

/// Names of lines in the order in which they came to their ends, and what was told meanwhile.
struct Course {
    std::vector<std::string> ended;
    std::vector<std::size_t> counts;
    std::vector<std::string> told;
};

Course course_of(
    std::vector<Line>& lines, const Interruption& interruption = Interruption(),
    const std::function<void()>& when_told = [] {}) {
    Course course;
    run_lines(
        pointers_to(lines), 1, interruption,
        [&](const RunLine& line, std::size_t done) {
            course.ended.push_back(line.run().name);
            course.counts.push_back(done);
        },
        [&](const std::string& text) {
            course.told.push_back(text);
            when_told();
        });
    return course;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("each line is told of when it is at its end, and its jobs write one log") {
    const TemporaryFolder folder;
    std::vector<Line> lines{{folder, "a", {help, help}}, {folder, "b", {}}, {folder, "c", {help}}};
    std::ofstream(folder / "c.log") << "of an earlier attempt\n";
    const Course course = course_of(lines);
    CHECK(course.ended == Names{"a", "b", "c"});
    CHECK(course.counts == std::vector<std::size_t>{1, 2, 3});
    CHECK(course.told.empty());
    CHECK(lines[0].ended_well == 2);
    CHECK(lines[1].ended_well == 0);
    CHECK(lines[2].ended_well == 1);
    const std::string said = content_of(folder / "c.log");
    CHECK(said.find("of an earlier") == std::string::npos);
    CHECK(content_of(folder / "a.log") == said);  // of the last job alone
}

TEST_CASE("a run that another process holds is left to it, waited for at the end, and asked only then what is left") {
    const bool by_log = GENERATE(true, false);
    const TemporaryFolder folder;
    std::vector<Line> lines{{folder, "held", {}}, {folder, "free", {help}}};
    fs::create_directory(folder / "held");
    std::optional<ClaimedFile> log;
    std::optional<DirectoryLock> directory;
    if (by_log) {
        log = ClaimedFile::claim(folder / "held.log");
    } else {
        directory.emplace(folder / "held");
    }
    int begun_while_held = 0;
    const Course course = course_of(lines, Interruption(), [&] {
        begun_while_held = lines[0].begun;
        log.reset();
        directory.reset();
    });
    CHECK(begun_while_held == 0);
    CHECK(course.ended == Names{"free", "held"});
    CHECK(lines[0].begun == 1);
    CHECK(course.told == Names{"waiting for the run that is still writing to " + (folder / "held").string() + "\n"});
}

TEST_CASE("who waits for a run of another process can be stopped") {
    const TemporaryFolder folder;
    std::vector<Line> lines{{folder, "held", {help}}};
    const auto log = ClaimedFile::claim(folder / "held.log");
    CHECK_THROWS_AS(course_of(lines, Interruption(0.2)), Interrupted);
    CHECK(lines[0].begun == 0);
}

TEST_CASE("a run that fails has the exit code in its log") {
    const TemporaryFolder folder;
    std::vector<Line> lines{{folder, "a", {{{"--no-such-option"}, "unused"}}}};
    CHECK(course_of(lines).ended == Names{"a"});
    CHECK(lines[0].ended_well == 0);
    CHECK(lines[0].failure().starts_with("a: exit code "));
    CHECK(recorded_failure(folder / "a.log").starts_with("exit code "));
}
