#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace morph {

/// A file that appears whole or not at all: bytes go to a temporary next to it, commit() renames.
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

    /// Room for @p count bytes, to be filled in place and then taken with advance_to(): for text made
    /// of many small pieces, such as the numbers of a line.
    /// @throws InputError  the disk is full, …
    char* room(std::size_t count);
    /// Take the bytes from room() up to @p end.
    void advance_to(const char* end) { used_ = static_cast<std::size_t>(end - buffer_.data()); }

    /// Write out what is left and close, so that only the name is missing.
    /// @throws InputError  the bytes could not be written
    void close();

    /// close(), and rename into place. A file that was there before keeps its permissions.
    /// @throws InputError  as close(), or the name could not be taken
    void commit();

    const std::string& path() const { return path_; }

private:
    void flush();
    void write_all(std::string_view bytes);
    [[noreturn]] void fail(int error_number) const;

    std::string path_;
    std::string target_; ///< where a link called path_ leads
    std::string temporary_;
    std::vector<char> buffer_;
    std::size_t used_ = 0; ///< bytes of the buffer not yet written
    int descriptor_ = -1;
    bool committed_ = false;
};

inline char* OutputFile::room(std::size_t count)
{
    if (buffer_.size() - used_ < count) {
        flush();
        if (buffer_.size() < count)
            buffer_.resize(count);
    }
    return buffer_.data() + used_;
}

} // namespace morph
