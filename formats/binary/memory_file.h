#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace morph {

/// A file in memory that has no name in any folder, for handing bytes from one process to another that was
/// forked from it. It is gone with the last process that holds it.
class MemoryFile {
public:
    /// @throws SolverError  the system gives no such file
    MemoryFile();
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    /// @throws SolverError  there is no memory for them
    void append(std::string_view bytes);

    /// What is in the file now; valid until the next call or the end of this.
    std::string_view bytes();

private:
    void unmap();

    int descriptor_ = -1;
    void* mapping_ = nullptr;
    std::size_t mapped_ = 0;
};

} // namespace morph
