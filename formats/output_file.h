#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace morph {

/// A file that appears whole or not at all: bytes go to a temporary beside it, commit() renames.
/// A temporary that was not committed is removed.
class OutputFile {
public:
    /// @throws InputError  the folder does not exist or cannot be written, or @p path is a folder
    explicit OutputFile(const std::string& path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// @throws InputError  the disk is full, …
    void append(std::string_view bytes);

    /// Flush and rename into place. A file that was there before keeps its permissions.
    /// @throws InputError  the bytes could not be written, or the name not be taken
    void commit();

    const std::string& path() const { return path_; }

private:
    void flush();
    [[noreturn]] void fail(int error_number) const;

    std::string path_;
    std::string target_; ///< where a link called path_ leads
    std::string temporary_;
    std::string buffer_;
    int descriptor_ = -1;
    bool committed_ = false;
};

} // namespace morph
