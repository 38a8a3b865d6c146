#include "ljmd/detail/execution/simd.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "execution/simd_levels.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr std::array level_names{"portable",      "x86-64-v2",       "x86-64-v3", "x86-64-v4",
                                 "x86-64-v4-256", "x86-64-v4-intel", "neon"};

#if defined(__x86_64__)
bool processor_has(SimdLevel level) {
    __builtin_cpu_init();
    const bool v2 = __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt");
    const bool v3 = v2 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                    __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
    switch (level) {
        case SimdLevel::portable:
            return true;
        case SimdLevel::x86_64_v2:
            return v2;
        case SimdLevel::x86_64_v3:
            return v3;
        case SimdLevel::x86_64_v4:
        case SimdLevel::x86_64_v4_256:
        case SimdLevel::x86_64_v4_intel:
            return v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                   __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                   __builtin_cpu_supports("avx512vl");
        case SimdLevel::neon:
            return false;
    }
    return false;
}

/// With AVX-512 the level that is made for this processor, of those that have the same bits as all others.
SimdLevel best_of(SimdLevel highest) {
    if (highest < SimdLevel::x86_64_v4) {
        return highest;
    }
    __builtin_cpu_init();
    // Zen 4: the processors of this family with AVX-512
    return __builtin_cpu_is("amdfam19h") != 0 ? SimdLevel::x86_64_v4_256 : SimdLevel::x86_64_v4;
}
#else
bool processor_has(SimdLevel level) {
    return level == SimdLevel::portable || level == SimdLevel::neon;
}

SimdLevel best_of(SimdLevel highest) {
    return highest;
}
#endif

std::vector<std::string_view> names(const std::vector<SimdLevel>& levels) {
    std::vector<std::string_view> result;
    result.reserve(levels.size());
    for (const SimdLevel level : levels) {
        result.push_back(name(level));
    }
    return result;
}

}  // namespace

std::string_view name(SimdLevel level) {
    return level_names.at(static_cast<std::size_t>(level));
}

std::vector<SimdLevel> compiled_simd_levels() {
    return {simd::levels.begin(), simd::levels.end()};
}

std::vector<SimdLevel> usable_simd_levels() {
    std::vector<SimdLevel> usable;
    usable.reserve(simd::levels.size());
    for (const SimdLevel level : simd::levels) {
        if (processor_has(level)) {
            usable.push_back(level);
        }
    }
    return usable;
}

SimdLevel usable_simd_level(const std::string& wanted) {
    const std::vector<SimdLevel> usable = usable_simd_levels();
    for (const SimdLevel level : usable) {
        if (name(level) == wanted) {
            return level;
        }
    }
    for (const char* known : level_names) {
        if (wanted == known) {
            throw InputError(fmt::format("SIMD level '{}' cannot be used here: this processor and program have {}",
                                         wanted, fmt::join(names(usable), ", ")));
        }
    }
    throw InputError(fmt::format("unknown SIMD level '{}', usable here: {}", wanted, fmt::join(names(usable), ", ")));
}

SimdLevel best_simd_level() {
    return best_of(usable_simd_levels().back());
}

std::optional<SimdLevel> asked_simd_level(const std::string& named) {
    if (!named.empty()) {
        return usable_simd_level(named);
    }
    const char* wanted = std::getenv("LJMD_SIMD");  // NOLINT(concurrency-mt-unsafe): nobody writes the environment
    return wanted != nullptr && *wanted != '\0' ? std::optional(usable_simd_level(wanted)) : std::nullopt;
}

SimdLevel default_simd_level(const std::string& named) {
    return asked_simd_level(named).value_or(best_simd_level());
}

std::string_view name(Precision precision) {
    return precision == Precision::mixed ? "mixed" : "double";
}

Precision precision_of(const std::string& wanted) {
    for (const Precision precision : {Precision::double_precision, Precision::mixed}) {
        if (name(precision) == wanted) {
            return precision;
        }
    }
    throw InputError(fmt::format("unknown precision '{}', allowed: double, mixed", wanted));
}

bool has_common_digits(SimdLevel level) {
    return level != SimdLevel::x86_64_v4_intel;
}

bool fuses_single_precision(SimdLevel level) {
    return level != SimdLevel::portable && level != SimdLevel::x86_64_v2;
}

std::string digits_rule(SimdLevel level, Precision precision) {
    const std::string rule = has_common_digits(level) ? "common-1" : std::string(name(level));
    if (precision == Precision::double_precision) {
        return rule;
    }
    return rule + (fuses_single_precision(level) ? ", mixed" : ", mixed without fused products");
}

SimdLevel level_with_digits_of(const std::string& wanted, Precision precision, const std::vector<SimdLevel>& usable) {
    const auto known = std::ranges::find(level_names, wanted);
    if (known == level_names.end()) {
        return usable_simd_level(wanted);  // which says so
    }
    const auto level = static_cast<SimdLevel>(known - level_names.begin());
    std::optional<SimdLevel> found;
    for (const SimdLevel here : usable) {
        if (here == level) {
            return level;
        }
        found = digits_rule(here, precision) == digits_rule(level, precision) ? here : found;
    }
    return found ? *found : usable_simd_level(wanted);
}

}  // namespace ljmd
