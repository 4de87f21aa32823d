#include "formats/binary/gzip.h"

#include "libmorph/core/error.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <limits>

#include <sys/resource.h>
#include <zlib.h>

namespace morph {

namespace {

constexpr std::size_t kMebibyte = 1 << 20;

/// Bytes that can still be had: what the kernel calls available, or what the limit of the process allows.
std::size_t free_memory()
{
    std::size_t free = std::numeric_limits<std::size_t>::max();
    std::ifstream info("/proc/meminfo");
    for (std::string key, unit; info >> key;) {
        std::size_t kibibytes = 0;
        info >> kibibytes;
        std::getline(info, unit);
        if (key == "MemAvailable:")
            free = kibibytes * 1024;
    }
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        free = std::min<std::size_t>(free, limit.rlim_cur);
    return free;
}

/// Ends the stream on every way out.
struct Inflater {
    z_stream stream{};
    Inflater()
    {
        constexpr int kGzipWindow = 15 + 16; // largest window, gzip's header (zlib's manual, inflateInit2)
        if (inflateInit2(&stream, kGzipWindow) != Z_OK)
            throw SolverError("zlib could not begin to decompress");
    }
    ~Inflater() { inflateEnd(&stream); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;
};

/// One more block of output. @return what inflate() says
int inflate_block(z_stream& stream, std::string& text)
{
    constexpr std::size_t kFirstBlock = 1 << 16;
    const std::size_t done = text.size();
    text.resize(std::max(kFirstBlock, done + done / 2));
    const auto room = static_cast<uInt>(std::min<std::size_t>(text.size() - done, 1U << 30U));
    stream.next_out = reinterpret_cast<Bytef*>(text.data() + done);
    stream.avail_out = room;
    const int status = inflate(&stream, Z_NO_FLUSH);
    text.resize(done + (room - stream.avail_out));
    return status;
}

} // namespace

bool is_gzip(std::string_view bytes)
{
    return bytes.starts_with("\x1f\x8b\x08");
}

std::string without_gz(const std::string& path)
{
    constexpr std::size_t kLength = 3;
    if (path.size() <= kLength)
        return path;
    std::string end = path.substr(path.size() - kLength);
    std::transform(end.begin(), end.end(), end.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return end == ".gz" ? path.substr(0, path.size() - kLength) : path;
}

void require_memory(const std::string& path, std::size_t bytes)
{
    const std::size_t free = free_memory();
    if (bytes > free)
        throw InputError(path + ": holds " + std::to_string(bytes / kMebibyte) + " MiB, but only " +
                         std::to_string(free / kMebibyte) + " MiB of memory are free");
}

std::string gunzip(std::string_view bytes, const std::string& path)
{
    constexpr std::size_t kLargestPiece = 1U << 30U;
    const std::size_t most = free_memory() / 2; // the text grows next to the compressed bytes
    Inflater inflater;
    z_stream& stream = inflater.stream;
    std::string text;
    for (;;) {
        const auto piece = static_cast<uInt>(std::min(bytes.size(), kLargestPiece));
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
        stream.avail_in = piece;
        const int status = inflate_block(stream, text);
        if (status != Z_OK && status != Z_STREAM_END)
            throw InputError(path + ": cannot be decompressed: the gzip data are " +
                             (status == Z_BUF_ERROR ? "cut short" : "damaged"));
        if (text.size() > most)
            throw InputError(path + ": expands to more than " + std::to_string(most / kMebibyte) +
                             " MiB, half of the memory that is free");
        bytes.remove_prefix(piece - stream.avail_in);
        if (status == Z_STREAM_END && !is_gzip(bytes))
            return text; // padding behind the last member is allowed
        if (status == Z_STREAM_END)
            inflateReset(&stream);
    }
}

} // namespace morph
