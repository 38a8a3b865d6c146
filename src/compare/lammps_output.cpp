#include "compare/lammps_output.hpp"

#include <fmt/format.h>

namespace ljmd {

namespace {

using Fields = std::vector<std::string_view>;

const Fields& table_header() {
    static const Fields header{"Step", "PotEng", "c_kinetic", "c_virial"};
    return header;
}

}  // namespace

std::optional<LammpsRow> LammpsLog::next_row() {
    while (file_.next_line()) {
        split_fields(file_.line(), fields_);
        if (!in_table_) {
            in_table_ = fields_ == table_header();
        } else if (file_.line().starts_with("Loop time of ") && fields_.size() > 3) {
            seconds_ = file_.number(fields_[3], "the time of the loop");
            in_table_ = false;
        } else if (fields_.size() == table_header().size()) {
            return LammpsRow{file_.integer(fields_[0], "the step"), file_.number(fields_[1], "the potential energy"),
                             file_.number(fields_[2], "the kinetic energy"), file_.number(fields_[3], "the virial")};
        } else if (!file_.line().starts_with("WARNING") && !fields_.empty()) {
            file_.fail(
                fmt::format("a row of {} numbers was expected, found {}", table_header().size(), shown(file_.line())));
        }
    }
    if (in_table_) {
        file_.fail("the log ends within a table");
    }
    return std::nullopt;
}

double LammpsLog::loop_seconds() const {
    if (!seconds_) {
        file_.fail_at(0, "no line tells the time of the loop");
    }
    return *seconds_;
}

std::optional<LammpsVersion> lammps_version(const std::string& help) {
    constexpr std::string_view before = "Massively Parallel Simulator - ";
    const std::size_t at = help.find(before);
    if (at == std::string::npos) {
        return std::nullopt;
    }
    const std::size_t begin = at + before.size();
    const std::string version = help.substr(begin, help.find('\n', begin) - begin);
    // The list ends at an empty line. Before September 2021 the package was named USER-OMP.
    const std::size_t list = help.find("Installed packages:");
    bool openmp = false;
    if (list != std::string::npos) {
        const std::size_t first = help.find_first_not_of('\n', help.find('\n', list));
        const std::string packages =
            first == std::string::npos ? "" : help.substr(first, help.find("\n\n", first) - first);
        std::vector<std::string_view> names;
        for (std::size_t line = 0; line < packages.size() && !openmp;) {
            const std::size_t end = std::min(packages.find('\n', line), packages.size());
            split_fields(std::string_view(packages).substr(line, end - line), names);
            for (const std::string_view name : names) {
                openmp = openmp || name == "OPENMP" || name == "USER-OMP";
            }
            line = end + 1;
        }
    }
    return LammpsVersion{version, openmp};
}

}  // namespace ljmd
