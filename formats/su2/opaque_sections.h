#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <string>
#include <string_view>
#include <vector>

namespace morph {

/// Collects what an SU2 file holds and a mesh does not; neighbours of one kind become one text.
class Su2OpaqueSections {
public:
    /// Sections called FFD_…, NPERIODIC or PERIODIC_…, or anything else.
    void add_section(std::string_view key, std::string_view text);
    /// A marker that only SU2 knows what to do with.
    void add_marker(std::string_view text);
    /// Vertices in a marker, @p text being its lines.
    void add_marker_vertices(const std::string& marker, std::size_t count, const std::string& text);
    /// A count line with further numbers, such as "NPOIN= 16009 15715".
    void add_header(std::string_view line);

    std::vector<OpaqueSection> texts() const;

private:
    struct Section {
        std::string what; ///< with the number of things in front of it when it is counted
        bool counted = false;
        std::size_t count = 0;
        std::string text;
        bool names_vertices = true;
    };
    Section& append(const std::string& what, bool counted, std::size_t count, std::string_view text);

    std::vector<Section> sections_;
};

} // namespace morph
