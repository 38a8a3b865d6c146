#pragma once

#include <string>
#include <vector>
#include "catch.hpp"

#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/model/box.hpp"

// The box of the tests of scattering functions, and their tables by name.

namespace ljmd::test {

inline constexpr double edge = 8.0;
inline const Box cube(Vec3(edge, edge, edge));
inline constexpr double density = 0.8;

inline const DataTable& table(const std::vector<DataTable>& tables, const std::string& name) {
    for (const DataTable& each : tables) {
        if (each.name == name) {
            return each;
        }
    }
    FAIL("no table " << name);
    return tables.front();
}

}  // namespace ljmd::test
