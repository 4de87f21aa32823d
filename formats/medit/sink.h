#pragma once

#include "formats/output_file.h"

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

namespace morph {

/// Writes the sections of a MEDIT file, as text or binary. Every section has lines of the same numbers.
class MeditSink {
public:
    virtual ~MeditSink() = default;
    MeditSink() = default;
    MeditSink(const MeditSink&) = delete;
    MeditSink& operator=(const MeditSink&) = delete;

    /// Begin a section.
    /// @param types     of the solutions in a line; empty: this is no section of solutions
    /// @param integers  in a line, behind the reals
    virtual void section(std::string_view keyword, std::size_t lines, const std::vector<int>& types,
                         std::size_t reals, std::size_t integers) = 0;
    virtual void line(const double* reals, const std::int64_t* integers) = 0;

    /// @param comments  lines, each with a '#', that go behind the last section
    virtual void end(std::string_view comments) = 0;
};

/// @param dimension  2 or 3
/// @param bytes      about what a binary file will take, which decides its version: 2 below 2^31, else 3
std::unique_ptr<MeditSink> medit_sink(OutputFile& out, bool binary, int dimension, std::size_t bytes);

/// Whether a file is binary: by its extension as libMeshb does (.meshb and .solb are), for another as asked for.
bool is_binary_medit(const std::string& path, bool wanted);

} // namespace morph
