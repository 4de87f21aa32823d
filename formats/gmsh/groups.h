#pragma once

#include "formats/gmsh/names.h"
#include "formats/gmsh/scanner.h"
#include "libmorph/mesh/mesh_data.h"

#include <array>
#include <map>
#include <vector>

namespace morph {

/// Turns the physical groups of a Gmsh file into markers (lines) and groups (faces). Lines of no physical
/// group are a marker `curve_N`, N being the tag of their curve; what lies between partitions is left out.
class GmshGroups {
public:
    /// Where the elements of one origin belong.
    struct Place {
        std::vector<std::size_t> numbers; ///< of markers or groups
        std::vector<bool> reversed;       ///< for each, whether it takes the line from end to start
        bool left_out = false;            ///< between partitions
    };

    GmshGroups(GmshScanner& in, const GmshNames& names, MeshData& mesh);

    /// Read $PhysicalNames, $Entities or $PartitionedEntities, which the scanner has entered.
    void read_names();
    void read_entities(bool partitioned);
    /// Make the markers and groups that have names, in their order. To be called behind the above.
    void begin();

    /// @param dimension  1: lines, 2: faces
    /// @param entity     tag of their curve or surface
    /// @param physical   tag of their physical group in files of version 2; 0: in none, or another version
    const Place& place(int dimension, std::int64_t entity, std::int64_t physical);

private:
    struct Entity {
        std::vector<std::int64_t> physicals; ///< negative: reversed
        bool interface = false;              ///< between partitions
    };
    void read_entity(int dimension, bool partitioned);
    void add_physicals(Place& place, int dimension, const std::vector<std::int64_t>& physicals);
    std::size_t number_of(int dimension, std::int64_t physical, const std::string& unnamed);

    GmshScanner& in_;
    const GmshNames& long_names_;
    MeshData& mesh_;
    std::vector<std::pair<int, std::int64_t>> order_; ///< dimension and tag of what is named, as in the file
    std::map<std::pair<int, std::int64_t>, std::string> names_;
    std::vector<std::int64_t> no_groups_; ///< tags of groups of elements that are in none
    std::array<std::map<std::int64_t, Entity>, 4> entities_;
    std::map<std::pair<int, std::int64_t>, std::size_t> numbers_;
    std::map<std::array<std::int64_t, 3>, Place> places_;
};

} // namespace morph
