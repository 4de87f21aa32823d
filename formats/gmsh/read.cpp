#include "formats/gmsh/read.h"

#include "formats/gmsh/elements.h"
#include "formats/gmsh/fields.h"
#include "formats/text/surface_text.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <cmath>

namespace morph {

namespace {

// The least that a node takes, "1 0 0 0\n", and a block of them, "1 1 0 0\n".
constexpr std::size_t kNodeText = 8;
constexpr std::size_t kNodeBytes = 28;
constexpr std::size_t kBlockText = 8;
constexpr std::size_t kBlockBytes = 16;

class GmshReader {
public:
    explicit GmshReader(const InputBytes& file)
        : file_(file), in_(file), groups_(in_, names_, volume_.mesh), elements_(in_, nodes_, groups_, volume_)
    {
    }

    MeshData read()
    {
        file_.set_version(in_.version_text());
        warn_of_others();
        for_each("Comments", [&](const GmshSection& section) { names_.read(in_.text(), section.end); });
        for_each("PhysicalNames", [&](const GmshSection&) { groups_.read_names(); });
        for_each("Entities", [&](const GmshSection&) { groups_.read_entities(false); });
        for_each("PartitionedEntities", [&](const GmshSection&) { groups_.read_entities(true); });
        groups_.begin();
        for_each("Nodes", [&](const GmshSection&) { read_nodes(false); });
        for_each("ParametricNodes", [&](const GmshSection&) { read_nodes(true); });
        require_distinct_nodes();
        for_each("Elements", [&](const GmshSection&) { elements_.read(); });
        if (elements_.left_out() > 0)
            file_.warn(std::to_string(elements_.left_out()) +
                       " line(s) or face(s) between partitions were left out");
        read_fields();
        volume_.mesh.dimension = dimension_of(volume_.mesh.points);
        return surface_of(std::move(volume_), file_);
    }

private:
    template <class Use>
    void for_each(std::string_view name, const Use& use)
    {
        for (const GmshSection& section : in_.sections())
            if (section.name == name) {
                in_.enter(section);
                use(section);
            }
    }

    void warn_of_others() const
    {
        constexpr std::array<std::string_view, 8> read{
            "Comments", "PhysicalNames",   "Entities", "PartitionedEntities",
            "Nodes",    "ParametricNodes", "Elements", "NodeData"};
        std::vector<std::string> others;
        for (const GmshSection& section : in_.sections())
            if (std::find(read.begin(), read.end(), section.name) == read.end() &&
                section.name != "ElementData" &&
                std::find(others.begin(), others.end(), section.name) == others.end())
                others.push_back(section.name);
        for (const std::string& name : others)
            file_.warn("section $" + name + " was passed over");
    }

    Points& points() { return volume_.mesh.points; }

    void read_nodes(bool parametric)
    {
        const bool version_2 = in_.is_version_2();
        const Index first = in_.first_count("the number of nodes", version_2 ? kNodeText : kBlockText,
                                            version_2 ? kNodeBytes : kBlockBytes);
        if (version_2) {
            make_room(first);
            for (Index i = 0; i < first; ++i)
                read_node(parametric);
        } else {
            read_blocks(first);
        }
        in_.leave();
    }

    void make_room(Index count)
    {
        next_ = static_cast<Index>(points().rows());
        points().conservativeResize(points().rows() + count, Eigen::NoChange);
    }

    /// A node of version 2, where parameters follow the dimension and tag of the entity.
    void read_node(bool parametric)
    {
        nodes_.add(in_.tag("the number of a node"));
        read_point();
        if (!parametric)
            return;
        const std::int64_t dimension = in_.integer("the dimension of an entity");
        in_.integer("the tag of an entity");
        for (int k = 0; k < dimension && dimension < 3; ++k)
            in_.real("a parameter of a node");
    }

    void read_point()
    {
        for (int k = 0; k < 3; ++k) {
            const std::size_t position = in_.position();
            const double x = in_.real("a coordinate of a node");
            if (!std::isfinite(x))
                in_.fail_at(position, "a coordinate of a node is not finite");
            points()(next_, k) = x;
        }
        ++next_;
    }

    void read_blocks(Index blocks)
    {
        const Index total = in_.count("the number of nodes", kNodeText, kNodeBytes);
        make_room(total);
        if (!in_.is_version_4_0()) {
            in_.size("the smallest tag of a node");
            in_.size("the largest tag of a node");
        }
        for (Index b = 0; b < blocks; ++b)
            read_block();
        if (next_ != points().rows())
            in_.fail_at(in_.position(), "the blocks have " + std::to_string(points().rows() - next_) +
                                            " nodes less than the " + std::to_string(total) + " of $Nodes");
    }

    void read_block()
    {
        std::int64_t dimension = in_.integer("the dimension of an entity");
        const std::int64_t entity = in_.integer("the tag of an entity");
        if (in_.is_version_4_0())
            dimension = entity;
        const bool parametric = in_.integer("0, or 1 for parametric nodes") != 0;
        const std::size_t position = in_.position();
        const Index count = in_.count("the number of nodes of a block", kNodeText, kNodeBytes);
        if (count > points().rows() - next_)
            in_.fail_at(position, "the blocks have more nodes than $Nodes says");
        const std::int64_t parameters = parametric ? std::clamp<std::int64_t>(dimension, 0, 3) : 0;
        if (!in_.is_version_4_0())
            for (Index i = 0; i < count; ++i)
                nodes_.add(in_.tag("the tag of a node"));
        for (Index i = 0; i < count; ++i) {
            if (in_.is_version_4_0())
                nodes_.add(in_.tag("the tag of a node"));
            read_point();
            for (std::int64_t k = 0; k < parameters; ++k)
                in_.real("a parameter of a node");
        }
    }

    void require_distinct_nodes()
    {
        if (const auto twice = nodes_.sort())
            throw InputError(file_.path + ": node " + std::to_string(*twice) + " is there more than once");
    }

    void read_fields()
    {
        const auto is_data = [](const GmshSection& section) {
            return section.name == "NodeData" || section.name == "ElementData";
        };
        if (std::none_of(in_.sections().begin(), in_.sections().end(), is_data))
            return;
        if (const auto twice = elements_.tags().sort())
            file_.warn("element " + std::to_string(*twice) +
                       " is there more than once; data go to the first");
        GmshFields fields(in_, file_, names_, nodes_, elements_.tags(), volume_.mesh);
        for (const GmshSection& section : in_.sections())
            if (is_data(section)) {
                in_.enter(section);
                fields.read(section.name == "NodeData" ? FieldLocation::vertex : FieldLocation::element);
            }
        fields.finish();
    }

    const InputBytes& file_;
    GmshScanner in_;
    GmshNames names_;
    VolumeFile volume_;
    GmshTags nodes_;
    GmshGroups groups_;
    GmshElements elements_;
    Index next_ = 0; ///< vertex to be read
};

} // namespace

MeshData read_gmsh(const InputBytes& file)
{
    return GmshReader(file).read();
}

} // namespace morph
