#include <fmt/format.h>

#include <algorithm>

#include "cli/command.hpp"
#include "cli/deck_options.hpp"
#include "cli/streams.hpp"
#include "engine/verification/digits.hpp"
#include "execution/threads.hpp"
#include "ljmd/core/build_info.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

class VerifyCommand : public Command {
  public:
    VerifyCommand()
        : Command("verify", Part::program, "run for two seconds, and compare the digits with those of every machine") {}

    void add_options(CLI::App& command) override {
        add_threads(command, threads_, "threads to share the work; no digit depends on it");
        add_simd(command, simd_);
        command.add_flag("--json", json_, "print the result as JSON");
    }

    void run() override {
        const SimdLevel level = default_simd_level(simd_);
        const std::vector<DigitsOfRun> runs =
            verify_digits({.threads = threads_ > 0 ? threads_ : default_thread_count(), .simd = level});
        const bool right = std::ranges::all_of(runs, &DigitsOfRun::right);
        Document report{
            {{"version", build_info().version}, {"simd", ljmd::name(level)}, {"right", right}, {"runs", Data::list()}},
            fmt::format("ljmd {}, SIMD level {}\n", build_info().version, ljmd::name(level))};
        for (const DigitsOfRun& run : runs) {
            report.data["runs"].push_back(
                {{"problem", run.problem}, {"digits", run.rule}, {"wanted", run.wanted}, {"found", run.found}});
            report.text += fmt::format("  {:<34} {}  {}\n", run.problem, run.found,
                                       run.right() ? "right" : fmt::format("WRONG: {} is right", run.wanted));
        }
        report.text += right ? "All digits are those that this version has on every machine.\n" : "";
        print_document(report, json_);
        if (!right) {
            throw PhysicsError(
                "this program does not compute what this version computes elsewhere: the compiler, its "
                "options or the machine change digits");
        }
    }

  private:
    int threads_ = 0;
    std::string simd_;
    bool json_ = false;
};

}  // namespace

std::shared_ptr<Command> verify_command() {
    return std::make_shared<VerifyCommand>();
}

}  // namespace ljmd
