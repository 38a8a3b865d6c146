#include "ljmd/io/formats/trajectory_writer.hpp"

#include <utility>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/registry.hpp"

namespace ljmd {

namespace {

class TextTrajectory : public TrajectoryWriter {
  public:
    TextTrajectory(const State& first, TrajectoryOptions options, WriteFrame write_frame)
        : file_(options.path, options.kept ? std::optional(options.kept->bytes) : std::nullopt),
          options_(std::move(options)),
          write_frame_(std::move(write_frame)),
          count_(first.count()),
          has_box_(first.has_box()) {
        options_.path.directory.sync();
    }

    void write(const State& state) override {
        if (state.count() != count_ || state.has_box() != has_box_) {
            throw ContractViolation("a trajectory keeps its number of atoms and its kind of box");
        }
        write_frame_(file_, state, options_);
        file_.flush();
    }

    CommittedFrames commit() override { return {.bytes = file_.commit()}; }
    void close() override { file_.close_on_disk(); }

  private:
    OutputFile file_;
    TrajectoryOptions options_;
    WriteFrame write_frame_;
    Index count_;
    bool has_box_;
};

}  // namespace

MakeTrajectory text_trajectory(const WriteFrame& write_frame) {
    return [write_frame](const State& first, const TrajectoryOptions& options) -> std::unique_ptr<TrajectoryWriter> {
        return std::make_unique<TextTrajectory>(first, options, write_frame);
    };
}

std::unique_ptr<TrajectoryWriter> make_trajectory_writer(const std::string& format, const State& first,
                                                         const TrajectoryOptions& options) {
    return find_plugin(all_trajectory_formats(), format, "trajectory format").make(first, options);
}

double trajectory_bytes(const std::string& format, Index atoms, Index frames, bool velocities) {
    return find_plugin(all_trajectory_formats(), format, "trajectory format").bytes(atoms, frames, velocities);
}

}  // namespace ljmd
