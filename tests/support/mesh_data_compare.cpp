#include "tests/support/mesh_data_compare.h"

#include <cstring>

namespace morph::test {

namespace {

template <class M>
bool same_bits(const M& a, const M& b)
{
    return a.rows() == b.rows() && a.cols() == b.cols() &&
           (a.size() == 0 ||
            std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0);
}

std::string field_difference(const Field& a, const Field& b)
{
    if (a.name != b.name)
        return "fields '" + a.name + "' and '" + b.name + "'";
    if (a.location != b.location)
        return "place of field " + a.name;
    return same_bits(a.values, b.values) ? "" : "values of field " + a.name;
}

} // namespace

std::string difference(const MeshData& a, const MeshData& b)
{
    if (a.dimension != b.dimension)
        return "dimension";
    if (!same_bits(a.points, b.points))
        return "points";
    if (a.elements != b.elements)
        return "elements";
    if (a.markers.size() != b.markers.size())
        return "number of markers";
    for (std::size_t m = 0; m < a.markers.size(); ++m) {
        if (a.markers[m].name != b.markers[m].name)
            return "markers '" + a.markers[m].name + "' and '" + b.markers[m].name + "'";
        if (a.markers[m].edges != b.markers[m].edges)
            return "edges of marker " + a.markers[m].name;
    }
    if (a.groups.size() != b.groups.size())
        return "number of groups";
    for (std::size_t g = 0; g < a.groups.size(); ++g) {
        if (a.groups[g].name != b.groups[g].name)
            return "groups '" + a.groups[g].name + "' and '" + b.groups[g].name + "'";
        if (a.groups[g].elements != b.groups[g].elements)
            return "elements of group " + a.groups[g].name;
    }
    if (a.fields.size() != b.fields.size())
        return "number of fields";
    for (std::size_t f = 0; f < a.fields.size(); ++f)
        if (const std::string what = field_difference(a.fields[f], b.fields[f]); !what.empty())
            return what;
    return "";
}

} // namespace morph::test
