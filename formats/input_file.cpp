#include "formats/input_file.h"

#include "formats/binary/gzip.h"
#include "libmorph/core/error.h"

#include <array>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace morph {

namespace {

[[noreturn]] void fail(const std::string& path, int error_number)
{
    throw InputError(path + ": cannot be read: " + std::strerror(error_number));
}

/// Closes the descriptor on every way out.
struct Descriptor {
    int number;
    explicit Descriptor(int n) : number(n) {}
    ~Descriptor() { close(number); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
};

std::string read_stream(int descriptor, const std::string& path)
{
    std::string text;
    std::array<char, 65536> block{};
    for (;;) {
        const ssize_t count = read(descriptor, block.data(), block.size());
        if (count == 0)
            return text;
        if (count < 0 && errno != EINTR)
            fail(path, errno);
        if (count > 0)
            text.append(block.data(), static_cast<std::size_t>(count));
    }
}

} // namespace

InputFile::InputFile(const std::string& path) : InputFile()
{
    load(path);
    if (is_gzip(bytes_))
        expand(path);
}

void InputFile::load(const std::string& path)
{
    const int number = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (number < 0)
        fail(path, errno);
    const Descriptor file(number);
    struct stat info {};
    if (fstat(file.number, &info) != 0)
        fail(path, errno);
    if (S_ISDIR(info.st_mode))
        fail(path, EISDIR);
    if (S_ISCHR(info.st_mode) || S_ISBLK(info.st_mode))
        throw InputError(path + ": cannot be read: it is a device, which may never end");
    if (!S_ISREG(info.st_mode)) {
        stream_ = read_stream(file.number, path);
        bytes_ = stream_;
        return;
    }
    const auto size = static_cast<std::size_t>(info.st_size);
    require_memory(path, size);
    if (size == 0)
        return;
    mapping_ = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.number, 0);
    if (mapping_ == MAP_FAILED) {
        mapping_ = nullptr;
        fail(path, errno);
    }
    madvise(mapping_, size, MADV_SEQUENTIAL);
    bytes_ = {static_cast<const char*>(mapping_), size};
}

void InputFile::expand(const std::string& path)
{
    std::string text = gunzip(bytes_, path);
    unmap();
    stream_ = std::move(text);
    bytes_ = stream_;
}

InputFile::~InputFile()
{
    unmap();
}

void InputFile::unmap()
{
    if (mapping_)
        munmap(mapping_, bytes_.size());
    mapping_ = nullptr;
}

} // namespace morph
