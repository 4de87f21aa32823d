#include "formats/binary/memory_file.h"

#include "libmorph/core/error.h"

#include <cerrno>
#include <cstring>

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace morph {

namespace {

[[noreturn]] void fail(const char* what)
{
    throw SolverError(std::string("a file in memory cannot be ") + what + ": " + std::strerror(errno));
}

} // namespace

MemoryFile::MemoryFile() : descriptor_(memfd_create("morph", MFD_CLOEXEC))
{
    if (descriptor_ < 0)
        fail("made");
}

MemoryFile::~MemoryFile()
{
    unmap();
    close(descriptor_);
}

void MemoryFile::append(std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR)
            fail("written");
        bytes.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
    }
}

std::string_view MemoryFile::bytes()
{
    unmap();
    struct stat info {};
    if (fstat(descriptor_, &info) != 0)
        fail("read");
    if (info.st_size == 0)
        return {};
    mapped_ = static_cast<std::size_t>(info.st_size);
    mapping_ = mmap(nullptr, mapped_, PROT_READ, MAP_SHARED, descriptor_, 0);
    if (mapping_ == MAP_FAILED) {
        mapping_ = nullptr;
        fail("read");
    }
    return {static_cast<const char*>(mapping_), mapped_};
}

void MemoryFile::unmap()
{
    if (mapping_)
        munmap(mapping_, mapped_);
    mapping_ = nullptr;
}

} // namespace morph
