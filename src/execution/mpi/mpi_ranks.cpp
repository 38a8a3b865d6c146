#include <mpi.h>

#include <limits>
#include <memory>
#include <utility>

#include "execution/mpi_module.hpp"
#include "execution/ranks.hpp"

// The module that the program loads when mpirun has started it: all that needs the MPI library.

namespace ljmd {

namespace {

constexpr int of_positions = 1;  // tag of messages whose length both ranks know

/// Messages of more bytes than an int counts are sent in pieces.
constexpr std::size_t largest_piece = std::size_t{1} << 30;

class MpiRanks : public Ranks {
  public:
    MpiRanks(int rank, int size) : Ranks(rank, size) {}
    ~MpiRanks() override { MPI_Finalize(); }
    MpiRanks(const MpiRanks&) = delete;
    MpiRanks& operator=(const MpiRanks&) = delete;

    void sum(std::span<std::int64_t> numbers) override {
        MPI_Allreduce(MPI_IN_PLACE, numbers.data(), static_cast<int>(numbers.size()), MPI_INT64_T, MPI_SUM,
                      MPI_COMM_WORLD);
    }

    void largest(std::span<double> numbers) override {
        MPI_Allreduce(MPI_IN_PLACE, numbers.data(), static_cast<int>(numbers.size()), MPI_DOUBLE, MPI_MAX,
                      MPI_COMM_WORLD);
    }

    [[nodiscard]] std::vector<Bytes> exchange(std::vector<Bytes> messages) override {
        const auto count = static_cast<std::size_t>(size());
        std::vector<std::int64_t> lengths(count);
        for (std::size_t k = 0; k < count; ++k) {
            lengths[k] = static_cast<std::int64_t>(messages[k].size());
        }
        std::vector<std::int64_t> expected(count);
        MPI_Alltoall(lengths.data(), 1, MPI_INT64_T, expected.data(), 1, MPI_INT64_T, MPI_COMM_WORLD);
        std::vector<Bytes> received(count);
        Requests requests;
        for (std::size_t k = 0; k < count; ++k) {
            received[k].resize(static_cast<std::size_t>(expected[k]));
            if (static_cast<int>(k) == rank()) {
                received[k] = std::move(messages[k]);
                continue;
            }
            requests.receive(received[k].data(), received[k].size(), static_cast<int>(k));
            requests.send(messages[k].data(), messages[k].size(), static_cast<int>(k));
        }
        requests.wait();
        return received;
    }

    void begin_exchange(std::span<const Outgoing> outgoing, std::span<const Incoming> incoming) override {
        for (const Incoming& each : incoming) {
            under_way_.receive(reinterpret_cast<std::byte*>(each.numbers.data()), each.numbers.size_bytes(), each.from);
        }
        for (const Outgoing& each : outgoing) {
            under_way_.send(reinterpret_cast<const std::byte*>(each.numbers.data()), each.numbers.size_bytes(),
                            each.to);
        }
    }

    void finish_exchange() override { under_way_.wait(); }

    [[noreturn]] void abandon(int exit_code) override {
        MPI_Abort(MPI_COMM_WORLD, exit_code);
        std::abort();
    }

  private:
    /// Messages that are under way.
    class Requests {
      public:
        void send(const std::byte* bytes, std::size_t size, int to) {
            for (std::size_t done = 0; done < size; done += largest_piece) {
                MPI_Isend(bytes + done, piece(size - done), MPI_BYTE, to, of_positions, MPI_COMM_WORLD, next());
            }
        }
        void receive(std::byte* bytes, std::size_t size, int from) {
            for (std::size_t done = 0; done < size; done += largest_piece) {
                MPI_Irecv(bytes + done, piece(size - done), MPI_BYTE, from, of_positions, MPI_COMM_WORLD, next());
            }
        }
        void wait() {
            MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
            requests_.clear();
        }

      private:
        static int piece(std::size_t bytes) { return static_cast<int>(std::min(bytes, largest_piece)); }
        MPI_Request* next() { return &requests_.emplace_back(); }

        std::vector<MPI_Request> requests_;
    };

    Requests under_way_;  ///< of begin_exchange()
};

}  // namespace

extern "C" __attribute__((visibility("default"))) Ranks* ljmd_join_ranks() {
    int provided = 0;
    if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided) != MPI_SUCCESS) {
        return nullptr;
    }
    int rank = 0;
    int size = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    return new MpiRanks(rank, size);
}

}  // namespace ljmd
