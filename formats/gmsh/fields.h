#pragma once

#include "formats/gmsh/names.h"
#include "formats/gmsh/scanner.h"
#include "formats/gmsh/tags.h"
#include "libmorph/mesh/mesh_data.h"

#include <vector>

namespace morph {

/// Reads $NodeData and $ElementData. Sections of one name and time step are parts of one field; those of
/// later steps are fields NAME_step_N of their own. Values where none are given are NaN.
class GmshFields {
public:
    /// @param tags  sorted; of the vertices, and of the elements
    GmshFields(GmshScanner& in, const InputBytes& file, const GmshNames& names, const GmshTags& nodes,
               const GmshTags& elements, MeshData& mesh)
        : in_(in), file_(file), long_names_(names), nodes_(nodes), elements_(elements), mesh_(mesh)
    {
    }

    /// Read a section, which the scanner has entered.
    void read(FieldLocation location);
    /// To be called after all: warn of fields that lack values, and leave those out that have none.
    void finish();

private:
    struct Header {
        std::string name;
        Index step = 0;
        Index components = 1; ///< in the file
        Index kept = 1;       ///< of the field
        Index rows = 0;
    };
    struct Known {
        std::string name; ///< as in the file
        Index step;
        std::vector<bool> seen; ///< rows that have values
    };
    Header read_header();
    std::size_t field_for(const Header& header, FieldLocation location);
    std::string free_name(const Header& header, FieldLocation location) const;
    double value();

    GmshScanner& in_;
    const InputBytes& file_;
    const GmshNames& long_names_;
    const GmshTags& nodes_;
    const GmshTags& elements_;
    MeshData& mesh_;
    std::vector<Known> known_; ///< of each field of the mesh
    std::vector<double> one_;  ///< value
    Index sections_ = 0;
    std::size_t numbers_ = 0; ///< of all fields
};

} // namespace morph
