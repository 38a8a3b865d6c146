#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "compare/lammps.hpp"
#include "compare/lammps_input.hpp"
#include "compare/lammps_output.hpp"
#include "execution/thread_team.hpp"
#include "io/files/input_file.hpp"
#include "io/files/output_file.hpp"
#include "io/files/process.hpp"
#include "io/files/scratch_directory.hpp"
#include "io/files/shown_path.hpp"
#include "io/formats/lammps_dump.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

constexpr const char* method_name = "fix nve";
constexpr const char* log_name = "log.lammps";
const std::vector<std::string> unwrapped{"xu", "yu", "zu"};

/// The last `bytes` bytes of a file.
std::string end_of(const fs::path& path, std::streamoff bytes) {
    std::ifstream file = open_input(path);
    const auto size = static_cast<std::streamoff>(file.seekg(0, std::ios::end).tellg());
    file.seekg(std::max<std::streamoff>(0, size - bytes));
    std::string text(static_cast<std::size_t>(std::clamp<std::streamoff>(size, 0, bytes)), '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    return text;
}

/// The last lines of a file, indented.
std::string last_lines(const fs::path& path) {
    constexpr int lines = 8;
    constexpr std::streamoff enough = 4096;
    std::string text = end_of(path, enough);
    text.erase(text.find_last_not_of('\n') + 1);
    std::size_t begin = text.size();
    for (int line = 0; line < lines && begin != 0; ++line) {
        const std::size_t end_before = text.rfind('\n', begin - 1);
        begin = end_before == std::string::npos ? 0 : end_before;
    }
    std::string result;
    for (const char c : text.substr(begin == 0 ? 0 : begin + 1)) {
        result += c;
        if (c == '\n') {
            result += "  ";
        }
    }
    return "  " + result;
}

/// Whether GNU's or LLVM's OpenMP says that the system refuses it a thread.
bool lacks_threads(const std::string& words) {
    return words.find("libgomp: Thread creation failed") != std::string::npos ||
           words.find("unable to allocate necessary resources for OMP thread") != std::string::npos;
}

fs::path find_lammps() {
    const char* wanted = std::getenv("LJMD_LAMMPS");
    const std::string name = wanted != nullptr && *wanted != '\0' ? wanted : "lmp";
    const std::optional<fs::path> path = find_program(name);
    if (!path) {
        throw InputError(
            fmt::format("there is no program '{}', which was to run LAMMPS\n"
                        "  Debian and Ubuntu: apt-get install lammps; a LAMMPS of another name: LJMD_LAMMPS=its path",
                        name));
    }
    return *path;
}

LammpsVersion ask_version(const fs::path& program) {
    const ScratchDirectory scratch;
    const int status =
        run_process({.program = program, .arguments = {"-h"}, .directory = scratch.path(), .output = "help"});
    constexpr std::streamoff all = 1 << 20;
    const std::optional<LammpsVersion> version = lammps_version(end_of(scratch.path() / "help", all));
    if (status != 0 || !version) {
        throw InputError(fmt::format("'{} -h' does not answer as LAMMPS does:\n{}", program.string(),
                                     last_lines(scratch.path() / "help")));
    }
    return *version;
}

class LammpsPeer : public Peer {
  private:
    /// What `read` makes of the files that LAMMPS leaves in its directory. Messages name them as "LAMMPS' log.lammps".
    template <class Read>
    auto after_run(const std::string& input, const Read& read) const {
        const ScratchDirectory scratch;
        return read_as(scratch.path() / "", "LAMMPS' ", [&] {
            run(scratch.path(), input);
            return read(scratch.path());
        });
    }

  public:
    LammpsPeer(const Fluid& fluid, int threads)
        : fluid_(fluid), program_(find_lammps()), version_(ask_version(program_)), threads_(threads) {
        // Refuse unsupported potentials now.
        static_cast<void>(lammps_pair_style(fluid.potential));
    }

    [[nodiscard]] std::string name() const override {
        return fmt::format("LAMMPS {}{}", version_.version,
                           version_.openmp ? fmt::format(", {} threads", threads_) : "");
    }

    [[nodiscard]] std::vector<PeerMethod> methods() const override {
        return {{method_name, {"velocity-verlet", "leapfrog"}}};
    }

    [[nodiscard]] PeerPoint point() override {
        return after_run(lammps_point_input(fluid_), [&](const fs::path& directory) {
            LammpsLog log(directory / log_name);
            LammpsDump forces(directory / LammpsFiles::forces);
            PeerPoint point{totals(required_row(log, 0)), next_vectors(forces, 0, {"fx", "fy", "fz"})};
            if (const std::optional<LammpsRow> with_tail = log.next_row()) {
                const Totals all = totals(*with_tail);
                point.tail_energy = (all.potential_energy - point.totals.potential_energy) /
                                    static_cast<double>(fluid_.positions.size());
                point.tail_pressure = (all.virial - point.totals.virial) / (3.0 * fluid_.edges.prod());
            }
            return point;
        });
    }

    [[nodiscard]] std::vector<PeerFrame> follow(const std::string& method, double time_step,
                                                const std::vector<Index>& steps) override {
        if (method != method_name) {
            throw ContractViolation(fmt::format("LAMMPS has no method '{}'", method));
        }
        return after_run(lammps_follow_input(fluid_, time_step, steps), [&](const fs::path& directory) {
            LammpsLog log(directory / log_name);
            LammpsDump dump(directory / LammpsFiles::frames);
            std::vector<PeerFrame> frames;
            frames.reserve(steps.size());
            for (const Index step : steps) {
                const LammpsRow row = required_row(log, step);
                frames.push_back({step, row.potential_energy, row.kinetic_energy, next_vectors(dump, step, unwrapped)});
            }
            return frames;
        });
    }

    void sample(double time_step, Index steps, Index every, Index frame_every, const Visitor& visit) override {
        after_run(lammps_sample_input(fluid_, time_step, steps, every, frame_every), [&](const fs::path& directory) {
            LammpsLog log(directory / log_name);
            std::optional<LammpsDump> dump;
            if (frame_every > 0) {
                dump.emplace(directory / LammpsFiles::frames);
                static_cast<void>(next_vectors(*dump, 0, unwrapped));
            }
            for (Index step = every; step <= steps; step += every) {
                const Totals row = totals(required_row(log, step));
                if (dump && step % frame_every == 0) {
                    const std::vector<Vec3> positions = next_vectors(*dump, step, unwrapped);
                    visit(step, row, &positions);
                } else {
                    visit(step, row, nullptr);
                }
            }
        });
    }

    [[nodiscard]] double seconds(double time_step, Index steps) override {
        return after_run(lammps_sample_input(fluid_, time_step, steps, 0, 0), [](const fs::path& directory) {
            LammpsLog log(directory / log_name);
            while (log.next_row()) {
            }
            return log.loop_seconds();
        });
    }

  private:
    void run(const fs::path& directory, const std::string& input) const {
        write_file(directory / LammpsFiles::start, lammps_data(fluid_));
        write_file(directory / "in.lammps", input);
        // With no log file, everything goes to stdout, together with messages of MPI.
        std::vector<std::string> arguments{"-in", "in.lammps", "-log", "none"};
        if (version_.openmp) {
            for (const char* argument : {"-suffix", "omp", "-package", "omp"}) {
                arguments.emplace_back(argument);
            }
            arguments.push_back(std::to_string(threads_));
        }
        const int status =
            run_process({.program = program_,
                         .arguments = arguments,
                         .directory = directory,
                         .output = log_name,
                         .environment = {{"OMP_NUM_THREADS", std::to_string(version_.openmp ? threads_ : 1)}}});
        if (status != 0) {
            const std::string words = last_lines(directory / log_name);
            if (version_.openmp && lacks_threads(words)) {
                throw ThreadsError(
                    fmt::format("LAMMPS did not get the {} threads that were asked for; ask for fewer "
                                "(--threads, OMP_NUM_THREADS), or see the limits of processes and "
                                "memory (ulimit -a):\n{}",
                                threads_, words));
            }
            throw DataError(fmt::format("LAMMPS failed with exit status {}:\n{}", status, words));
        }
    }

    static void write_file(const fs::path& path, const std::string& text) {
        OutputFile file(path);
        file.write(text);
        file.close();
    }

    /// The row of a step. Runs in pieces repeat the step at which they continue, and may print steps that were not
    /// requested.
    static LammpsRow required_row(LammpsLog& log, Index step) {
        while (const std::optional<LammpsRow> row = log.next_row()) {
            if (row->step == step) {
                return *row;
            }
            if (row->step > step) {
                break;
            }
        }
        throw DataError(fmt::format("LAMMPS' log has no row of step {}", step));
    }

    /// The vectors of the next frame by id; the frame must be the step's.
    [[nodiscard]] std::vector<Vec3> next_vectors(LammpsDump& dump, Index step,
                                                 const std::vector<std::string>& columns) const {
        if (!dump.next_frame(atoms())) {
            throw DataError(fmt::format("LAMMPS' dump ends before step {}", step));
        }
        if (dump.step() != step) {
            throw DataError(fmt::format("LAMMPS dumped step {} where step {} was expected", dump.step(), step));
        }
        const LammpsDump::Rows rows = dump.read_atoms(columns);
        std::vector<Vec3> vectors;
        for (Index atom = 0; atom < rows.rows(); ++atom) {
            vectors.emplace_back(rows.row(atom));
        }
        return vectors;
    }

    [[nodiscard]] Totals totals(const LammpsRow& row) const {
        return {row.potential_energy, row.kinetic_energy, 3.0 * fluid_.edges.prod() * row.virial_pressure};
    }

    [[nodiscard]] Index atoms() const { return static_cast<Index>(fluid_.positions.size()); }

    Fluid fluid_;
    fs::path program_;
    LammpsVersion version_;
    int threads_;
};

}  // namespace

std::unique_ptr<Peer> make_lammps_peer(const Fluid& fluid, int threads) {
    return std::make_unique<LammpsPeer>(fluid, threads);
}

}  // namespace ljmd
