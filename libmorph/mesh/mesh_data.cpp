#include "libmorph/mesh/mesh_data.h"

#include <algorithm>
#include <utility>

namespace morph {

const Marker* find_marker(const std::vector<Marker>& markers, const std::string& name)
{
    const auto found =
        std::find_if(markers.begin(), markers.end(), [&](const Marker& m) { return m.name == name; });
    return found == markers.end() ? nullptr : &*found;
}

const Field* find_field(const std::vector<Field>& fields, const std::string& name, FieldLocation location)
{
    const auto found = std::find_if(fields.begin(), fields.end(),
                                    [&](const Field& f) { return f.name == name && f.location == location; });
    return found == fields.end() ? nullptr : &*found;
}

void set_field(std::vector<Field>& fields, Field field)
{
    std::erase_if(fields,
                  [&](const Field& f) { return f.name == field.name && f.location == field.location; });
    fields.push_back(std::move(field));
}

int dimension_of(const Points& points)
{
    return points.rows() == 0 || (points.col(2).array() == 0).all() ? 2 : 3;
}

} // namespace morph
