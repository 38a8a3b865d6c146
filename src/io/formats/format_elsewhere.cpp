#include "io/formats/format_elsewhere.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "core/text.hpp"

namespace ljmd {

namespace {

struct Signature {
    std::string_view name;
    std::size_t place;
    std::string_view bytes;
    bool ase = false;  ///< who reads it: ASE, or MDAnalysis
};

using namespace std::string_view_literals;

constexpr std::array signatures{
    Signature{"DCD", 4, "CORD"sv},          Signature{"XTC", 0, "\0\0\x07\xcb"sv},
    Signature{"TRR", 0, "\0\0\x07\xc9"sv},  Signature{"NetCDF", 0, "CDF\x01"sv},
    Signature{"NetCDF", 0, "CDF\x02"sv},    Signature{"GSD", 0, "\xdf\x65\xdf\x65\xdf\x65\xdf\x65"sv},
    Signature{"PDB", 0, "CRYST1 "sv, true}, Signature{"PDB", 0, "HEADER "sv, true},
    Signature{"PDB", 0, "TITLE "sv, true},  Signature{"PDB", 0, "REMARK "sv, true},
    Signature{"PDB", 0, "MODEL "sv, true},  Signature{"PDB", 0, "ATOM  "sv, true},
    Signature{"PDB", 0, "HETATM"sv, true}};

bool is_digits(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// A title, the number of atoms, and atoms in fixed columns: number and name of the residue, name of the atom.
bool is_gro(std::string_view beginning) {
    const std::size_t title = beginning.find('\n');
    const std::size_t count = title == std::string_view::npos ? title : beginning.find('\n', title + 1);
    if (count == std::string_view::npos || beginning.size() < count + 40) {
        return false;
    }
    std::string_view number = beginning.substr(title + 1, count - title - 1);
    while (!number.empty() && std::isspace(static_cast<unsigned char>(number.front())) != 0) {
        number.remove_prefix(1);
    }
    while (!number.empty() && std::isspace(static_cast<unsigned char>(number.back())) != 0) {
        number.remove_suffix(1);
    }
    const std::string_view atom = beginning.substr(count + 1, 39);
    return is_digits(number) && std::isalpha(static_cast<unsigned char>(atom[5])) != 0 &&
           std::isdigit(static_cast<unsigned char>(atom[4])) != 0 && atom[23] != ' ';
}

/// A text of Python in double quotes.
std::string python_text(const std::filesystem::path& path) {
    std::string text = path.string();
    std::string escaped;
    for (const char c : text) {
        escaped += c == '"' || c == '\\' ? fmt::format("\\{}", c) : std::string(1, c);
    }
    return fmt::format("\"{}\"", printable(escaped, 200));
}

}  // namespace

std::string format_elsewhere(const std::filesystem::path& path, std::string_view beginning) {
    const auto found = std::ranges::find_if(signatures, [&](const Signature& each) {
        return beginning.size() > each.place && beginning.substr(each.place).starts_with(each.bytes);
    });
    const bool is_known = found != signatures.end();
    if (!is_known && !is_gro(beginning)) {
        return "";
    }
    const std::string in = python_text(path);
    if (is_known && !found->ase) {
        return fmt::format(
            "is a trajectory in {}, which is not read here; with MDAnalysis, these lines of Python make an H5MD file "
            "of it\n"
            "  import MDAnalysis\n"
            "  MDAnalysis.Universe({}, {}, topology_format=\"MINIMAL\").atoms.write({}, frames=\"all\")",
            found->name, in, in, python_text(path.stem().string() + ".h5md"));
    }
    return fmt::format(
        "is in the format {}, which is not read here; with ASE, these lines of Python make an extended XYZ file of it\n"
        "  import ase.io\n"
        "  ase.io.write({}, ase.io.read({}, \":\"), format=\"extxyz\")",
        is_known ? found->name : "GRO", python_text(path.stem().string() + ".xyz"), in);
}

}  // namespace ljmd
