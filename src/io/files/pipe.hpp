#pragma once

namespace ljmd {

/// A pipe that started programs do not inherit. Its reader sees the end when the writer closes its end or dies.
class Pipe {
  public:
    /// @throws FileError
    Pipe();
    ~Pipe();
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    /// Descriptors; -1 when closed.
    [[nodiscard]] int read_end() const { return ends_[0]; }
    [[nodiscard]] int write_end() const { return ends_[1]; }
    void close_read_end() { close_end(ends_[0]); }
    void close_write_end() { close_end(ends_[1]); }

  private:
    static void close_end(int& end);

    int ends_[2] = {-1, -1};  // NOLINT(*-avoid-c-arrays): what pipe() fills
};

}  // namespace ljmd
