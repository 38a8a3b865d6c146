#include "io/formats/h5md_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "io/formats/configuration_check.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr Index max_atoms = Index{1} << 30;
constexpr Index numbers_at_once = Index{1} << 16;
constexpr double largest_step = 1e15;  // up to here, integers are exact in doubles

}  // namespace

H5mdReader::H5mdReader(const std::filesystem::path& path, const std::optional<SubstanceUnits>& units,
                       const std::string& group)
    : file_(path) {
    group_ = find_group(group);
    position_ = vectors("position");
    if (position_.value.empty() || position_.fixed) {
        file_.fail(fmt::format("{} has no positions that change with time", group_));
    }
    velocity_ = vectors("velocity");
    if (!is_at_steps_of_positions("velocity", velocity_)) {
        velocity_ = {};
        leave_velocities("at other steps than the positions");
    }
    force_ = vectors("force");
    if (!is_at_steps_of_positions("force", force_)) {
        force_ = {};
    }
    image_ = vectors("image");
    if (!is_at_steps_of_positions("image", image_)) {
        image_ = {};
    }
    edges_ = element("box/edges");
    id_ = element("id");
    require_of_atoms("id", id_);
    check_box();
    check_kind();
    find_remarks();
    find_frames();
    steps_ = series(group_ + "/position/step", frame_count_);
    times_ = series(group_ + "/position/time", frame_count_);
    for (const char* name : {"box/edges", "id"}) {
        require_same_steps(name);
    }
    const Element mass = element("mass");
    scale_ = h5md_scale(file_, {position_.value, group_ + "/position/time", velocity_.value, edges_.value, mass.value},
                        units);
    if (!mass.value.empty() && scale_.mass) {
        const std::vector<double> masses = mass.fixed ? file_.numbers(mass.value) : file_.first_numbers(mass.value, 1);
        mass_ = masses.empty() ? std::nullopt : std::optional(masses[0] / *scale_.mass);
    }
    if (const auto scale = h5md_force_scale(file_, force_.value, position_.value, units)) {
        force_scale_ = *scale;
    } else {
        force_ = {};
    }
    const std::vector<std::string> creator = file_.text_attribute("h5md/creator", "name");
    is_ljmd_ = !creator.empty() && creator[0] == "ljmd";
}

void H5mdReader::fail(const std::string& message) const {
    file_.fail(fmt::format("frame {}: {}", frames() + 1, message));
}

std::string H5mdReader::find_group(const std::string& wanted) const {
    const std::string all = "particles";
    if (!file_.exists(all)) {
        file_.fail("it is HDF5, but not H5MD: there is no group 'particles'");
    }
    const std::vector<std::string> groups = file_.members(all);
    if (wanted.empty() && groups.size() == 1) {
        return all + "/" + groups[0];
    }
    const std::string name = wanted.empty() ? "trajectory" : wanted;
    if (std::ranges::find(groups, name) == groups.end()) {
        file_.fail(wanted.empty()
                       ? fmt::format("'particles' has {} groups, {}: choose one (analyze: --group NAME)", groups.size(),
                                     fmt::join(groups, ", "))
                       : fmt::format("'particles' has no group {}, but {}", shown(wanted), fmt::join(groups, ", ")));
    }
    return all + "/" + name;
}

H5mdReader::Element H5mdReader::element(const std::string& name) const {
    const std::string path = group_ + "/" + name;
    if (!file_.exists(path)) {
        return {};
    }
    if (file_.is_dataset(path)) {
        return {path, true};
    }
    return file_.exists(path + "/value") ? Element{path + "/value", false} : Element{};
}

H5mdReader::Element H5mdReader::vectors(const std::string& name) {
    Element found = element(name);
    if (found.value.empty()) {
        return found;
    }
    std::vector<Index> extent = file_.extent(found.value);
    if (!found.fixed && !extent.empty()) {
        extent.erase(extent.begin());
    }
    if (extent.size() != 2 || extent[1] != 3) {
        file_.fail(fmt::format("{} does not hold vectors of three numbers", found.value));
    }
    if (atom_count_ == 0) {
        atom_count_ = extent[0];
    }
    if (extent[0] != atom_count_ || atom_count_ < 1 || atom_count_ > max_atoms) {
        file_.fail(fmt::format("{} is of {} atoms, the positions are of {}", found.value, extent[0], atom_count_));
    }
    return found;
}

/// Find the number of frames that are complete in all arrays.
void H5mdReader::find_frames() {
    frame_count_ = file_.extent(position_.value)[0];
    Index most = frame_count_;
    std::vector<std::string> arrays{group_ + "/position/step", group_ + "/position/time"};
    for (const Element& other : {velocity_, force_, image_, edges_, id_}) {
        if (!other.fixed && !other.value.empty()) {
            arrays.push_back(other.value);
        }
    }
    for (const std::string& array : arrays) {
        if (!file_.exists(array)) {
            continue;
        }
        const std::vector<Index> extent = file_.extent(array);
        if (!extent.empty()) {
            most = std::max(most, extent[0]);
            frame_count_ = std::min(frame_count_, extent[0]);
        }
    }
    if (frame_count_ == 0) {
        file_.fail("there is no frame");
    }
    if (!file_.was_closed()) {
        warn(fmt::format("{} was not closed: it is still written, or its program was killed; {} frames are whole",
                         file_.name(), frame_count_));
    } else if (most > frame_count_) {
        warn(fmt::format("{}: some arrays have {} frames, others {}; the first {} are used", file_.name(), most,
                         frame_count_, frame_count_));
    }
}

/// Whether an optional element has an entry for each frame. A file that was not closed may lack the last ones.
bool H5mdReader::is_at_steps_of_positions(const std::string& name, const Element& element) const {
    if (element.value.empty() || element.fixed) {
        return true;
    }
    const Index frames = file_.extent(position_.value)[0];
    const Index entries = file_.extent(element.value)[0];
    const std::vector<double> steps = series(group_ + "/position/step", frames);
    const std::vector<double> others = series(fmt::format("{}/{}/step", group_, name), entries);
    if (entries == 0) {
        return false;
    }
    if (steps.empty() || others.empty()) {
        return entries == frames || !file_.was_closed();
    }
    const auto common = static_cast<std::ptrdiff_t>(std::min(steps.size(), others.size()));
    return std::equal(steps.begin(), steps.begin() + common, others.begin()) &&
           (steps.size() == others.size() || !file_.was_closed());
}

/// Refuse an element that was written at other steps than the positions.
void H5mdReader::require_same_steps(const std::string& name) const {
    const std::vector<double> others = series(fmt::format("{}/{}/step", group_, name), frame_count_);
    if (steps_.empty() || others.empty()) {
        return;
    }
    const auto different = std::ranges::mismatch(steps_, others).in1;
    if (different != steps_.end()) {
        file_.fail(fmt::format("frame {}: {} was written at another step than the positions",
                               different - steps_.begin() + 1, name));
    }
}

void H5mdReader::check_box() const {
    const std::string box = group_ + "/box";
    const std::vector<std::string> boundary = file_.text_attribute(box, "boundary");
    const auto periodic = [](const std::string& text) { return text == "periodic"; };
    if (edges_.value.empty() || boundary.empty() || !std::ranges::all_of(boundary, periodic)) {
        file_.fail(fmt::format("{} must be periodic in all directions and have edges", box));
    }
    std::vector<Index> extent = file_.extent(edges_.value);
    if (!edges_.fixed && !extent.empty()) {
        extent.erase(extent.begin());
    }
    if (extent != std::vector<Index>{3} && extent != std::vector<Index>{3, 3}) {
        file_.fail(fmt::format("{} is neither a vector nor a matrix of three edges", edges_.value));
    }
}

/// Refuse, before it is read, an array that has neither one number per atom nor one for all.
void H5mdReader::require_of_atoms(const std::string& name, const Element& element) const {
    if (element.value.empty()) {
        return;
    }
    const std::vector<Index> extent = file_.extent(element.value);
    double numbers = 1.0;
    for (std::size_t axis = element.fixed || extent.empty() ? 0 : 1; axis < extent.size(); ++axis) {
        numbers *= static_cast<double>(extent[axis]);
    }
    if (numbers != static_cast<double>(atom_count_) && numbers != 1.0) {
        file_.fail(fmt::format("{} is of {} atoms, the positions are of {}", name, numbers, atom_count_));
    }
}

/// Checks everything that distinguishes kinds of atoms, in as many entries as there are frames, which may be at other
/// steps.
void H5mdReader::check_kind() const {
    OneKind kind;
    const auto add = [&](const std::string& name, const std::vector<double>& values) {
        for (std::size_t k = 0; k < values.size(); ++k) {
            if (k > 0 && values[k] == values[k - 1]) {
                continue;
            }
            if (const std::string fault = kind.add(name, fmt::format("{}", values[k])); !fault.empty()) {
                file_.fail(fmt::format("{}: {}", group_, fault));
            }
        }
    };
    for (const std::string& name : file_.members(group_)) {
        const Element found = OneKind::distinguishes_kinds(name) ? element(name) : Element{};
        if (found.value.empty()) {
            continue;
        }
        require_of_atoms(name, found);
        const std::vector<Index> extent = file_.extent(found.value);
        if (found.fixed || extent.empty()) {
            add(name, file_.numbers(found.value));
            continue;
        }
        const Index end = std::min(extent[0], file_.extent(position_.value)[0]);
        const Index at_once = std::max<Index>(1, numbers_at_once / atom_count_);
        for (Index begin = 0; begin < end; begin += at_once) {
            add(name, file_.numbers_between(found.value, begin, std::min(begin + at_once, end)));
        }
    }
}

void H5mdReader::find_remarks() {
    for (const std::string& name : file_.members(group_)) {
        const Element found = OneKind::is_charge(name) ? element(name) : Element{};
        if (found.value.empty()) {
            continue;
        }
        require_of_atoms(name, found);
        const std::vector<double> values =
            found.fixed ? file_.numbers(found.value) : file_.first_numbers(found.value, 1);
        if (std::ranges::any_of(values, [](double value) { return value != 0.0; })) {
            remarks_.push_back(OneKind::charge_remark(name));
        }
    }
    if (file_.exists("connectivity") && !file_.members("connectivity").empty()) {
        remarks_.emplace_back(
            "the file has bonds ('connectivity'), which are not taken: ljmd has the pair potential alone");
    }
}

/// The values of an array for each frame: the array has one entry per frame, or is an increment from frame to frame.
/// Nothing if there is no such array.
/// @param entries  number of values; a longer array is cut to it
std::vector<double> H5mdReader::series(const std::string& array, Index entries) const {
    if (!file_.exists(array)) {
        return {};
    }
    const std::vector<Index> extent = file_.extent(array);
    if (std::accumulate(extent.begin() + std::min<std::ptrdiff_t>(1, std::ssize(extent)), extent.end(), 1.0,
                        std::multiplies<>()) != 1.0) {
        file_.fail(fmt::format("{} has more than a number for each frame", array));
    }
    std::vector<double> values = file_.first_numbers(array, entries);
    if (extent.empty()) {
        const std::vector<double> offset = file_.number_attribute(array, "offset");
        const double increment = values.at(0);
        values.clear();
        for (Index frame = 0; frame < entries; ++frame) {
            values.push_back((offset.empty() ? 0.0 : offset[0]) + static_cast<double>(frame) * increment);
        }
    }
    values.resize(static_cast<std::size_t>(entries));
    return values;
}

Vec3 H5mdReader::edges_of(Index frame) const {
    const std::vector<double> numbers =
        edges_.fixed ? file_.numbers(edges_.value) : file_.numbers_at(edges_.value, frame);
    if (numbers.size() == 3) {
        return Vec3(numbers[0], numbers[1], numbers[2]);
    }
    const Mat3 matrix(numbers.data());
    if (!is_orthogonal(matrix)) {
        fail("the box is tilted; only orthogonal boxes can be read");
    }
    return matrix.diagonal();
}

/// The order of the atoms by id, and the ids; empty for a file without ids.
AtomOrder H5mdReader::order_of(Index frame) const {
    if (id_.value.empty()) {
        return {};
    }
    const std::vector<std::int64_t> ids = id_.fixed ? file_.integers(id_.value) : file_.integers_at(id_.value, frame);
    if (std::ssize(ids) != atom_count_) {
        fail(fmt::format("{} ids, but {} atoms", ids.size(), atom_count_));
    }
    std::vector<Index> order(ids.size());
    std::iota(order.begin(), order.end(), Index{0});
    const auto id = [&](Index k) { return ids[static_cast<std::size_t>(k)]; };
    std::ranges::sort(order, {}, id);
    if (id(order[0]) < 0) {
        fail(fmt::format("id {}: an atom is missing", id(order[0])));
    }
    const auto same = std::ranges::adjacent_find(order, {}, id);
    if (same != order.end()) {
        fail(fmt::format("id {} occurs twice", id(*same)));
    }
    return {arranged(ids, order), order};
}

std::vector<Vec3> H5mdReader::vectors_of(const Element& element, Index frame, double unit) const {
    const std::vector<double> numbers =
        element.fixed ? file_.numbers(element.value) : file_.numbers_at(element.value, frame);
    std::vector<Vec3> vectors(static_cast<std::size_t>(atom_count_));
    for (std::size_t k = 0; k < vectors.size(); ++k) {
        vectors[k] = Vec3(numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]) / unit;
    }
    return vectors;
}

bool H5mdReader::read(Frame& frame) {
    const Index k = frames();
    if (k == frame_count_) {
        return false;
    }
    const auto of_frame = [k](const std::vector<double>& values) {
        return values.empty() ? std::nullopt : std::optional(values[static_cast<std::size_t>(k)]);
    };
    const std::optional<double> time = of_frame(times_);
    const std::optional<double> given_step = of_frame(steps_);
    const double step = given_step.value_or(0.0);
    if (!(step >= 0.0 && step == std::floor(step) && step < largest_step)) {
        fail(fmt::format("the step must be an integer of at least 0, found {}", step));
    }
    Configuration found;
    found.edges = edges_of(k) / scale_.edges;
    if (given_step) {
        found.step = static_cast<Index>(step);
    }
    if (time) {
        found.time = *time / scale_.time;
    }
    found.is_unwrapped = is_ljmd_ || !image_.value.empty();
    found.remarks = remarks_;
    found.positions = vectors_of(position_, k, scale_.length);
    if (!velocity_.value.empty()) {
        found.velocities = vectors_of(velocity_, k, scale_.velocity);
    }
    if (!image_.value.empty()) {
        const std::vector<Vec3> images = vectors_of(image_, k, 1.0);
        for (std::size_t atom = 0; atom < images.size(); ++atom) {
            found.positions[atom] += images[atom].cwiseProduct(found.edges);
        }
    }
    if (mass_) {
        found.masses.assign(found.positions.size(), *mass_);
    }
    std::vector<Vec3> forces = force_.value.empty() ? std::vector<Vec3>{} : vectors_of(force_, k, force_scale_);
    const AtomOrder order = order_of(k);
    if (!order.ids.empty()) {
        found.positions = arranged(found.positions, order.rows);
        found.velocities = arranged(found.velocities, order.rows);
        forces = arranged(forces, order.rows);
    }
    if (const auto fault = find_fault(found)) {
        fail_by(*fault, fault->atom ? order.id(*fault->atom) : 0);
    }
    frame = {.configuration = std::move(found), .ids = order.ids};
    frame.forces = std::move(forces);
    return true;
}

}  // namespace ljmd
