#pragma once

#include "formats/format.h"

#include <cstdint>
#include <string>

namespace morph {

/// Names of nodes are at most this long.
inline constexpr int kCgnsNameLength = 32;

/// Room for a name that libcgns fills in, with its end.
inline constexpr int kCgnsNameRoom = kCgnsNameLength + 1;

/// Child of a Family_t or FlowSolution_t node that holds what names of nodes cannot; and of the family of a
/// marker that has no edges, for which no boundary condition can be.
inline constexpr const char* kCgnsLongName = "PercentEncodedName";
inline constexpr const char* kCgnsFieldTable = "PercentEncodedFields";
inline constexpr const char* kCgnsNoEdges = "NoEdges";

/// A CGNS file opened for reading with libcgns. It is not closed again: the process that reads ends anyway.
class CgnsFile {
public:
    /// @param path  of a copy of the file that may be changed; @p input is for messages
    /// @throws InputError  it is no CGNS file
    CgnsFile(const InputBytes& input, const std::string& path);

    int number() const { return number_; }
    const InputBytes& input() const { return input_; }

    /// @throws InputError  "path: what"
    [[noreturn]] void fail(const std::string& what) const;

    /// For the status that a function of libcgns returned while it read @p what.
    /// @throws InputError  "path: what cannot be read: the words of libcgns"
    void require(int status, const std::string& what) const;

    /// @throws InputError  a file of this size cannot hold so many
    void require_plausible(std::int64_t count, const std::string& of, const std::string& what) const;

    /// The text of the Descriptor_t of that name below the node that cg_goto() went to; empty: there is none.
    static std::string descriptor(const std::string& name);

private:
    void accept_newer_version(int type) const;
    void read_version(int type) const;

    const InputBytes& input_;
    std::string path_;
    int number_ = -1;
};

} // namespace morph
