#include "cli/ranks.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <exception>
#include <optional>

#include "cli/exit_code.hpp"
#include "cli/streams.hpp"
#include "deck/deck_system.hpp"
#include "execution/launched_ranks.hpp"
#include "execution/mpi_module.hpp"
#include "execution/rank_agreement.hpp"
#include "integrators/integrator.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/run/interruption.hpp"
#include "model/checksum.hpp"
#include "neighbors/verlet_list.hpp"
#include "run/run_record.hpp"

namespace ljmd {

namespace {

std::optional<std::shared_ptr<Ranks>> joined_ranks;
bool ends_together = false;  ///< all ranks end because of the present error

/// Why ranks cannot share the run of a deck; empty if they can.
std::string unshareable(const Deck& deck) {
    if (!deck.is_fluid()) {
        return "is of few bodies, which one process computes";
    }
    if (deck.neighbors().method != VerletList::name) {
        return fmt::format("finds pairs by method = \"{}\": ranks share a {}", deck.neighbors().method,
                           VerletList::name);
    }
    for (const Stage& stage : deck.stages()) {
        if (find_integrator(stage.integrator.name).adaptive) {
            return fmt::format("has the integrator {}, which one process computes", stage.integrator.name);
        }
    }
    return {};
}

/// Require that all ranks have read the same as rank 0. Collective.
/// @param checksum  of what this rank has read; at all ranks as long
void require_same_at_all(const std::shared_ptr<Ranks>& ranks, const std::string& checksum, const std::string& what) {
    std::vector<std::int64_t> ours(checksum.begin(), checksum.end());
    std::vector<std::int64_t> of_root(ours.size(), 0);
    if (ranks->is_root()) {
        of_root = ours;
    }
    ranks->sum(of_root);
    std::int64_t different = ours == of_root ? 0 : 1;
    ranks->sum({&different, 1});
    prepare_together(ranks, [&] {
        if (different > 0) {
            throw InputError(fmt::format("{} of {} ranks read another {} than rank 0", different, ranks->size(), what));
        }
    });
}

/// Require that ranks can share the run of a deck, and that all have the same one. Collective.
void require_one_deck(const std::shared_ptr<Ranks>& ranks, const Deck& deck) {
    prepare_together(ranks, [&] {
        if (const std::string why = unshareable(deck); !why.empty()) {
            throw InputError(fmt::format("{} {}", deck.path, why));
        }
    });
    require_same_at_all(ranks, deck_hash(deck), "deck");
}

}  // namespace

ProgramModule mpi_module() {
    return {"MPI", "libopenmpi-dev", "ljmd_mpi.so"};
}

std::shared_ptr<Ranks> launched_ranks(const ProgramModule& mpi) {
    const std::vector<std::string> signs = signs_of_ranks();
    const int expected = launched_processes();
    // The first of several may not be told that there are others: only they can say so.
    if (signs.empty() || (expected == 1 && !mpi.is_there())) {
        return nullptr;
    }
    const auto refuse = [&](const std::string& why) {
        return InputError(
            fmt::format("several processes were started to share one run ({} is set), and {}. Without mpirun, one "
                        "process runs alone",
                        signs.front(), why));
    };
    std::shared_ptr<Ranks> ranks;
    try {
        ranks.reset(mpi.function<decltype(ljmd_join_ranks)>(mpi_module_function)());
    } catch (const InputError& why) {
        throw refuse(why.what());
    }
    if (!ranks) {
        throw refuse("MPI does not begin");
    }
    if (expected > 1 && ranks->size() < expected) {
        throw refuse(
            fmt::format("each of the {} is alone: its part for MPI is for another MPI than that of mpirun", expected));
    }
    return ranks->size() > 1 ? ranks : nullptr;  // a launcher that tells no number may have started one
}

std::shared_ptr<Ranks> shared_ranks() {
    if (!joined_ranks) {
        joined_ranks = launched_ranks(mpi_module());
    }
    return *joined_ranks;
}

void refuse_ranks(const std::string& command) {
    const std::shared_ptr<Ranks> ranks = shared_ranks();
    if (!ranks) {
        return;
    }
    ends_together = true;
    if (!ranks->is_root()) {
        throw RankLost("rank 0 says why");
    }
    throw InputError(
        fmt::format("{} processes were started for one command, and `ljmd {}` shares no work among them: "
                    "`ljmd run` and `ljmd resume` do",
                    ranks->size(), command));
}

void prepare_together(const std::shared_ptr<Ranks>& ranks, const std::function<void()>& work) {
    if (!ranks) {
        work();
        return;
    }
    std::exception_ptr failure;
    try {
        work();
    } catch (...) {
        failure = std::current_exception();
    }
    // The first rank that has failed says why.
    double first = failure ? -ranks->rank() : -static_cast<double>(ranks->size());
    ranks->largest({&first, 1});
    if (first == -static_cast<double>(ranks->size())) {
        return;
    }
    ends_together = true;
    if (failure && first == -static_cast<double>(ranks->rank())) {
        std::rethrow_exception(failure);
    }
    throw RankLost("another rank says why");
}

std::string agreed_simd(const std::shared_ptr<Ranks>& ranks, const std::string& named) {
    if (!ranks) {
        return named;
    }
    std::optional<SimdLevel> asked;
    prepare_together(ranks, [&] { asked = asked_simd_level(named); });
    AgreedLevel agreed{};
    prepare_together(ranks, [&] { agreed = agreed_level(*ranks, asked); });
    if (agreed.differs && ranks->is_root()) {
        warn(fmt::format("not all ranks would take the same SIMD level: all compute with {}", name(agreed.level)));
    }
    return std::string(name(agreed.level));
}

void require_shareable(const std::shared_ptr<Ranks>& ranks, const Deck& deck, const CheckedRun& run) {
    if (!ranks) {
        return;
    }
    require_one_deck(ranks, deck);
    if (run.start->configuration) {
        require_same_at_all(ranks, checksum(*run.start->configuration), "start file");
    }
}

void require_shareable(const std::shared_ptr<Ranks>& ranks, const HeldRun& run) {
    if (!ranks) {
        return;
    }
    require_one_deck(ranks, run.deck());
    prepare_together(ranks, [&] { static_cast<void>(agreed_level(*ranks, run.execution().simd())); });
    require_same_at_all(ranks, run.checkpoint_hash(), "checkpoint");
}

int end_after_exception() {
    constexpr int lost = 8;
    if (!joined_ranks || !*joined_ranks) {
        return report_current_exception();
    }
    Ranks& ranks = **joined_ranks;
    bool found_by_all = false;
    try {
        throw;
    } catch (const RankLost&) {
        return ends_together ? 0 : lost;  // the job ends with the code of the rank that says why
    } catch (const PhysicsError&) {
        found_by_all = true;
    } catch (const Interrupted&) {
        found_by_all = true;
    } catch (...) {
    }
    const int exit_code = report_current_exception(!found_by_all || ranks.is_root());
    if (!found_by_all && !ends_together) {
        ranks.abandon(ranks.is_root() ? exit_code : lost);
    }
    return exit_code;
}

}  // namespace ljmd
