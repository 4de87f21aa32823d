#pragma once

#include <string>
#include <string_view>

namespace morph {

/// The bytes of a file, mapped into memory for as long as this lives.
class InputFile {
public:
    /// @throws InputError  the file does not exist, is a folder or a device, or cannot be read
    explicit InputFile(const std::string& path);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    std::string_view bytes() const { return bytes_; }

private:
    std::string stream_; ///< what came through a pipe, which cannot be mapped
    void* mapping_ = nullptr;
    std::string_view bytes_;
};

} // namespace morph
