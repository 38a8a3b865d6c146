#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/compare/crosscheck.hpp"

namespace ljmd {

/// What the commands that take a deck have in common.
struct DeckOptions {
    std::string deck;
    std::vector<std::string> settings;  ///< of --set
    bool force = false;
    bool quiet = false;
    bool json = false;
    std::string precision{};  ///< replaces the deck's unless empty
    std::string simd{};       ///< SIMD level to use; empty: LJMD_SIMD, else the highest
    int threads = 0;          ///< 0: OMP_NUM_THREADS, or 1
};

/// What `ljmd resume` takes.
struct ResumeOptions {
    std::string directory;
    std::string walltime;
    Index more_steps = 0;  ///< to add to the last stage
    int threads = 0;       ///< 0: as many as before
    bool quiet = false;
    bool json = false;
};

/// What `ljmd eos` takes.
struct EosOptions {
    std::string model{};  ///< empty: thol2016
    std::optional<double> temperature{};
    std::optional<double> density{};
    bool json = false;
};

/// What `ljmd reproduce` takes.
struct ReproduceOptions {
    std::string what;                 ///< "verlet1967"
    std::string out;                  ///< directory
    std::vector<std::string> rows{};  ///< "RHO" or "RHO:T"; empty: all
    int jobs = 0;                     ///< rows at a time; 0: as many as there are processors
    bool quick = false;               ///< as short as Verlet's own runs
    bool force = false;
    bool quiet = false;
    bool json = false;
};

/// What `ljmd sweep` takes. Points come from `grids` or from `list`.
struct SweepOptions {
    std::string deck;
    std::vector<std::string> grids{};     ///< "KEY=FROM:TO:COUNT,KEY=A|B|C", see grid_points()
    std::string list{};                   ///< CSV file, see list_points()
    std::vector<std::string> settings{};  ///< of --set
    std::string out{};                    ///< directory; empty: runs/<deck>-sweep
    int jobs = 0;                         ///< points at a time; 0: as many as there are processors
    bool force = false;
    bool quiet = false;
    bool json = false;
};

/// What `ljmd analyze` takes.
struct AnalyzeOptions {
    std::string path;                     ///< directory of a run, or a trajectory
    std::vector<std::string> names{};     ///< of analyses, and "thermo"; empty: the usual ones
    std::string deck{};                   ///< of a trajectory; empty: none
    std::vector<std::string> settings{};  ///< of --set
    std::optional<double> from{};         ///< time [tau]
    std::optional<double> time_step{};    ///< for frames without times [tau]
    std::string group{};                  ///< of particles in an H5MD file; empty: the only one
    std::string positions{};              ///< "wrapped", "unwrapped"; empty: the file or the displacements tell
    std::string xyz_comment{};            ///< what the comment lines of an extended XYZ file lack
    std::string out{};                    ///< directory for the tables
    bool force = false;
    bool json = false;
};

// Each command prints results to stdout and talk to stderr, and throws the typed errors of core/errors.hpp.

/// ljmd run DECK
/// @param out       replaces the deck's output directory unless empty
/// @param walltime  stop after that much time, "2h"; empty: no limit
void run_command(const DeckOptions& options, const std::string& out, const std::string& walltime = "");

/// ljmd resume RUNDIR: go on with a run from its last checkpoint.
void resume_command(const ResumeOptions& options);

/// ljmd check DECK
void check_command(const DeckOptions& options);

/// ljmd compare DECK --with PROGRAM
/// @param compared  its `with` is "gsl" for a few-body deck (the integrators against an adaptive solution of high
///                  order), "openmm" or "lammps" for a fluid; the rest is for a fluid
/// @param out       directory for the files of the comparison; empty: it is only printed
void compare_command(const DeckOptions& options, const CrosscheckOptions& compared, const std::string& out);

/// ljmd export DECK|RUNDIR --to TARGET: the start of a deck, or the last configuration of a run, for other programs
/// @param to   one of export_targets()
/// @param out  directory for its files; empty: <name of the deck or run>-<target>
void export_command(const DeckOptions& options, const std::string& to, const std::string& out);

/// ljmd bench [DECK]: how fast a deck runs. An empty options.deck means the Lennard-Jones melt.
void bench_command(const DeckOptions& options);

/// ljmd eos: the equations of state there are; with a temperature, liquid and vapour at coexistence; with a density
/// too, the state of one phase. What lies outside of the range that an equation was fitted to is warned of.
void eos_command(const EosOptions& options);

/// ljmd reproduce verlet1967: the rows of the paper's table, each by a run of its own, compared with the printed values
/// and with equations of state. Rows that are done are kept, those that were stopped are gone on with.
void reproduce_command(const ReproduceOptions& options);

/// ljmd sweep DECK: one deck at many settings, each by a run of its own. Points that are done are kept, those that were
/// stopped are gone on with, those that have failed are tried again.
void sweep_command(const SweepOptions& options);

/// ljmd analyze RUNDIR: where the sampled stages of a run have come to equilibrium, and how many independent samples
/// are left (thermo). Nothing is written; the run may still be going on.
/// ljmd analyze RUNDIR|TRAJECTORY rdf msd ...: what [analysis] of a deck asks for during a run, measured on the frames
/// of a trajectory; thermo of a trajectory: energies and pressures of its frames. Writes the tables that a run writes.
void analyze_command(const AnalyzeOptions& options);

/// What `ljmd info` is to tell of, one of them; by default the program.
struct InfoOptions {
    std::string directory = {};  ///< of a run or a study
    bool keys = false;           ///< the reference page of all keys of a deck, in Markdown
    bool schema = false;         ///< a JSON Schema of decks
    bool json = false;           ///< the program or the directory, as JSON
};

void info_command(const InfoOptions& options);

}  // namespace ljmd
