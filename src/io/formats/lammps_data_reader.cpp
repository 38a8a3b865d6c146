#include "io/formats/lammps_data_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/formats/atom_rows.hpp"
#include "io/formats/configuration_check.hpp"

namespace ljmd {
namespace {

using Fields = std::vector<std::string_view>;

constexpr Index max_types = Index{1} << 20;

/// What else a header counts. A file with any of it describes another fluid.
constexpr std::array<std::string_view, 8> foreign_things{"bonds",      "angles", "dihedrals", "impropers",
                                                         "ellipsoids", "lines",  "triangles", "bodies"};

bool is_foreign(std::string_view name) {
    return std::ranges::find(foreign_things, lower_case(name)) != foreign_things.end();
}

/// True for the sections of LAMMPS that act on no atom where there are no bonds. Unknown sections are refused: a
/// misspelt or truncated "Velocities" must not be skipped.
bool is_skipped_section(std::string_view name) {
    return name.ends_with(" Coeffs") || name.ends_with(" Type Labels");
}

/// Pair styles whose first coefficients are epsilon and sigma of Lennard-Jones, and others cutoffs.
bool is_lennard_jones(std::string_view style) {
    constexpr std::array<std::string_view, 4> families{"lj/cut", "lj/smooth", "lj/gromacs", "lj/mdf"};
    return std::ranges::any_of(families, [&](std::string_view family) { return style.starts_with(family); });
}

/// Coefficients of the pairs of one atom type. Which type has atoms is known only later.
struct Coefficients {
    Index line;
    Index type;
    std::string style;  ///< empty: not given
    std::vector<std::string> numbers;
};

/// The fields of a line without its comment.
void split_uncommented(std::string_view line, Fields& fields) {
    split_fields(line.substr(0, line.find('#')), fields);
}

class Reader {
  public:
    explicit Reader(TextFile& file) : file_(file) {}

    Configuration read() {
        read_title();
        bool in_header = true;
        bool skipping = false;
        while (file_.next_line()) {
            split_uncommented(file_.line(), fields_);
            if (fields_.empty()) continue;
            if (!is_number(fields_[0])) {
                if (in_header) check_header();
                in_header = false;
                skipping = read_section();
            } else if (in_header) {
                read_header_line();
            } else if (!skipping) {
                file_.fail(fmt::format("a line follows the last one of section {}", section_));
            }
        }
        if (in_header) check_header();
        return assemble();
    }

  private:
    /// LAMMPS writes "units = lj" into the first line. Numbers in other units would be mistaken for reduced ones.
    void read_title() {
        file_.next_line();
        split_fields(file_.line(), fields_);
        const auto key = std::find(fields_.begin(), fields_.end(), "units");
        if (fields_.end() - key < 3 || key[1] != "=" || key[2] == "lj") return;
        file_.fail(fmt::format("the file is in units {}; LAMMPS data must be in units 'lj'", shown(key[2])));
    }

    void read_header_line() {
        const std::string_view last = fields_.back();
        if (last == "avec" || last == "bvec" || last == "cvec" || last == "origin") {
            read_vector_of_box(last);
        } else if (last == "yz") {
            read_tilt();
        } else if (fields_.size() == 2 && last == "atoms") {
            if (count_ != 0) file_.fail("the number of atoms is given twice");
            count_ = read_atom_count(file_, fields_[0]);
        } else if (fields_.size() == 2 && is_foreign(last)) {
            if (file_.integer(fields_[0], fmt::format("the number of {}", last)) != 0) refuse_foreign(last);
        } else if (fields_.size() == 3 && fields_[1] == "atom" && last == "types") {
            types_ = file_.integer(fields_[0], "the number of atom types");
            if (types_ < 1 || types_ > max_types) {
                file_.fail(fmt::format("the number of atom types must be from 1 to {}, found {}", max_types, types_));
            }
        } else if (fields_.size() == 4) {
            read_bounds();
        }
    }

    [[noreturn]] void refuse_foreign(std::string_view what) const {
        file_.fail(fmt::format("the file has {}, but the atoms of ljmd have the pair potential alone", what));
    }

    /// A line of a general triclinic box: "6 0 0 avec", "0 0 0 abc origin".
    void read_vector_of_box(std::string_view name) {
        constexpr std::array<std::string_view, 3> names{"avec", "bvec", "cvec"};
        const bool is_origin = name == "origin";
        if (fields_.size() != (is_origin ? 5U : 4U)) {
            file_.fail(fmt::format("expected three numbers and '{}', found {}", is_origin ? "abc origin" : name,
                                   shown(file_.line())));
        }
        const Vec3 vector = read_vector(file_, fields_, 0);
        if (is_origin) {
            low_ = vector;
            return;
        }
        const auto row = std::ranges::find(names, name) - names.begin();
        tilt_.row(row) = vector.transpose();
        configuration_.edges[row] = vector[row];
        tilt_line_ = box_line_ = file_.line_number();
    }

    void read_bounds() {
        constexpr std::array<std::array<std::string_view, 2>, 3> names{
            {{"xlo", "xhi"}, {"ylo", "yhi"}, {"zlo", "zhi"}}};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (fields_[2] != names[axis][0] || fields_[3] != names[axis][1]) continue;
            const double low = file_.number(fields_[0], names[axis][0]);
            const double edge = file_.number(fields_[1], names[axis][1]) - low;
            if (!(edge > 0.0)) file_.fail(fmt::format("{} must be above {}", names[axis][1], names[axis][0]));
            const auto k = static_cast<Eigen::Index>(axis);
            low_[k] = low;
            configuration_.edges[k] = edge;
            box_line_ = file_.line_number();
        }
    }

    /// xy xz yz: the component of the second vector along x, the components of the third along x and y.
    void read_tilt() {
        if (fields_.size() != 6) file_.fail(fmt::format("expected 'xy xz yz xy xz yz', found {}", shown(file_.line())));
        tilt_(1, 0) = file_.number(fields_[0], "a tilt factor");
        tilt_(2, 0) = file_.number(fields_[1], "a tilt factor");
        tilt_(2, 1) = file_.number(fields_[2], "a tilt factor");
        tilt_line_ = file_.line_number();
    }

    void check_header() const {
        if (count_ == 0) file_.fail("the header does not give the number of atoms");
        if ((configuration_.edges.array() <= 0.0).any()) {
            file_.fail("the header must give the box: lines with 'xlo xhi', 'ylo yhi' and 'zlo zhi'");
        }
        Mat3 vectors = tilt_;
        vectors.diagonal() = configuration_.edges;
        if (!is_orthogonal(vectors)) {
            file_.fail_at(tilt_line_, "the box is tilted; only orthogonal boxes can be read");
        }
    }

    /// @return true when the lines of the section are to be skipped
    bool read_section() {
        section_ = fmt::format("{}", fmt::join(fields_, " "));
        if (section_ == "Masses") {
            read_masses();
        } else if (section_ == "Atoms") {
            read_atoms();
        } else if (section_ == "Velocities") {
            read_velocities();
        } else if (section_ == "Pair Coeffs" || section_ == "PairIJ Coeffs") {
            read_coefficients();
        } else if (is_foreign(section_)) {
            refuse_foreign(lower_case(section_));
        } else if (is_skipped_section(section_)) {
            return true;
        } else {
            file_.fail(fmt::format("unknown section {}", shown(section_)));
        }
        return false;
    }

    /// Go to the first line of the section.
    void find_first_row() {
        do {
            if (!file_.next_line()) file_.fail(fmt::format("the file ends before the lines of section {}", section_));
            split_uncommented(file_.line(), fields_);
        } while (fields_.empty());
    }

    void read_masses() {
        if (!masses_.empty()) file_.fail("section Masses is given twice");
        for (Index row = 0; row < types_; ++row) {
            find_first_row();
            if (fields_.size() != 2) file_.fail(fmt::format("expected 'type mass', found {}", shown(file_.line())));
            const double mass = file_.number(fields_[1], "the mass");
            if (mass <= 0.0) file_.fail(fmt::format("the mass must be positive, found {}", mass));
            if (!masses_.emplace(read_type(fields_[0]), mass).second) {
                file_.fail(fmt::format("the mass of atom type {} is given twice", fields_[0]));
            }
        }
    }

    Index read_type(std::string_view field) const {
        const Index type = file_.integer(field, "the atom type");
        if (type < 1 || type > types_) {
            file_.fail(fmt::format("atom type {}, but the header has atom types 1 to {}", type, types_));
        }
        return type;
    }

    /// Pair Coeffs: a line for each type, "1 epsilon sigma ..."; PairIJ Coeffs: for each pair, "1 1 epsilon sigma ...".
    void read_coefficients() {
        const bool of_pairs = section_ == "PairIJ Coeffs";
        const std::string style = hint();
        const Index lines = of_pairs ? types_ * (types_ + 1) / 2 : types_;
        for (Index row = 0; row < lines; ++row) {
            find_first_row();
            if (fields_.size() < (of_pairs ? 2U : 1U)) {
                file_.fail(fmt::format("expected the coefficients of a pair of types, found {}", shown(file_.line())));
            }
            const Index type = read_type(fields_[0]);
            if (of_pairs && read_type(fields_[1]) != type) continue;  // no two types have atoms
            coefficients_.push_back({file_.line_number(), type, style, {}});
            Coefficients& found = coefficients_.back();
            found.numbers.assign(fields_.begin() + (of_pairs ? 2 : 1), fields_.end());
            if (!found.numbers.empty() && !is_number(found.numbers[0])) {  // of a hybrid style
                found.style = found.numbers[0];
                found.numbers.erase(found.numbers.begin());
            }
        }
    }

    /// The style in the comment of a section's first line: "Atoms # atomic". Empty where there is none.
    std::string hint() const {
        const std::size_t comment = file_.line().find('#');
        if (comment == std::string_view::npos) return "";
        Fields words;
        split_fields(file_.line().substr(comment + 1), words);
        return words.empty() ? "" : std::string(words[0]);
    }

    /// Refuse coefficients of the type that has atoms if they are not the reduced fluid's, epsilon = sigma = 1.
    void check_coefficients() {
        for (const auto& [line, type, style, numbers] : coefficients_) {
            if (type != *type_) continue;
            if ((!style.empty() && !is_lennard_jones(style)) || numbers.size() < 2) {
                file_.fail_at(line, fmt::format("the file has coefficients of pair style {}, which are not read; "
                                                "without the section, the potential is that of the deck",
                                                shown(style)));
            }
            constexpr double rounding = 1e-6;
            const bool is_reduced = std::abs(number_or_nan(numbers[0]) - 1.0) <= rounding &&
                                    std::abs(number_or_nan(numbers[1]) - 1.0) <= rounding;
            if (!is_reduced) {
                file_.fail_at(line,
                              fmt::format("epsilon = {} and sigma = {}, but in reduced units both are 1: energies, "
                                          "lengths and times are to be scaled",
                                          shown(numbers[0]), shown(numbers[1])));
            }
            if (numbers.size() > 2) {
                configuration_.remarks.push_back(fmt::format(
                    "the file gives the pairs a cutoff ({}), which is not taken: the cutoff is that of the deck",
                    fmt::join(numbers.begin() + 2, numbers.end(), " ")));
            }
        }
    }

    void read_atoms() {
        if (!configuration_.positions.empty()) file_.fail("section Atoms is given twice");
        if (const std::string style = hint(); !style.empty() && style != "atomic") {
            file_.fail(fmt::format("atom style {} cannot be read; the allowed style is 'atomic'", shown(style)));
        }
        std::vector<Vec3> positions;
        std::size_t columns = 0;
        order_ = read_rows(positions, [&] {
            if (columns == 0) columns = fields_.size();
            return read_position(columns);
        });
        configuration_.positions = arranged(positions, order_.rows);
        configuration_.is_unwrapped = columns == 8;
    }

    Vec3 read_position(std::size_t columns) {
        if ((columns != 5 && columns != 8) || fields_.size() != columns) {
            file_.fail(
                fmt::format("{} columns, but atom style 'atomic' has 5 in all lines (id type x y z) or 8 in all "
                            "lines (with image flags)",
                            fields_.size()));
        }
        const Index type = read_type(fields_[1]);
        if (type_.value_or(type) != type) {
            file_.fail(fmt::format("atom type {} beside {}, but ljmd has one kind of atom", type, *type_));
        }
        type_ = type;
        Vec3 image = Vec3::Zero();
        for (std::size_t axis = 0; columns == 8 && axis < 3; ++axis) {
            image[static_cast<Eigen::Index>(axis)] =
                static_cast<double>(file_.integer(fields_[5 + axis], "an image flag"));
        }
        return read_vector(file_, fields_, 2) - low_ + image.cwiseProduct(configuration_.edges);
    }

    void read_velocities() {
        if (configuration_.positions.empty()) file_.fail("section Velocities must follow section Atoms");
        if (!configuration_.velocities.empty()) file_.fail("section Velocities is given twice");
        std::vector<Vec3> velocities;
        const AtomOrder order = read_rows(velocities, [&] {
            if (fields_.size() != 4) file_.fail(fmt::format("expected 'id vx vy vz', found {}", shown(file_.line())));
            return read_vector(file_, fields_, 1);
        });
        if (order.ids != order_.ids) {
            file_.fail_at(order.first_line, "the ids of section Velocities are not those of section Atoms");
        }
        configuration_.velocities = arranged(velocities, order.rows);
    }

    /// Read one vector per atom from the fields of its line.
    template <class ReadVector>
    AtomOrder read_rows(std::vector<Vec3>& vectors, ReadVector read_row_vector) {
        find_first_row();
        std::vector<Index> ids;
        ids.reserve(expected_atoms(file_, count_));
        vectors.reserve(expected_atoms(file_, count_));
        const Index first_line = file_.line_number();
        for (Index row = 0; row < count_; ++row) {
            if (row > 0) next_atom_line(file_, row, count_);
            split_uncommented(file_.line(), fields_);
            vectors.push_back(read_row_vector());
            ids.push_back(file_.integer(fields_[0], "the id"));
        }
        return order_by_id(file_, ids, first_line);
    }

    Configuration assemble() {
        if (configuration_.positions.empty()) file_.fail("the file has no section Atoms");
        check_coefficients();
        if (!masses_.empty()) {
            configuration_.masses.assign(static_cast<std::size_t>(count_), masses_.at(*type_));
        }
        check_configuration(file_, configuration_, order_, box_line_);
        return std::move(configuration_);
    }

    TextFile& file_;
    Fields fields_;
    std::string section_;
    Index count_ = 0;
    Vec3 low_ = Vec3::Zero();
    Index box_line_ = 0;
    Mat3 tilt_ = Mat3::Zero();
    Index tilt_line_ = 0;
    Index types_ = 1;
    std::optional<Index> type_;       ///< of the atoms
    std::map<Index, double> masses_;  ///< by type; empty without section Masses
    std::vector<Coefficients> coefficients_;
    AtomOrder order_;
    Configuration configuration_;
};

}  // namespace

Configuration read_lammps_data(TextFile& file) {
    return Reader(file).read();
}

bool is_lammps_atom_count(std::string_view line) {
    Fields fields;
    split_uncommented(line, fields);
    return fields.size() == 2 && fields[1] == "atoms" && is_number(fields[0]);
}

bool is_lammps_box_bound(std::string_view line) {
    Fields fields;
    split_uncommented(line, fields);
    return fields.size() == 4 && fields[2] == "xlo" && fields[3] == "xhi" && is_number(fields[0]);
}

}  // namespace ljmd
