#include "io/formats/trajectory_writer.hpp"

#include <utility>

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/registry.hpp"

namespace ljmd {

namespace {

class TextTrajectory : public TrajectoryWriter {
  public:
    TextTrajectory(const State& first, TrajectoryOptions options, WriteFrame write_frame)
        : TrajectoryWriter(first, options),
          file_(options.path, options.kept ? std::optional(options.kept->bytes) : std::nullopt),
          options_(std::move(options)),
          write_frame_(std::move(write_frame)) {
        options_.path.directory.sync();
    }

    CommittedFrames commit() override { return {.bytes = file_.commit()}; }
    void close() override { file_.close_on_disk(); }

  private:
    void append(const State& state, std::span<const double> energies) override {
        write_frame_(file_, state, energies, options_);
        file_.flush();
    }

    OutputFile file_;
    TrajectoryOptions options_;
    WriteFrame write_frame_;
};

}  // namespace

void TrajectoryWriter::write(const State& state, std::span<const double> energies) {
    if (state.total() != count_ || state.has_box() != has_box_) {
        throw ContractViolation("a trajectory keeps its number of atoms and its kind of box");
    }
    if (has_forces_ && !state.forces_are_current()) {
        throw ContractViolation("the forces of a frame belong to its positions");
    }
    if (static_cast<Index>(energies.size()) != (has_energies_ ? count_ : 0)) {
        throw ContractViolation("a frame has as many energies as atoms where its file has energies, else none");
    }
    append(state, energies);
}

MakeTrajectory text_trajectory(const WriteFrame& write_frame) {
    return [write_frame](const State& first, const TrajectoryOptions& options) -> std::unique_ptr<TrajectoryWriter> {
        return std::make_unique<TextTrajectory>(first, options, write_frame);
    };
}

std::unique_ptr<TrajectoryWriter> make_trajectory_writer(const std::string& format, const State& first,
                                                         const TrajectoryOptions& options) {
    return find_plugin(all_trajectory_formats(), format, "trajectory format").make(first, options);
}

double trajectory_bytes(const std::string& format, Index atoms, Index frames, const AtomColumns& columns) {
    return find_plugin(all_trajectory_formats(), format, "trajectory format").bytes(atoms, frames, columns);
}

}  // namespace ljmd
