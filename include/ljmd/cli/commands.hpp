#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/cli/studies/study_mode.hpp"
#include "ljmd/compare/crosscheck.hpp"

namespace ljmd {

/// Common options of the commands that take a deck.
struct DeckOptions {
    std::string deck;
    std::vector<std::string> settings;  ///< arguments of --set
    bool force = false;
    bool quiet = false;
    bool json = false;
    std::string precision{};  ///< replaces the deck's unless empty
    std::string simd{};       ///< SIMD level to use; empty: LJMD_SIMD, else the highest
    int threads = 0;          ///< 0: OMP_NUM_THREADS, or 1
};

/// Options of `ljmd resume`.
struct ResumeOptions {
    std::string directory;
    std::string walltime;
    Index more_steps = 0;  ///< added to the last stage
    int threads = 0;       ///< 0: as many as before
    bool quiet = false;
    bool json = false;
};

/// Options of `ljmd eos`.
struct EosOptions {
    std::string model{};        ///< empty: thol2016
    std::string temperature{};  ///< a number, FROM:TO:COUNT or A|B|C; empty: not given. Also those below
    std::string density{};
    std::string pressure{};
    bool csv = false;
    bool json = false;
};

/// Options of `ljmd reproduce`.
struct ReproduceOptions {
    std::string what;                 ///< "verlet1967"; of a worker and for the status the directory
    std::string out;                  ///< directory
    std::vector<std::string> rows{};  ///< "RHO" or "RHO:T"; empty: all
    int jobs = 0;                     ///< rows at a time; 0: the number of processors
    bool quick = false;               ///< as short as Verlet's own runs
    bool force = false;
    bool quiet = false;
    bool json = false;
    StudyMode mode{};
};

/// Options of `ljmd sweep`. Points come from `grids` or from `list`.
struct SweepOptions {
    std::string deck;                     ///< of a worker and for the status the directory
    std::vector<std::string> grids{};     ///< "KEY=FROM:TO:COUNT,KEY=A|B|C", see grid_points()
    std::string list{};                   ///< CSV file, see list_points()
    std::vector<std::string> settings{};  ///< arguments of --set
    std::string out{};                    ///< directory; empty: runs/<deck>-sweep
    int jobs = 0;                         ///< points at a time; 0: the number of processors
    bool force = false;
    bool quiet = false;
    bool json = false;
    StudyMode mode{};
};

/// Options of `ljmd analyze`.
struct AnalyzeOptions {
    std::string path;                     ///< directory of a run, or a trajectory
    std::vector<std::string> names{};     ///< of analyses, and "thermo"; empty: the default ones
    std::string deck{};                   ///< for a trajectory; empty: none
    std::vector<std::string> settings{};  ///< arguments of --set
    std::optional<double> from{};         ///< start of the measurement [tau]
    std::optional<double> time_step{};    ///< for frames without times [tau]
    std::string group{};                  ///< particle group of an H5MD file; empty: the only one
    std::string positions{};    ///< "wrapped", "unwrapped"; empty: determined from the file or the displacements
    std::string xyz_comment{};  ///< keys missing from the comment lines of an extended XYZ file
    std::string out{};          ///< directory for the tables
    bool force = false;
    bool json = false;
};

// Each command prints results to stdout and messages to stderr, and throws the typed errors of core/errors.hpp.

/// ljmd run DECK
/// @param out       replaces the deck's output directory unless empty
/// @param walltime  stop after this time, "2h"; empty: no limit
void run_command(DeckOptions options, const std::string& out, const std::string& walltime = "");

/// ljmd resume RUNDIR: resume a run from its last checkpoint.
void resume_command(const ResumeOptions& options);

/// ljmd check DECK
void check_command(const DeckOptions& options);

/// ljmd compare DECK --with PROGRAM
/// @param compared  its `with` is "gsl" for a few-body deck (compare with an adaptive high-order solution), "openmm" or
/// "lammps" for a fluid; the other options are for fluids
/// @param out       directory for the files of the comparison; empty: only print it
void compare_command(const DeckOptions& options, const CrosscheckOptions& compared, const std::string& out);

/// ljmd export DECK|RUNDIR --to TARGET: export the start of a deck, or the last configuration of a run, to other
/// programs
/// @param to   one of export_targets()
/// @param out     directory for its files; empty: <name of the deck or run>-<target>
/// @param forces  with the forces on the atoms, where the format has them
void export_command(const DeckOptions& options, const std::string& to, const std::string& out, bool forces = false);

/// ljmd bench [DECK]: measure the speed of a deck. An empty options.deck means the Lennard-Jones melt.
void bench_command(const DeckOptions& options);

/// ljmd eos: list the equations of state; with a temperature or a pressure, liquid and vapour at coexistence; with a
/// temperature and a density or a pressure, the state of one phase. Ranges, and --csv, give a table. Warns outside the
/// range that an equation was fitted to.
void eos_command(const EosOptions& options);

/// ljmd reproduce verlet1967: recompute the rows of the paper's table, one run per row, and compare them with the
/// printed values and with equations of state. Finished rows are kept, interrupted ones are resumed.
void reproduce_command(const ReproduceOptions& options);

/// ljmd sweep DECK: run one deck with many settings, one run per point. Finished points are kept, interrupted ones are
/// resumed, failed ones are tried again.
void sweep_command(const SweepOptions& options);

/// ljmd analyze RUNDIR: equilibration of the sampled stages of a run, and the number of independent samples left
/// (thermo). Writes nothing; the run may still be running.
/// ljmd analyze RUNDIR|TRAJECTORY rdf msd ...: the analyses of a deck's [analysis], applied to the frames of a
/// trajectory; thermo of a trajectory: energies and pressures of its frames. Writes the same tables as a run.
void analyze_command(const AnalyzeOptions& options);

/// Options of `ljmd plot`.
struct PlotOptions {
    std::string path;                  ///< a directory, or a table, of ljmd
    std::vector<std::string> names{};  ///< of pictures; empty: all that suit it
    std::string out{};                 ///< file or directory; empty: beside what is drawn
    std::string against{};             ///< key of a sweep on the axis; empty: the last
    int relative_to = 0;               ///< body from which few bodies are seen, counted from 1; 0: the first
    bool force = false;                ///< replace files that are no pictures of ljmd
};

/// ljmd plot DIR|FILE [NAME ...]: draw pictures, by the scripts in analysis/. On success Python takes over the process.
void plot_command(const PlotOptions& options);

/// The subject of `ljmd info`, at most one of these; by default the program.
struct InfoOptions {
    std::string directory = {};  ///< of a run or a study
    bool keys = false;           ///< the reference page of all keys of a deck, in Markdown
    bool schema = false;         ///< a JSON Schema of decks
    bool json = false;           ///< the program or the directory, as JSON
};

void info_command(const InfoOptions& options);

/// Options of `ljmd report`.
struct ReportOptions {
    std::vector<std::string> directories = {};
    std::string out = {};  ///< file; empty: report.html in the directory, or in the working directory for several
    bool force = false;    ///< replace a file that is no page of ljmd
    bool open = false;     ///< open the page in a browser
    bool json = false;     ///< print the page's data instead of writing a page
};

/// ljmd report RUN...: one page about a run, a study or a comparison, or about several.
void report_command(const ReportOptions& options);

/// Options of `ljmd init`.
struct InitOptions {
    std::string file{};             ///< empty: <example>.toml in the working directory
    std::string example = "first";  ///< one of example_names()
    bool force = false;
    bool list = false;  ///< print the examples instead
};

/// ljmd init [FILE]: write a commented deck to begin with. @throws OutputRefused if the file exists, without `force`
void init_command(const InitOptions& options);

}  // namespace ljmd
