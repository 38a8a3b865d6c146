#pragma once

namespace ljmd {

/// A pipe whose ends no program inherits that this one starts. Its reader finds the end when the writer has closed its
/// end, or has died.
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
