#include "formats/process/scratch_folder.h"

#include "libmorph/core/error.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace morph {

namespace {

[[noreturn]] void fail(const std::string& path)
{
    throw InputError(path + ": temporary file cannot be written: " + std::strerror(errno) +
                     "; TMPDIR chooses another place");
}

} // namespace

ScratchFolder::ScratchFolder()
{
    std::error_code ignored;
    const std::filesystem::path place = std::filesystem::temp_directory_path(ignored);
    path_ = ((place.empty() ? "/tmp" : place) / "morph.XXXXXX").string();
    if (!mkdtemp(path_.data()))
        fail(path_);
}

ScratchFolder::~ScratchFolder()
{
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string ScratchFolder::write(const std::string& name, std::string_view bytes) const
{
    std::string path = file(name);
    std::ofstream stream(path, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream)
        fail(path);
    return path;
}

} // namespace morph
