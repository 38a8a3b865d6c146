#include "execution/ranks.hpp"

#include <cstdlib>
#include <cstring>
#include <string>

namespace ljmd {

namespace {

class Alone : public Ranks {
  public:
    Alone() : Ranks(0, 1) {}
    void sum(std::span<std::int64_t> /*numbers*/) override {}
    void largest(std::span<double> /*numbers*/) override {}
    [[nodiscard]] std::vector<Bytes> exchange(std::vector<Bytes> messages) override { return messages; }
    void begin_exchange(std::span<const Outgoing> /*outgoing*/, std::span<const Incoming> /*incoming*/) override {}
    void finish_exchange() override {}
    [[noreturn]] void abandon(int exit_code) override { std::exit(exit_code); }
};

}  // namespace

void fail_together(Ranks& ranks, const std::function<void()>& work) {
    if (ranks.alone()) {
        work();
        return;
    }
    std::string why;
    try {
        work();
    } catch (const PhysicsError& error) {
        why = error.what();
    }
    std::int64_t failures = why.empty() ? 0 : 1;
    ranks.sum({&failures, 1});
    if (failures == 0) {
        return;
    }
    Ranks::Bytes words(why.size());
    std::memcpy(words.data(), why.data(), why.size());
    for (const Ranks::Bytes& of_rank :
         ranks.exchange(std::vector<Ranks::Bytes>(static_cast<std::size_t>(ranks.size()), words))) {
        if (!of_rank.empty()) {
            throw PhysicsError(std::string(reinterpret_cast<const char*>(of_rank.data()), of_rank.size()));
        }
    }
}

Ranks& no_other_ranks() {
    static Alone alone;
    return alone;
}

}  // namespace ljmd
