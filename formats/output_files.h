#pragma once

#include "formats/output_file.h"

#include <memory>
#include <string>
#include <vector>

namespace morph {

/// Files that are written together: all of them appear together at the end, or none does.
class OutputFiles {
public:
    /// Make sure that @p path can be written, before work that would be lost.
    /// @throws InputError  it cannot
    static void require_writable(const std::string& path);

    /// A new file, to be filled now and committed with the others.
    OutputFile& open(const std::string& path);

    /// Rename every file into place, in the order they were opened.
    void commit();

private:
    std::vector<std::unique_ptr<OutputFile>> files_;
};

} // namespace morph
