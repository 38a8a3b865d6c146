// The frames of a file that ljmd or another program has written: how many there are, g(r), and where an atom is.
#include <ljmd/ljmd.hpp>

#include <algorithm>
#include <iostream>

int main(int count, char** arguments) {
    if (count != 2) {
        std::cerr << "usage: frames TRAJECTORY\n";
        return 2;
    }
    try {
        const ljmd::Trajectory frames(arguments[1]);
        std::cout << frames.frames() << " frames of " << frames.atoms() << " atoms\n";
        const ljmd::TrajectoryResult found = frames.analyze({ljmd::analysis("rdf", {{"bins", 100}})});
        const auto& g = found.tables.front().rows;  // columns r, g
        const auto peak = std::ranges::max_element(g, {}, [](const auto& row) { return row[1]; });
        std::cout << "first peak of g(r): " << (*peak)[1] << " at r = " << (*peak)[0] << " sigma\n";

        frames.each([](const ljmd::Configuration& frame) {
            std::cout << "step " << frame.step.value_or(0) << ": first atom at " << frame.positions.front().transpose()
                      << '\n';
        });
    } catch (const ljmd::Error& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
