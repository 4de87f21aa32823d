#pragma once

#include "formats/output_file.h"
#include "formats/text/text_scanner.h"
#include "libmorph/mesh/mesh_data.h"

#include <vector>

namespace morph {

/// Groups of elements in comments of an SU2 file, which SU2 and others pass over:
///     % GROUP_TAG= upper side
///     % GROUP_ELEMS= 3
///     % 0 1 7
/// Names have what would not survive in a line as %XX; the numbers of elements, from 0, may run on over
/// several lines.
class Su2Groups {
public:
    /// Skip blanks, line ends and comments to the next section, reading the groups among them; false
    /// when nothing else is left.
    /// @throws InputError  "path:line: …": a group that is not written as above
    bool skip_to_section(TextScanner& in);

    /// @throws InputError  a group names an element that the mesh does not have, or one twice
    void check_elements(const TextScanner& in, std::size_t elements) const;

    std::vector<ElementGroup> take() { return std::move(groups_); }

private:
    void read(TextScanner& in);

    std::vector<ElementGroup> groups_;
    std::vector<std::size_t> positions_; ///< in the file
};

void append_su2_groups(const std::vector<ElementGroup>& groups, OutputFile& out);

} // namespace morph
