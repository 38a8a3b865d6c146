// What one thread of this machine can do at most, printed as JSON: fused multiply-adds in double and single precision
// [flop/s], and reading from the second-level cache and from memory [byte/s]. Compile with -O3 -march=native.
//
// Each figure is the best of several trials. Vectors are gcc's (vector_size), as wide as the instruction set allows.

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <vector>

namespace {

#if defined(__AVX512F__)
constexpr std::size_t vector_bytes = 64;
#elif defined(__AVX__)
constexpr std::size_t vector_bytes = 32;
#else
constexpr std::size_t vector_bytes = 16;
#endif
constexpr std::size_t chains = 12;  // independent ones: more than latency times throughput of the units, few enough
                                    // for the registers
constexpr int trials = 7;

template <class Real>
struct Vector {
    using type __attribute__((vector_size(vector_bytes))) = Real;
    static constexpr std::size_t width = vector_bytes / sizeof(Real);
};

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The compiler must take it that `x` is read and changed here: nothing is computed ahead or left out.
template <class T>
void hold(T& x) {
    asm volatile("" : "+x"(x));
}

/// Largest value of `measure()` over the trials.
template <class Measure>
double best(Measure measure) {
    double most = 0.0;
    for (int trial = 0; trial < trials; ++trial) most = std::max(most, measure());
    return most;
}

/// Fused multiply-adds in independent chains; each counts as two operations a number.
template <class Real>
double multiply_add_rate() {
    using V = typename Vector<Real>::type;
    std::array<V, chains> x{};
    for (std::size_t k = 0; k < chains; ++k) x[k] += static_cast<Real>(k);  // like chains would be computed once
    V factor = V{} + Real(0.999);
    V term = V{} + Real(0.001);
    hold(factor);
    hold(term);
    constexpr std::size_t rounds = 20'000'000;
    const double began = now();
    for (std::size_t round = 0; round < rounds; ++round) {
#pragma GCC unroll 12
        for (std::size_t k = 0; k < chains; ++k) x[k] = x[k] * factor + term;
    }
    const double seconds = now() - began;
    for (V& value : x) hold(value);
    return 2.0 * static_cast<double>(rounds * chains * Vector<Real>::width) / seconds;
}

/// Reading all of an array, `passes` times.
double read_rate(const std::vector<Vector<double>::type>& data, std::size_t passes) {
    using V = Vector<double>::type;
    constexpr std::size_t sums_at_a_time = 8;
    const std::size_t count = data.size() / sums_at_a_time * sums_at_a_time;
    std::array<V, sums_at_a_time> sums{};
    const double began = now();
    for (std::size_t pass = 0; pass < passes; ++pass) {
        const V* begin = data.data();
        asm volatile("" : "+r"(begin) : : "memory");
        for (const V* block = begin; block != begin + count; block += sums_at_a_time) {
#pragma GCC unroll 8
            for (std::size_t k = 0; k < sums_at_a_time; ++k) sums[k] += block[k];
        }
    }
    const double seconds = now() - began;
    for (V& sum : sums) hold(sum);
    return static_cast<double>(passes * count * sizeof(V)) / seconds;
}

/// Best rate of reading an array of `bytes`, where a trial reads about `total` bytes.
double best_read_rate(std::size_t bytes, std::size_t total) {
    using V = Vector<double>::type;
    const std::vector<V> data(bytes / sizeof(V), V{} + 1.0);
    return best([&] { return read_rate(data, std::max<std::size_t>(1, total / bytes)); });
}

/// Bytes of a cache; `otherwise` where the system does not say.
std::size_t cache_bytes(int name, std::size_t otherwise) {
    const long bytes = sysconf(name);
    return bytes > 0 ? static_cast<std::size_t>(bytes) : otherwise;
}

}  // namespace

int main() {
    constexpr std::size_t mebibyte = std::size_t{1} << 20;
    const std::size_t second_level = cache_bytes(_SC_LEVEL2_CACHE_SIZE, mebibyte / 2);
    const std::size_t third_level = cache_bytes(_SC_LEVEL3_CACHE_SIZE, 32 * mebibyte);
    const std::size_t in_memory = std::max(256 * mebibyte, 4 * third_level);
    std::printf("{\n");
    std::printf("  \"vector_bytes\": %zu,\n", vector_bytes);
    std::printf("  \"double_flops\": %.6g,\n", best(multiply_add_rate<double>));
    std::printf("  \"single_flops\": %.6g,\n", best(multiply_add_rate<float>));
    std::printf("  \"l2_bytes\": %zu,\n", second_level);
    std::printf("  \"l2_read\": %.6g,\n", best_read_rate(second_level / 2, 4096 * mebibyte));
    std::printf("  \"memory_read\": %.6g\n", best_read_rate(in_memory, in_memory));
    std::printf("}\n");
}
