#pragma once

#include <map>
#include <string>
#include <string_view>

namespace ljmd {

/// Checks that all atoms of a file, in all frames, are of one kind, because ljmd has no mixtures. The readers of all
/// formats pass it every value of every column that distinguishes kinds.
class OneKind {
  public:
    /// Whether a column of a dump, a property of extended XYZ or an element of H5MD distinguishes kinds of atoms:
    /// species, element, type, mass, atomic number, size; in any case.
    [[nodiscard]] static bool distinguishes_kinds(std::string_view column);

    /// Whether such a column holds charges, which act on no atom of ljmd.
    [[nodiscard]] static bool is_charge(std::string_view column);

    /// The remark on a column of charges that are not all 0.
    [[nodiscard]] static std::string charge_remark(std::string_view column);

    /// Add the value of an atom in a column. Numbers within a millionth count as equal, because masses in files are
    /// rounded.
    /// @return the fault, "element 'Kr' beside 'Ar', but ljmd has one kind of atom"; empty when all earlier atoms have
    /// the same value
    [[nodiscard]] std::string add(std::string_view column, std::string_view value);

  private:
    std::map<std::string, std::string, std::less<>> values_;  ///< column -> value of the first atom
};

}  // namespace ljmd
