#include "formats/output_file.h"

#include "libmorph/core/error.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace morph {

namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 20;

bool is_device(const std::string& path)
{
    struct stat info {};
    return stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode);
}

/// Permissions of the file that will be replaced, or those a new file gets.
mode_t wanted_mode(const std::string& path)
{
    struct stat info {};
    if (stat(path.c_str(), &info) == 0)
        return info.st_mode & 07777;
    const mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

/// A link is followed, so that renaming replaces the file it leads to and not the link.
std::string followed(const std::string& path)
{
    std::error_code ignored;
    if (!std::filesystem::is_symlink(path, ignored))
        return path;
    const auto target = std::filesystem::weakly_canonical(path, ignored);
    return ignored ? path : target.string();
}

} // namespace

OutputFile::OutputFile(const std::string& path) : path_(path), target_(followed(path))
{
    if (std::filesystem::is_directory(path))
        fail(EISDIR);
    if (is_device(path)) {
        descriptor_ = open(path.c_str(), O_WRONLY | O_CLOEXEC);
    } else {
        if (access(target_.c_str(), F_OK) == 0 && access(target_.c_str(), W_OK) != 0)
            fail(errno);
        temporary_ = target_ + ".XXXXXX";
        descriptor_ = mkostemp(temporary_.data(), O_CLOEXEC);
        if (descriptor_ < 0)
            temporary_.clear();
    }
    if (descriptor_ < 0)
        fail(errno);
    buffer_.resize(kBufferBytes);
}

OutputFile::~OutputFile()
{
    if (descriptor_ >= 0)
        ::close(descriptor_);
    if (!committed_ && !temporary_.empty())
        unlink(temporary_.c_str());
}

void OutputFile::append(std::string_view bytes)
{
    if (bytes.size() > buffer_.size() - used_)
        flush();
    if (bytes.size() > buffer_.size()) {
        write_all(bytes);
        return;
    }
    std::copy(bytes.begin(), bytes.end(), buffer_.data() + used_);
    used_ += bytes.size();
}

void OutputFile::flush()
{
    write_all({buffer_.data(), used_});
    used_ = 0;
}

void OutputFile::write_all(std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR)
            fail(errno);
        bytes.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
    }
}

void OutputFile::close()
{
    if (descriptor_ < 0)
        return;
    flush();
    if (!temporary_.empty() && fchmod(descriptor_, wanted_mode(target_)) != 0)
        fail(errno);
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0)
        fail(errno);
}

void OutputFile::commit()
{
    close();
    if (!temporary_.empty() && std::rename(temporary_.c_str(), target_.c_str()) != 0)
        fail(errno);
    committed_ = true;
}

void OutputFile::fail(int error_number) const
{
    throw InputError(path_ + ": cannot be written: " + std::strerror(error_number));
}

} // namespace morph
