#include "formats/cgns/zone.h"
#include "formats/text/message_text.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <cgnslib.h>

namespace morph {

namespace {

std::optional<VolumeShape> volume_shape(int type)
{
    switch (type) {
    case CGNS_ENUMV(TETRA_4):
        return VolumeShape::tetrahedron;
    case CGNS_ENUMV(PYRA_5):
        return VolumeShape::pyramid;
    case CGNS_ENUMV(PENTA_6):
        return VolumeShape::prism;
    case CGNS_ENUMV(HEXA_8):
        return VolumeShape::hexahedron;
    default:
        return std::nullopt;
    }
}

/// A section without its elements.
struct Head {
    cgsize_t first = 0, last = 0; ///< numbers of its elements
    int number = 0;               ///< in the zone, from 1
    std::string name;
    CGNS_ENUMT(ElementType_t) type = CGNS_ENUMV(ElementTypeNull);
};

class SectionReader {
public:
    SectionReader(const CgnsFile& file, CgnsZone& zone, const Head& head)
        : file_(file), zone_(zone), number_(head.number), type_(head.type), first_(head.first),
          last_(head.last)
    {
        section_.name = head.name;
        section_.first = head.first;
    }

    void read()
    {
        if (first_ < 1 || last_ < first_)
            fail("holds the elements " + std::to_string(first_) + " to " + std::to_string(last_));
        count_ = static_cast<std::size_t>(last_) - static_cast<std::size_t>(first_) + 1;
        read_numbers();
        add_elements();
        zone_.sections.push_back(std::move(section_));
    }

private:
    [[noreturn]] void fail(const std::string& what) const { file_.fail(title() + " " + what); }
    std::string title() const { return zone_.title() + ", section " + quoted_text(section_.name); }

    bool has_counts() const { return type_ == CGNS_ENUMV(NGON_n) || type_ == CGNS_ENUMV(NFACE_n); }

    void read_numbers()
    {
        cgsize_t size = 0;
        file_.require(cg_ElementDataSize(file_.number(), zone_.base, zone_.number, number_, &size), title());
        if (size < 0 || count_ > static_cast<std::size_t>(size))
            fail("lists " + std::to_string(count_) + " elements by " + std::to_string(size) + " numbers");
        file_.require_plausible(size, title(), "numbers");
        numbers_.resize(static_cast<std::size_t>(size));
        if (type_ == CGNS_ENUMV(MIXED) || has_counts()) {
            offsets_.resize(count_ + 1);
            file_.require(cg_poly_elements_read(file_.number(), zone_.base, zone_.number, number_,
                                                numbers_.data(), offsets_.data(), nullptr),
                          title());
        } else {
            file_.require(
                cg_elements_read(file_.number(), zone_.base, zone_.number, number_, numbers_.data(), nullptr),
                title());
        }
    }

    void add_elements()
    {
        section_.items.reserve(count_);
        if (type_ == CGNS_ENUMV(NFACE_n))
            fail("holds polyhedra (NFACE_n), which are not supported");
        if (type_ == CGNS_ENUMV(NGON_n))
            add_polygons();
        else if (type_ == CGNS_ENUMV(MIXED))
            add_mixed();
        else
            for (std::size_t e = 0; e < count_; ++e)
                add(type_);
    }

    void add_mixed()
    {
        for (std::size_t e = 0; e < count_; ++e) {
            if (at_ >= numbers_.size())
                fail("ends before element " + std::to_string(element_number()));
            const int type = numbers_[at_++];
            if (type == CGNS_ENUMV(MIXED) || type < 0 || type >= NofValidElementTypes)
                fail("has element " + std::to_string(element_number()) + " of the unknown type " +
                     std::to_string(type));
            add(type);
        }
    }

    void add_polygons()
    {
        for (std::size_t e = 0; e < count_; ++e) {
            const std::int64_t corners = std::int64_t{offsets_[e + 1]} - offsets_[e];
            if (corners != 3 && corners != 4)
                fail("has the polygon " + std::to_string(element_number()) + " of " +
                     std::to_string(corners) + " corners, but only those of 3 or 4 are supported");
            add(corners == 3 ? CGNS_ENUMV(TRI_3) : CGNS_ENUMV(QUAD_4));
        }
    }

    std::int64_t element_number() const
    {
        return section_.first + static_cast<std::int64_t>(section_.items.size());
    }

    /// The next element, of a type that has its number of corners from its name.
    void add(int type)
    {
        switch (type) {
        case CGNS_ENUMV(NODE):
            at_ += 1;
            section_.items.push_back({CgnsKind::other, 0});
            return;
        case CGNS_ENUMV(BAR_2):
            zone_.edges.push_back(corners<2>(2));
            section_.items.push_back({CgnsKind::edge, static_cast<Index>(zone_.edges.size()) - 1});
            return;
        case CGNS_ENUMV(TRI_3):
        case CGNS_ENUMV(QUAD_4): {
            const std::size_t count = type == CGNS_ENUMV(TRI_3) ? 3 : 4;
            zone_.mesh.elements.push_back(corners<4>(count));
            if (count == 3)
                zone_.mesh.elements.back()[3] = -1;
            section_.items.push_back({CgnsKind::face, static_cast<Index>(zone_.mesh.elements.size()) - 1});
            return;
        }
        default:
            break;
        }
        const auto shape = volume_shape(type);
        if (!shape)
            fail("holds elements of the type " +
                 std::string(cg_ElementTypeName(static_cast<CGNS_ENUMT(ElementType_t)>(type))) +
                 ", but only BAR_2, TRI_3, QUAD_4, TETRA_4, PYRA_5, PENTA_6 and HEXA_8 are supported");
        zone_.cells.push_back({*shape, corners<8>(static_cast<std::size_t>(corner_count(*shape)))});
        section_.items.push_back({CgnsKind::cell, static_cast<Index>(zone_.cells.size()) - 1});
    }

    template <std::size_t N>
    std::array<Index, N> corners(std::size_t count)
    {
        std::array<Index, N> corners{};
        if (numbers_.size() - at_ < count)
            fail("ends within element " + std::to_string(element_number()));
        for (std::size_t k = 0; k < count; ++k) {
            const cgsize_t vertex = numbers_[at_ + k];
            if (vertex < 1 || vertex > zone_.vertex_count())
                fail("has element " + std::to_string(element_number()) + " at vertex " +
                     std::to_string(vertex) + ", but the zone has " + std::to_string(zone_.vertex_count()));
            corners[k] = static_cast<Index>(vertex - 1);
        }
        at_ += count;
        return corners;
    }

    const CgnsFile& file_;
    CgnsZone& zone_;
    int number_;
    CGNS_ENUMT(ElementType_t) type_;
    cgsize_t first_, last_;
    CgnsSection section_;
    std::size_t count_ = 0;
    std::vector<cgsize_t> numbers_, offsets_;
    std::size_t at_ = 0; ///< in numbers_
};

/// Sections in the order of their elements, which solutions and markers go by.
std::vector<Head> sections_by_number(const CgnsFile& file, const CgnsZone& zone)
{
    int count = 0;
    file.require(cg_nsections(file.number(), zone.base, zone.number, &count), zone.title());
    std::vector<Head> heads;
    for (int s = 1; s <= count; ++s) {
        Head& head = heads.emplace_back();
        head.number = s;
        std::array<char, kCgnsNameRoom> name{};
        int boundary = 0;
        int has_parents = 0;
        file.require(cg_section_read(file.number(), zone.base, zone.number, s, name.data(), &head.type,
                                     &head.first, &head.last, &boundary, &has_parents),
                     "a section of " + zone.title());
        head.name = name.data();
    }
    std::stable_sort(heads.begin(), heads.end(),
                     [](const Head& a, const Head& b) { return a.first < b.first; });
    return heads;
}

} // namespace

void read_cgns_sections(const CgnsFile& file, CgnsZone& zone)
{
    for (const Head& head : sections_by_number(file, zone))
        SectionReader(file, zone, head).read();
    for (std::size_t s = 1; s < zone.sections.size(); ++s) {
        const CgnsSection& before = zone.sections[s - 1];
        if (before.first + static_cast<std::int64_t>(before.items.size()) > zone.sections[s].first)
            file.fail(zone.title() + ", sections " + quoted_text(before.name) + " and " +
                      quoted_text(zone.sections[s].name) + " have numbers of elements in common");
    }
}

} // namespace morph
