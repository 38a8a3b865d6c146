#include "report/atom_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "ljmd/core/errors.hpp"
#include "report/base64.hpp"
#include "report/page_content.hpp"

namespace ljmd {

namespace {

constexpr double base64_growth = 4.0 / 3.0;
constexpr double position_bytes = 6.0 * base64_growth;
constexpr double colour_bytes = 1.0 * base64_growth;
constexpr Index most_frames = 200;
constexpr Index most_atoms = 1'000'000;     // points that a graphics card draws; more would be no picture either
constexpr Index most_counted = 20'000;      // atoms whose neighbours are counted: above, frames are worth more
constexpr double neighbour_distance = 1.5;  // [sigma], about the first minimum of g(r) of a liquid
constexpr double grid = 65536.0;

Data edges_data(const Vec3& edges) {
    return Data::list({edges[0], edges[1], edges[2]});
}

/// A colour of atoms: values between `low` and `high` as bytes.
Data colour_data(const std::string& name, const std::string& label, double high,
                 const std::vector<std::uint8_t>& values) {
    return {{"name", name}, {"label", label}, {"low", 0}, {"high", high}, {"values", base64(values)}};
}

/// The value that 99.5 % of the speeds do not exceed: a few fast atoms are not to take all colours.
double high_speed(std::vector<float> speeds) {
    constexpr double part = 0.995;
    const auto at = speeds.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(speeds.size() - 1));
    std::nth_element(speeds.begin(), at, speeds.end());
    return std::max(static_cast<double>(*at), 1e-12);
}

}  // namespace

double atom_bytes(Index atoms) {
    constexpr double least = 0.6e6;
    constexpr double most = 10.6e6;
    constexpr double frames = 40.0;
    return std::clamp(frames * static_cast<double>(atoms) * (position_bytes + colour_bytes), least, most);
}

void AtomFrames::begin(const Frame& frame) {
    atoms_ = static_cast<Index>(frame.configuration.positions.size());
    each_ = (atoms_ + most_atoms - 1) / most_atoms;
    counts_ = atoms_ <= most_counted;
    const Index shown = (atoms_ + each_ - 1) / each_;
    const double colours = (frame.configuration.velocities.empty() ? 0.0 : 1.0) + (counts_ ? 1.0 : 0.0);
    const double bytes = static_cast<double>(shown) * (position_bytes + colours * colour_bytes);
    room_ = std::clamp(static_cast<Index>(atom_bytes(shown) / bytes), Index{1}, most_frames);
    every_ = std::max(Index{1}, (expected_ + room_ - 1) / room_);
}

AtomFrames::Kept AtomFrames::kept(const Configuration& configuration) const {
    Kept found{configuration.step.value_or(0), configuration.time.value_or(0.0), configuration.edges, {}, {}, {}};
    for (std::size_t k = 0; k < configuration.positions.size(); k += static_cast<std::size_t>(each_)) {
        for (int axis = 0; axis < 3; ++axis) {
            const double fraction = configuration.positions[k][axis] / configuration.edges[axis];
            const double place = std::floor((fraction - std::floor(fraction)) * grid);
            found.positions.push_back(static_cast<std::uint16_t>(std::min(place, grid - 1.0)));
        }
        if (!configuration.velocities.empty()) {
            found.speeds.push_back(static_cast<float>(configuration.velocities[k].norm()));
        }
    }
    if (counts_) {
        found.neighbours = neighbour_counts(configuration.positions, configuration.edges, neighbour_distance);
    }
    return found;
}

void AtomFrames::add(const Frame& frame) {
    if (seen_ == 0) {
        begin(frame);
    }
    if (seen_++ % every_ != 0) {
        return;
    }
    if (static_cast<Index>(kept_.size()) == room_) {
        std::size_t k = 0;
        std::erase_if(kept_, [&](const Kept&) { return k++ % 2 == 1; });
        every_ *= 2;
        if ((seen_ - 1) % every_ != 0) {
            return;
        }
    }
    kept_.push_back(kept(frame.configuration));
}

Data AtomFrames::data(const std::string& words) const {
    if (kept_.empty()) {
        return nullptr;
    }
    Data times = Data::list();
    Data steps = Data::list();
    Data boxes = Data::list();
    std::vector<std::uint16_t> positions;
    std::vector<float> speeds;
    std::vector<std::uint8_t> neighbours;
    const bool same_box = std::ranges::all_of(kept_, [&](const Kept& one) { return one.edges == kept_.front().edges; });
    for (const Kept& one : kept_) {
        times.push_back(one.time);
        steps.push_back(one.step);
        if (!same_box || boxes.empty()) {
            boxes.push_back(edges_data(one.edges));
        }
        positions.insert(positions.end(), one.positions.begin(), one.positions.end());
        speeds.insert(speeds.end(), one.speeds.begin(), one.speeds.end());
        neighbours.insert(neighbours.end(), one.neighbours.begin(), one.neighbours.end());
    }
    const std::size_t shown = kept_.front().positions.size() / 3;
    Data colours = Data::list();
    constexpr double full = 255.0;
    if (speeds.size() == shown * kept_.size()) {
        const double high = high_speed(speeds);
        std::vector<std::uint8_t> bytes;
        bytes.reserve(speeds.size());
        for (const float speed : speeds) {
            bytes.push_back(static_cast<std::uint8_t>(std::min(full, std::round(full * speed / high))));
        }
        colours.push_back(colour_data("speed", "speed / sqrt(epsilon/m)", high, bytes));
    }
    if (neighbours.size() == shown * kept_.size()) {
        const double high = std::max<double>(1.0, *std::ranges::max_element(neighbours));
        for (std::uint8_t& count : neighbours) {
            count = static_cast<std::uint8_t>(std::round(full * count / high));
        }
        colours.push_back(colour_data("coordination", "neighbours within 1.5 sigma", high, neighbours));
    }
    const auto frames = std::ssize(kept_);
    std::string said = frames == seen_ ? fmt::format("{} frame{}", frames, frames == 1 ? "" : "s")
                                       : fmt::format("{} of {} frames are shown, one in {}, to keep the page small",
                                                     frames, seen_, every_);
    if (each_ > 1) {
        said += fmt::format("; {} of {} atoms are shown, one in {}", shown, atoms_, each_);
    }
    if (!counts_) {
        said += fmt::format("; no colours by coordination: neighbours are counted for at most {} atoms", most_counted);
    }
    return {{"atoms", atoms_},
            {"shown_atoms", shown},
            {"frames", seen_},
            {"shown_frames", frames},
            {"words", words.empty() ? said + "." : fmt::format("{}. {}", said, words)},
            {"times", times},
            {"steps", steps},
            {"box", boxes},
            {"positions", base64(positions)},
            {"colours", colours}};
}

Data trajectory_atoms(const std::filesystem::path& path, const std::optional<SubstanceUnits>& units, Index expected,
                      std::vector<std::string>& warnings) {
    AtomFrames frames(expected);
    add_if_readable(warnings, [&] {
        const std::unique_ptr<TrajectoryReader> reader = open_trajectory(path, units);
        Frame frame;
        while (reader->next(frame)) {
            frames.add(frame);
        }
        for (const std::string& warning : reader->warnings()) {
            warnings.push_back(fmt::format("{}: {}", path.string(), warning));
        }
    });
    return frames.data("");
}

std::vector<std::uint8_t> neighbour_counts(const std::vector<Vec3>& positions, const Vec3& edges, double distance) {
    constexpr double most_cells = 1e6;    // along an edge: the number of a cell fits its type
    constexpr int most_looked_at = 2048;  // other atoms, for one: at a density of 9, where nothing is a liquid
    // Cells at least as wide as the distance; with fewer than three along an edge, all atoms are looked at.
    std::array<Index, 3> cells{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double count = std::floor(edges[static_cast<Index>(axis)] / distance);
        cells[axis] = count < 3.0 ? 1 : static_cast<Index>(std::min(count, most_cells));
    }
    const auto cell_of = [&](const Vec3& r) {
        std::array<Index, 3> cell{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double fraction = r[static_cast<Index>(axis)] / edges[static_cast<Index>(axis)];
            const double place = (fraction - std::floor(fraction)) * static_cast<double>(cells[axis]);
            cell[axis] = std::min(static_cast<Index>(place), cells[axis] - 1);
        }
        return cell;
    };
    const auto number = [&](const std::array<Index, 3>& cell) {
        return (cell[0] * cells[1] + cell[1]) * cells[2] + cell[2];
    };
    std::unordered_map<Index, std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        members[number(cell_of(positions[i]))].push_back(i);
    }
    // An atom's own cell comes first: where many atoms are in one place, they are enough.
    const auto around = [&](std::size_t axis, Index at) {
        const Index count = cells[axis];
        return count == 1 ? std::vector{at} : std::vector{at, (at + 1) % count, (at + count - 1) % count};
    };
    const auto count_around = [&](std::size_t i) {
        constexpr std::uint8_t most = 255;
        const std::array<Index, 3> cell = cell_of(positions[i]);
        std::uint8_t found = 0;
        int looked_at = 0;
        for (const Index x : around(0, cell[0])) {
            for (const Index y : around(1, cell[1])) {
                for (const Index z : around(2, cell[2])) {
                    const auto here = members.find(number({x, y, z}));
                    if (here == members.end()) {
                        continue;
                    }
                    for (const std::size_t j : here->second) {
                        Vec3 apart = positions[i] - positions[j];
                        apart -= edges.cwiseProduct((apart.cwiseQuotient(edges)).array().round().matrix());
                        if (j != i && apart.squaredNorm() < distance * distance) {
                            ++found;
                        }
                        if (found == most || ++looked_at == most_looked_at) {
                            return found;
                        }
                    }
                }
            }
        }
        return found;
    };
    std::vector<std::uint8_t> counts(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        counts[i] = count_around(i);
    }
    return counts;
}

}  // namespace ljmd
