#include "io/formats/lammps_dump.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/formats/configuration_check.hpp"

namespace ljmd {

namespace {

/// LAMMPS ends some of its lines with a space.
std::string_view without_end(std::string_view line) {
    return line.substr(0, std::min(line.find_last_not_of(" \t") + 1, line.size()));
}

/// Three columns that form a vector.
struct VectorColumns {
    std::array<const char*, 3> names;
    bool scaled = false;     ///< in units of the edges, relative to the corner of the box
    bool unwrapped = false;  ///< continuous across the walls of the box
};

/// Possible columns of positions, the preferred ones first.
constexpr std::array<VectorColumns, 4> all_positions{{{{"xu", "yu", "zu"}, false, true},
                                                      {{"xsu", "ysu", "zsu"}, true, true},
                                                      {{"x", "y", "z"}, false, false},
                                                      {{"xs", "ys", "zs"}, true, false}}};
constexpr std::array<const char*, 3> velocity_names{"vx", "vy", "vz"};
constexpr std::array<const char*, 3> force_names{"fx", "fy", "fz"};
constexpr std::array<const char*, 3> image_names{"ix", "iy", "iz"};
constexpr std::array<std::string_view, 3> tilt_names{"xy", "xz", "yz"};

bool is_force(std::string_view column) {
    return std::ranges::find(force_names, column) != force_names.end();
}

bool has_all(const LammpsDump& dump, const std::array<const char*, 3>& names) {
    return std::ranges::all_of(names, [&](const char* name) { return dump.has(name); });
}

}  // namespace

void LammpsDump::require_line(std::string_view what) {
    if (!file_.next_line()) {
        file_.fail(fmt::format("the file ends before {}", what));
    }
}

bool LammpsDump::next_frame(Index atoms) {
    file_.set_context(fmt::format("frame {}: ", frames_ + 1));
    step_ = -1;
    atoms_ = 0;
    time_.reset();
    edges_.setZero();
    constexpr std::string_view item = "ITEM: ";
    for (bool first = true;; first = false) {
        if (!file_.next_line()) {
            if (first) {
                return false;
            }
            file_.fail("the file ends before the atoms of the frame");
        }
        const std::string line(without_end(file_.line()));
        if (!line.starts_with(item)) {
            file_.fail(fmt::format("a line that begins with 'ITEM:' was expected, found {}", shown(line)));
        }
        const std::string name = line.substr(item.size());
        if (name.starts_with("ATOMS ")) {
            read_columns(name.substr(name.find(' ')));
            ++frames_;
            return true;
        }
        read_item(name, atoms);
    }
}

void LammpsDump::read_item(std::string_view item, Index atoms) {
    constexpr std::string_view bounds = "BOX BOUNDS";
    if (item.starts_with(bounds)) {
        read_bounds(item.substr(bounds.size()));
        return;
    }
    const std::string name(item);
    require_line(fmt::format("what follows 'ITEM: {}'", name));
    const std::string_view value = without_end(file_.line());
    if (name == "TIMESTEP") {
        step_ = file_.integer(value, "the step");
    } else if (name == "NUMBER OF ATOMS") {
        atoms_ = read_atom_count(file_, value, atoms);
    } else if (name == "TIME") {
        time_ = file_.number(value, "the time");
    } else if (name != "UNITS") {
        file_.fail_at(file_.line_number() - 1, fmt::format("unknown item {}", shown(name)));
    } else if (value != "lj") {
        file_.fail(fmt::format("the file is in units {}; a LAMMPS dump must be in units 'lj'", shown(value)));
    }
}

void LammpsDump::read_bounds(std::string_view boundaries) {
    box_line_ = file_.line_number();
    std::vector<std::string_view> fields;
    split_fields(boundaries, fields);
    if (fields.size() >= 2 && fields[0] == "abc" && fields[1] == "origin") {
        read_vectors({fields.begin() + 2, fields.end()}, boundaries);
        return;
    }
    const bool has_tilt = fields.size() >= 3 && std::equal(tilt_names.begin(), tilt_names.end(), fields.begin());
    fields.erase(fields.begin(), fields.begin() + (has_tilt ? 3 : 0));
    check_boundaries(fields, boundaries);
    Mat3 vectors = Mat3::Zero();
    for (int axis = 0; axis < 3; ++axis) {
        require_line("the bounds of the box");
        split_fields(file_.line(), fields);
        if (fields.size() != (has_tilt ? 3U : 2U)) {
            file_.fail(fmt::format("two bounds of the box{} were expected, found {}",
                                   has_tilt ? " and a tilt factor" : "", shown(file_.line())));
        }
        low_[axis] = file_.number(fields[0], "a bound of the box");
        edges_[axis] = file_.number(fields[1], "a bound of the box") - low_[axis];
        if (!(edges_[axis] > 0.0)) {
            file_.fail("the upper bound of the box must be above the lower one");
        }
        vectors(axis, axis) = edges_[axis];
        if (has_tilt) {
            vectors(axis == 0 ? 1 : 2, axis == 2 ? 1 : 0) = file_.number(fields[2], "a tilt factor");  // xy, xz, yz
        }
    }
    if (!is_orthogonal(vectors)) {
        file_.fail_at(box_line_, "the box is tilted; only orthogonal boxes can be read");
    }
}

void LammpsDump::check_boundaries(const std::vector<std::string_view>& names, std::string_view line) {
    tells_boundaries_ = !names.empty();
    if (tells_boundaries_ && names != std::vector<std::string_view>(3, "pp")) {
        file_.fail(fmt::format("the box must be periodic and along the axes, 'ITEM: BOX BOUNDS pp pp pp', found {}",
                               shown(line)));
    }
}

/// A general triclinic box: three vectors, and the corner that they begin at.
void LammpsDump::read_vectors(const std::vector<std::string_view>& boundaries, std::string_view line) {
    check_boundaries(boundaries, line);
    Mat3 vectors;
    for (int axis = 0; axis < 3; ++axis) {
        require_line("the vectors of the box");
        std::vector<std::string_view> fields;
        split_fields(file_.line(), fields);
        if (fields.size() != 4) {
            file_.fail(fmt::format("a vector of the box and a coordinate of its corner were expected, found {}",
                                   shown(file_.line())));
        }
        for (int k = 0; k < 3; ++k) {
            vectors(axis, k) = file_.number(fields[static_cast<std::size_t>(k)], "a vector of the box");
        }
        low_[axis] = file_.number(fields[3], "the corner of the box");
    }
    edges_ = vectors.diagonal();
    if (!(edges_.minCoeff() > 0.0) || !is_orthogonal(vectors)) {
        file_.fail_at(box_line_, "the vectors of the box are not along the axes; only orthogonal boxes can be read");
    }
}

void LammpsDump::read_columns(std::string_view names) {
    std::vector<std::string_view> fields;
    split_fields(names, fields);
    columns_.assign(fields.begin(), fields.end());
    if (step_ < 0 || atoms_ == 0 || edges_[0] == 0.0) {
        file_.fail("the frame needs a step that is not negative, a number of atoms and a box above its atoms");
    }
}

bool LammpsDump::has(std::string_view column) const {
    return std::ranges::find(columns_, column) != columns_.end();
}

std::size_t LammpsDump::column(std::string_view name) const {
    const auto found = std::ranges::find(columns_, name);
    if (found == columns_.end()) {
        file_.fail(fmt::format("the atoms have no column '{}'", name));
    }
    return static_cast<std::size_t>(found - columns_.begin());
}

LammpsDump::Rows LammpsDump::read_atoms(const std::vector<std::string>& columns) {
    const std::size_t id = column("id");
    std::vector<std::size_t> wanted;
    wanted.reserve(columns.size());
    for (const std::string& name : columns) {
        wanted.push_back(column(name));
    }
    std::vector<std::size_t> kinds;
    std::vector<std::size_t> charges;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        if (OneKind::distinguishes_kinds(columns_[k])) {
            kinds.push_back(k);
        } else if (OneKind::is_charge(columns_[k])) {
            charges.push_back(k);
        }
    }
    remarks_.clear();
    std::vector<Index> ids;
    std::vector<double> numbers;
    ids.reserve(expected_atoms(file_, atoms_));
    numbers.reserve(expected_atoms(file_, atoms_) * wanted.size());
    std::vector<std::string_view> fields;
    const Index first_line = file_.line_number() + 1;
    for (Index row = 0; row < atoms_; ++row) {
        next_atom_line(file_, row, atoms_);
        split_fields(file_.line(), fields);
        if (fields.size() != columns_.size()) {
            file_.fail(fmt::format("{} columns, but 'ITEM: ATOMS' names {}", fields.size(), columns_.size()));
        }
        ids.push_back(file_.integer(fields[id], "the id"));
        for (const std::size_t k : kinds) {
            if (const std::string fault = kind_.add(columns_[k], fields[k]); !fault.empty()) {
                file_.fail(fault);
            }
        }
        for (const std::size_t k : wanted) {
            numbers.push_back(is_force(columns_[k]) ? number_or_nan(fields[k]) : file_.number(fields[k], columns_[k]));
        }
        std::erase_if(charges, [&](std::size_t k) {
            const bool acts = number_or_nan(fields[k]) != 0.0;
            if (acts) {
                remarks_.push_back(OneKind::charge_remark(columns_[k]));
            }
            return acts;
        });
    }
    order_ = order_by_id(file_, ids, first_line);
    const Eigen::Map<const Rows> rows(numbers.data(), atoms_, static_cast<Index>(wanted.size()));
    return rows(order_.rows, Eigen::all);
}

bool LammpsDumpTrajectory::read(Frame& frame) {
    if (!dump_.next_frame(atoms())) {
        return false;
    }
    const auto* const found = std::ranges::find_if(
        all_positions, [&](const VectorColumns& columns) { return has_all(dump_, columns.names); });
    if (found == all_positions.end()) {
        dump_.file().fail("the atoms have no positions: xu yu zu, xsu ysu zsu, x y z or xs ys zs");
    }
    const bool has_images = !found->unwrapped && has_all(dump_, image_names);
    const bool has_velocities = has_all(dump_, velocity_names);
    std::vector<std::string> columns(found->names.begin(), found->names.end());
    if (has_images) {
        columns.insert(columns.end(), image_names.begin(), image_names.end());
    }
    const auto first_velocity = static_cast<Index>(columns.size());
    if (has_velocities) {
        columns.insert(columns.end(), velocity_names.begin(), velocity_names.end());
    }
    const auto first_force = static_cast<Index>(columns.size());
    const bool has_forces = has_all(dump_, force_names);
    if (has_forces) {
        columns.insert(columns.end(), force_names.begin(), force_names.end());
    }
    const bool has_masses = dump_.has("mass");
    if (has_masses) {
        columns.emplace_back("mass");
    }
    const LammpsDump::Rows rows = dump_.read_atoms(columns);
    if (frames() > 0 && is_cut()) {
        dump_.file().fail("the last line has no end");
    }
    const Vec3& edges = dump_.edges();
    Configuration configuration;
    std::vector<Vec3> forces;
    configuration.edges = edges;
    configuration.step = dump_.step();
    configuration.time = dump_.time();
    configuration.is_unwrapped = found->unwrapped || has_images;
    configuration.remarks = dump_.remarks();
    for (Index atom = 0; atom < rows.rows(); ++atom) {
        const Vec3 place = rows.row(atom).head<3>();
        const Vec3 image = has_images ? Vec3(rows.row(atom).segment<3>(3)) : Vec3(Vec3::Zero());
        const Vec3 from_corner = found->scaled ? Vec3(place.cwiseProduct(edges)) : Vec3(place - dump_.low());
        configuration.positions.emplace_back(from_corner + image.cwiseProduct(edges));
        if (has_velocities) {
            configuration.velocities.emplace_back(rows.row(atom).segment<3>(first_velocity));
        }
        if (has_forces) {
            forces.emplace_back(rows.row(atom).segment<3>(first_force));
        }
        if (has_masses) {
            configuration.masses.push_back(rows(atom, rows.cols() - 1));
        }
    }
    check_frame(dump_.file(), configuration, dump_.order(), dump_.box_line());
    frame = {.configuration = std::move(configuration), .ids = dump_.order().ids};
    frame.forces = std::move(forces);
    if (!dump_.tells_boundaries()) {
        warn("'ITEM: BOX BOUNDS' does not tell the boundaries: the box is taken as periodic");
    }
    return true;
}

}  // namespace ljmd
