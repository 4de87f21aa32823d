#pragma once

#include "formats/format.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace morph {

/// The sections of a MEDIT file (.mesh, .sol, and .meshb, .solb in binary), front to back, and the numbers in
/// them. The format is that of libMeshb 7: https://github.com/LoicMarechal/libMeshb.
class MeditSource {
public:
    virtual ~MeditSource() = default;
    MeditSource() = default;
    MeditSource(const MeditSource&) = delete;
    MeditSource& operator=(const MeditSource&) = delete;

    int version() const { return version_; }
    /// 2 or 3.
    int dimension() const { return dimension_; }

    /// Go to the next section; false at the end. What is left of the last one is passed over.
    virtual bool next() = 0;
    /// Keyword of this section.
    const std::string& section() const { return section_; }
    /// Where that stands.
    std::size_t section_position() const { return section_position_; }

    /// The number of lines of this section.
    virtual std::size_t count() = 0;
    /// @throws InputError  the rest of the file cannot hold so many lines of so many numbers
    virtual void require_room(std::size_t lines, std::size_t integers, std::size_t reals) = 0;
    /// A number that binary files write in 4 bytes in every version.
    virtual std::int64_t word(std::string_view what) = 0;
    virtual bool try_integer(std::int64_t& value) = 0;
    /// Also what is not finite.
    virtual bool try_real(double& value) = 0;

    /// Of what is read next.
    virtual std::size_t position() = 0;
    /// The part of the file that comments can be in.
    virtual std::string_view comments() const = 0;
    /// @throws InputError  "path:line: …", in binary "path: byte 12: …"
    [[noreturn]] virtual void fail_at(std::size_t position, const std::string& what) const = 0;
    [[noreturn]] virtual void fail_expected(const std::string& what) const = 0;

protected:
    int version_ = 0;
    int dimension_ = 0;
    std::string section_;
    std::size_t section_position_ = 0;
};

/// Open a file, text or binary as its first bytes say, in either byte order, and read what stands before
/// the sections.
/// @throws InputError  this is no such file; a version or dimension not known
std::unique_ptr<MeditSource> open_medit(const InputBytes& file);

/// As open_medit(), of each kind.
std::unique_ptr<MeditSource> open_medit_text(const InputBytes& file);
std::unique_ptr<MeditSource> open_medit_binary(const InputBytes& file);

} // namespace morph
