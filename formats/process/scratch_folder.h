#pragma once

#include <string>
#include <string_view>

namespace morph {

/// A folder of its own among the system's temporary files, for libraries that want paths instead of bytes. It
/// is removed, with all in it, when this goes.
class ScratchFolder {
public:
    /// @throws InputError  it cannot be made; names it, TMPDIR chooses another place
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::string file(const std::string& name) const { return path_ + "/" + name; }

    /// Write a file in it and return its path.
    /// @throws InputError  there is no room for it
    std::string write(const std::string& name, std::string_view bytes) const;

private:
    std::string path_;
};

} // namespace morph
