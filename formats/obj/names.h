#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <string_view>
#include <unordered_map>
#include <vector>

namespace morph {

/// Sorts what an OBJ file lists by the names above it.
class ObjNames {
public:
    /// `g NAME …`, `o NAME` or `usemtl NAME`; takes the place of the last one of its kind.
    void set_groups(const std::vector<std::string_view>& names);
    void set_object(std::string_view name);
    void set_material(std::string_view name);

    /// Element of that number, which is higher than all before, into the groups of all three kinds.
    void add_element(Index element);

    /// Into the markers of the groups; without any, of the object; without one, "lines".
    void add_edge(const std::array<Index, 2>& edge);

    std::vector<ElementGroup> take_groups() { return std::move(groups_); }
    std::vector<Marker> take_markers() { return std::move(markers_); }

private:
    /// Numbers of things by name.
    using Numbers = std::unordered_map<std::string, std::size_t>;

    void find_groups();
    void find_markers();

    std::vector<std::string> group_names_;
    std::vector<std::string> object_;
    std::vector<std::string> material_;
    std::vector<ElementGroup> groups_;
    std::vector<Marker> markers_;
    Numbers group_numbers_;
    Numbers marker_numbers_;
    std::vector<std::size_t> current_groups_; ///< those of the names above, each once
    std::vector<std::size_t> current_markers_;
    bool groups_known_ = false;
    bool markers_known_ = false;
};

} // namespace morph
