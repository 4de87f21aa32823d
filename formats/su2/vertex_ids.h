#pragma once

#include "formats/text/text_scanner.h"

#include <vector>

namespace morph {

/// The ids that may stand at the end of the vertex lines of an SU2 file.
///
/// Nearly every file numbers its lines from 0, and then nothing is stored. Lines without an id have
/// the number of the line. Where several numbers follow the coordinates (a z of a planar mesh, local
/// and global ids of a partition), the last column is the id, unless the first one numbers the lines.
class Su2VertexIds {
public:
    /// Read what follows the coordinates of the vertex that is the @p vertex-th line.
    /// @throws InputError  something else than numbers follows
    void read(TextScanner& in, Index vertex);

    /// The id of each line, or empty when ids are the numbers of the lines.
    /// @throws InputError  the ids are not 0 to count - 1, each once, naming the line
    std::vector<Index> permutation(TextScanner& in, std::size_t section, Index count) const;

private:
    void read_columns(TextScanner& in, Index vertex);
    void store(Index vertex, std::int64_t id);

    std::vector<std::int64_t>
        ids_; ///< of the first lines; empty as long as they are the numbers of the lines
    bool first_column_counts_ = true;
};

inline void Su2VertexIds::read(TextScanner& in, Index vertex)
{
    const std::size_t start = in.position();
    Index id = vertex;
    const bool usual = in.at_line_end() || (in.try_index(id) && id == vertex && in.at_line_end());
    if (usual && ids_.empty())
        return;
    in.seek(start);
    read_columns(in, vertex);
}

} // namespace morph
