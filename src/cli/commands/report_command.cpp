#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iterator>
#include <thread>

#include "cli/command.hpp"
#include "cli/deck_options.hpp"
#include "cli/signals.hpp"
#include "cli/streams.hpp"
#include "compare/recorded_comparison.hpp"
#include "io/files/directory_lock.hpp"
#include "io/files/file_system.hpp"
#include "io/files/input_file.hpp"
#include "io/files/process.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "report/page.hpp"
#include "report/report.hpp"
#include "report/written_report.hpp"
#include "run/run_directory.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// Options of `ljmd report`.
struct ReportOptions {
    std::vector<std::string> directories = {};
    std::string out = {};  ///< file; empty: report.html in the directory, or in the working directory for several
    bool force = false;    ///< replace a file that is no page of ljmd
    bool open = false;     ///< open the page in a browser
    bool json = false;     ///< print the page's data instead of writing a page
    bool follow = false;   ///< write the page anew while the run goes on
    double every = 5.0;    ///< [s]
};

/// Open a page in the browser of the desktop, if there is one.
void open_page(const fs::path& page) {
    const auto opener = find_program("xdg-open");
    const bool has_desktop = std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
    const std::string by_hand = fmt::format("open {} in a browser", page.string());
    if (!opener || !has_desktop) {
        warn(fmt::format("{}: {}", opener ? "there is no desktop here" : "there is no xdg-open", by_hand));
        return;
    }
    // Nobody waits for it: an opener may be the browser itself, and live longer than this program.
    const ChildProcess detached({.program = *opener,
                                 .arguments = {files::absolute(page).string()},
                                 .directory = ".",
                                 .output = "/dev/null",
                                 .own_group = true,
                                 .at_our_end = 0});
}

/// Write the page anew while the run goes on, and once more when it has ended. @throws Interrupted on a signal
void follow(const fs::path& directory, const fs::path& page, const ReportOptions& options) {
    constexpr std::chrono::milliseconds moment{20};
    const Interruption interruption = until_signal();
    bool force = options.force;
    bool is_first = true;
    for (;;) {
        const FollowedReport report = write_followed_report(directory, page, force, options.every);
        force = false;  // what lies there now is a page
        if (is_first) {
            print_result(fmt::format("{}\n", page.string()));
            if (options.open) {
                open_page(page);
            }
        }
        is_first = false;
        if (!report.is_running) {
            for (const std::string& warning : report.warnings) {
                warn(warning);
            }
            return;
        }
        const auto next = std::chrono::steady_clock::now() + std::chrono::duration<double>(options.every);
        while (std::chrono::steady_clock::now() < next && DirectoryLock::is_held(directory)) {
            if (interruption.request()) {
                interruption.stop_many_runs();
            }
            std::this_thread::sleep_for(moment);
        }
    }
}

/// The directory that is meant by a path: for judge.json itself, the one that holds it.
fs::path directory_of(const std::string& path) {
    const fs::path whole = path;
    const bool is_result =
        is_comparison_result(whole.filename().string()) && input_is_there(whole) && !input_is_directory(whole);
    return !is_result ? whole : whole.has_parent_path() ? whole.parent_path() : fs::path(".");
}

class ReportCommand : public Command {
  public:
    ReportCommand()
        : Command("report", Part::results,
                  "write one HTML page about a run, a sweep, a reproduced table or a comparison, or about several") {}

    void add_options(CLI::App& command) override {
        command
            .add_option("directory", options_.directories,
                        "directory of a run, a sweep, a reproduced table, a comparison")
            ->required()
            ->type_name("RUN");
        command
            .add_option("--out", options_.out,
                        "file to write, RUN/report.html by default; for several report.html in the working directory")
            ->type_name("FILE");
        command.add_flag("--force", options_.force, "replace a file that is no page of ljmd");
        CLI::Option* opened = command.add_flag("--open", options_.open, "open the page in a browser");
        CLI::Option* followed =
            command.add_flag("--follow", options_.follow,
                             "write the page of a run anew while it goes on; an open page reads itself anew");
        command.add_option("--every", options_.every, "seconds from one page to the next, 5 by default")
            ->needs(followed)
            ->type_name("S");
        command.add_flag("--json", options_.json, "print the data of the page as JSON, and write no page")
            ->excludes(opened)
            ->excludes(followed);
    }

    void run() override {
        std::vector<fs::path> directories;
        directories.reserve(options_.directories.size());
        std::ranges::transform(options_.directories, std::back_inserter(directories), directory_of);
        if (options_.json) {
            print_result(to_json_line(page_data(report_on(directories))) + "\n");
            return;
        }
        const fs::path page = !options_.out.empty()    ? fs::path(options_.out)
                              : directories.size() > 1 ? fs::path(report_name)
                                                       : directories.front() / report_name;
        if (options_.follow) {
            if (directories.size() > 1) {
                throw InputError("--follow is for one run");
            }
            if (!(options_.every >= 0.01 && options_.every <= 3600.0)) {
                throw InputError(fmt::format("--every is {}, allowed: 0.01 to 3600 seconds", options_.every));
            }
            install_stop_handlers();
            follow(directories.front(), page, options_);
            return;
        }
        for (const std::string& warning : write_report(directories, page, options_.force)) {
            warn(warning);
        }
        print_result(fmt::format("{}\n", page.string()));
        if (options_.open) {
            open_page(page);
        }
    }

  private:
    ReportOptions options_;
};

}  // namespace

std::shared_ptr<Command> report_command() {
    return std::make_shared<ReportCommand>();
}

}  // namespace ljmd
