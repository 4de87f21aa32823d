#pragma once

#include <stdexcept>
#include <string>

namespace morph {

/// Invalid input, which the caller can fix: a broken file, an index out of range, a name that does not exist.
/// The message is one line for a person: what is wrong, where, what was expected.
class InputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The input was legal, the computation failed: a singular system, no convergence.
class SolverError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

} // namespace morph
