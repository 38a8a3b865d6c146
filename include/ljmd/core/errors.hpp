#pragma once

#include <stdexcept>
#include <string>

namespace ljmd {

/// Base of all errors that the library reports to its caller. The library never exits; the application maps each type
/// to an exit code.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// What was asked for is wrong: a command line, a deck, a specification, an argument. The text holds all mistakes
/// found.
class InputError : public Error {
  public:
    using Error::Error;
};

/// A data file, such as a start configuration, cannot be used. The text names file, line and frame.
class DataError : public Error {
  public:
    using Error::Error;
};

/// An output could not be written.
class FileError : public Error {
  public:
    using Error::Error;
};

/// A checkpoint cannot be used: it is damaged, belongs to another run, or was written by another version of the
/// program.
class CheckpointError : public Error {
  public:
    using Error::Error;
};

/// Another run is writing to the output directory.
class InUseError : public Error {
  public:
    using Error::Error;
};

/// The run left the domain of physics: positions that are not finite, a time step too large.
class PhysicsError : public Error {
  public:
    using Error::Error;
};

/// A mistake in ljmd itself, whatever its input. No Error, so that nobody takes it for a wrong input.
class ContractViolation : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

}  // namespace ljmd
