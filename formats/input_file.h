#pragma once

#include <string>
#include <string_view>

namespace morph {

/// The bytes of a file, mapped into memory for as long as this lives; of a gzip file, what it stands for.
class InputFile {
public:
    /// @throws InputError  the file does not exist, is a folder or a device, cannot be read, is a damaged
    ///                     gzip file, or is more than the memory that is free
    explicit InputFile(const std::string& path);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    std::string_view bytes() const { return bytes_; }

private:
    InputFile() = default; ///< so that the destructor runs when load() or expand() throws
    void load(const std::string& path);
    void expand(const std::string& path);
    void unmap();

    std::string stream_; ///< what came through a pipe, or was decompressed, which cannot be mapped
    void* mapping_ = nullptr;
    std::string_view bytes_;
};

} // namespace morph
