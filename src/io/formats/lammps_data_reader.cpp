#include "ljmd/io/formats/lammps_data_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "ljmd/io/formats/atom_rows.hpp"
#include "ljmd/io/formats/configuration_check.hpp"

namespace ljmd {
namespace {

using Fields = std::vector<std::string_view>;

/// True for the sections of LAMMPS that do not say where atoms are. Unknown sections are refused: a misspelt or
/// truncated "Velocities" must not be skipped.
bool is_skipped_section(std::string_view name) {
    constexpr std::array<std::string_view, 8> names{"Bonds",      "Angles", "Dihedrals", "Impropers",
                                                    "Ellipsoids", "Lines",  "Triangles", "Bodies"};
    return name.ends_with(" Coeffs") || name.ends_with(" Type Labels") ||
           std::find(names.begin(), names.end(), name) != names.end();
}

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
        if (last == "avec" || last == "bvec" || last == "cvec") {
            file_.fail("the box is given by three vectors; only orthogonal boxes by their bounds can be read");
        }
        if (last == "yz") {
            read_tilt();
        } else if (fields_.size() == 2 && last == "atoms") {
            if (count_ != 0) file_.fail("the number of atoms is given twice");
            count_ = read_atom_count(file_, fields_[0]);
        } else if (fields_.size() == 3 && fields_[1] == "atom" && last == "types") {
            const Index types = file_.integer(fields_[0], "the number of atom types");
            if (types != 1) file_.fail(fmt::format("the file has {} atom types, but ljmd has one kind of atom", types));
        } else if (fields_.size() == 4) {
            read_bounds();
        }
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

    /// xy xz yz: the component of the second vector along x, those of the third along x and y.
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
        if (mass_) file_.fail("section Masses is given twice");
        find_first_row();
        if (fields_.size() != 2 || fields_[0] != "1") {
            file_.fail(fmt::format("expected '1 mass', found {}", shown(file_.line())));
        }
        mass_ = file_.number(fields_[1], "the mass");
        if (*mass_ <= 0.0) file_.fail(fmt::format("the mass must be positive, found {}", *mass_));
    }

    void read_atoms() {
        if (!configuration_.positions.empty()) file_.fail("section Atoms is given twice");
        const std::size_t hint = file_.line().find('#');
        if (hint != std::string_view::npos) {
            split_fields(file_.line().substr(hint + 1), fields_);
            if (!fields_.empty() && fields_[0] != "atomic") {
                file_.fail(
                    fmt::format("atom style {} cannot be read; the allowed style is 'atomic'", shown(fields_[0])));
            }
        }
        std::vector<Vec3> positions;
        std::size_t columns = 0;
        order_ = read_rows(positions, [&] {
            if (columns == 0) columns = fields_.size();
            return read_position(columns);
        });
        configuration_.positions = arranged(positions, order_.rows);
    }

    Vec3 read_position(std::size_t columns) const {
        if ((columns != 5 && columns != 8) || fields_.size() != columns) {
            file_.fail(
                fmt::format("{} columns, but atom style 'atomic' has 5 in all lines (id type x y z) or 8 in all "
                            "lines (with image flags)",
                            fields_.size()));
        }
        if (file_.integer(fields_[1], "the atom type") != 1) {
            file_.fail(fmt::format("atom type {}, but ljmd has one kind of atom", shown(fields_[1])));
        }
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
        if (mass_) configuration_.masses.assign(static_cast<std::size_t>(count_), *mass_);
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
    std::optional<double> mass_;
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
