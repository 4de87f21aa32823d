#pragma once

#include "formats/output_file.h"
#include "formats/text/number_text.h"
#include "libmorph/mesh/mesh_data.h"

#include <cstring>
#include <string_view>
#include <vector>

namespace morph {

/// Writes the numbers of a Gmsh file, a record of them at a time, as a line of text or as bytes in the
/// order of this machine.
class GmshOutput {
public:
    static constexpr std::size_t kMostNumbers = 16;

    GmshOutput(OutputFile& file, bool binary) : file_(file), binary_(binary) {}

    bool binary() const { return binary_; }
    void line(std::string_view text)
    {
        file_.append(text);
        file_.append("\n");
    }

    /// Begin with room for kMostNumbers numbers.
    void begin_record() { to_ = file_.room(kMostNumbers * kLongestNumber); }
    void integer(std::int64_t value) { put(static_cast<std::int32_t>(value)); }
    void size(std::int64_t value) { put(value); }
    void real(double value) { put(value); }
    void end_record()
    {
        if (!binary_)
            to_[-1] = '\n';
        file_.advance_to(to_);
    }

    /// Make room for kMostNumbers more numbers of the record.
    void next_part()
    {
        file_.advance_to(to_);
        begin_record();
    }

    /// What parts the last record from the end of a section.
    void end_numbers()
    {
        if (binary_)
            file_.append("\n");
    }

private:
    void put(auto value)
    {
        if (!binary_) {
            to_ = number_text(to_, value, ' ');
            return;
        }
        std::memcpy(to_, &value, sizeof value);
        to_ += sizeof value;
    }

    OutputFile& file_;
    bool binary_;
    char* to_ = nullptr; ///< behind the last number of the record
};

/// What both versions have in common.
void write_gmsh_header(GmshOutput& out, std::string_view version);

/// Physical names, and where needed comments.
/// @param no_group  see GmshSurfaces
void write_gmsh_names(GmshOutput& out, const MeshData& mesh, Index no_group);

/// @param faces  the elements as the file has them behind the lines, with tags that count up from 1 with the
///               lines; meshio needs values for every element of a file, so lines have those of one next to
void write_gmsh_fields(GmshOutput& out, const MeshData& mesh, const std::vector<Index>& faces);

} // namespace morph
