#pragma once

#include <map>
#include <string>
#include <string_view>

namespace ljmd {

/// Sees to it that all atoms of a file, in all its frames, are of one kind: ljmd has no mixtures. The readers of all
/// formats give it every value of every column that tells kinds apart.
class OneKind {
  public:
    /// Whether a column of a dump, a property of extended XYZ or an element of H5MD is one by which kinds of atoms
    /// differ: species, element, type, mass, atomic number, size.
    [[nodiscard]] static bool is_told_by(std::string_view column);

    /// The value that an atom has in a column. Numbers are the same within a millionth, as masses in files are rounded.
    /// @return what is wrong, "element 'Kr' beside 'Ar', but ljmd has one kind of atom"; empty when it is the value of
    ///         all atoms before
    [[nodiscard]] std::string add(std::string_view column, std::string_view value);

  private:
    std::map<std::string, std::string, std::less<>> values_;  ///< column -> the first atom's
};

}  // namespace ljmd
