#include "formats/medit/read.h"

#include "formats/medit/keywords.h"
#include "formats/medit/opaque_sections.h"
#include "formats/medit/solutions.h"
#include "formats/medit/source.h"
#include "formats/text/element_order.h"
#include "formats/text/message_text.h"
#include "formats/text/numbered_names.h"
#include "formats/text/surface_text.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <cmath>

namespace morph {

namespace {

class MeditReader {
public:
    explicit MeditReader(const InputBytes& file) : file_(file), in_(open_medit(file)) {}

    MeshData read()
    {
        while (in_->next())
            read_section();
        if (!has_vertices_)
            throw InputError(file_.path + ": has no section Vertices");
        require_vertices();
        file_.set_version(std::to_string(in_->version()) +
                          (file_.bytes.front() < ' ' ? ", binary" : ", text"));
        finish();
        return surface_of(std::move(volume_), file_);
    }

private:
    void read_section()
    {
        const std::string& section = in_->section();
        const auto& lists = medit_lists();
        const auto list = std::find_if(lists.begin(), lists.end(),
                                       [&](const MeditList& known) { return known.keyword == section; });
        if (section == "Vertices")
            read_vertices();
        else if (const MeditShape* const shape = find_medit_shape(section))
            read_shapes(*shape);
        else if (list != lists.end())
            read_list(*list);
        else if (is_unsupported_medit_shape(section))
            in_->fail_at(in_->section_position(),
                         section + " are not supported; supported are straight triangles, quadrilaterals, "
                                   "tetrahedra, pyramids, prisms and hexahedra");
        else
            file_.warn("the section " + quoted_text(section) + " was left out");
    }

    void read_vertices()
    {
        if (has_vertices_)
            in_->fail_at(in_->section_position(), "Vertices are given again");
        has_vertices_ = true;
        const auto dimension = static_cast<std::size_t>(in_->dimension());
        const std::size_t count = in_->count();
        in_->require_room(count, 1, dimension);
        if (count > INT32_MAX)
            in_->fail_at(in_->section_position(), "more vertices than " + std::to_string(INT32_MAX));
        Points& points = volume_.mesh.points;
        points.resize(static_cast<Eigen::Index>(count), 3);
        vertex_references_.resize(count);
        for (std::size_t v = 0; v < count; ++v) {
            double* const row = points.data() + 3 * v;
            row[2] = 0;
            for (std::size_t k = 0; k < dimension; ++k)
                read_coordinate(row[k], v);
            if (!in_->try_integer(vertex_references_[v]))
                in_->fail_expected("the reference of vertex " + std::to_string(v + 1));
        }
        volume_.mesh.dimension = dimension_of(points);
    }

    void read_coordinate(double& value, std::size_t vertex)
    {
        const std::size_t position = in_->position();
        if (!in_->try_real(value))
            in_->fail_expected("a coordinate of vertex " + std::to_string(vertex + 1));
        if (!std::isfinite(value))
            in_->fail_at(position, "a coordinate of vertex " + std::to_string(vertex + 1) + " is not finite");
    }

    void read_shapes(const MeditShape& shape)
    {
        const std::size_t count = in_->count();
        in_->require_room(count, shape.corners + 1, 0);
        reserve(shape, count);
        std::array<Index, 8> corners{};
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < shape.corners; ++k)
                corners[k] = read_corner(shape, i);
            std::int64_t reference = 0;
            if (!in_->try_integer(reference))
                in_->fail_expected("the reference of " + name_of(shape, i));
            add(shape, corners, reference);
        }
    }

    static std::string name_of(const MeditShape& shape, std::size_t i)
    {
        return std::string(shape.singular) + " " + std::to_string(i + 1);
    }

    Index read_corner(const MeditShape& shape, std::size_t i)
    {
        const std::size_t position = in_->position();
        std::int64_t number = 0;
        if (!in_->try_integer(number))
            in_->fail_expected("a vertex of " + name_of(shape, i));
        if (number < 1 || number > INT32_MAX)
            in_->fail_at(position, name_of(shape, i) + " names vertex " + std::to_string(number) +
                                       ", but vertices are numbered from 1");
        if (number > largest_) {
            largest_ = number;
            largest_position_ = position;
            largest_owner_ = {&shape, i};
        }
        return static_cast<Index>(number - 1);
    }

    /// The vertices may stand behind the elements, so that this waits until all is read.
    void require_vertices() const
    {
        if (largest_ > volume_.mesh.points.rows())
            in_->fail_at(largest_position_, name_of(*largest_owner_.first, largest_owner_.second) +
                                                " names vertex " + std::to_string(largest_) +
                                                ", but the mesh has " +
                                                std::to_string(volume_.mesh.points.rows()));
    }

    void reserve(const MeditShape& shape, std::size_t count)
    {
        if (shape.corners == 2) {
            edges_.reserve(edges_.size() + count);
            edge_references_.reserve(edges_.size() + count);
        } else if (!shape.volume) {
            std::vector<Element>& faces = faces_.at(shape.corners - 3);
            faces.reserve(faces.size() + count);
            face_references_.at(shape.corners - 3).reserve(faces.size() + count);
        }
    }

    void add(const MeditShape& shape, const std::array<Index, 8>& corners, std::int64_t reference)
    {
        if (shape.volume) {
            volume_.cells.push_back({*shape.volume, corners});
        } else if (shape.corners == 2) {
            edges_.push_back({corners[0], corners[1]});
            edge_references_.push_back(reference);
        } else {
            faces_.at(shape.corners - 3)
                .push_back({corners[0], corners[1], corners[2], shape.corners == 4 ? corners[3] : -1});
            face_references_.at(shape.corners - 3).push_back(reference);
        }
    }

    void read_list(const MeditList& list)
    {
        const std::size_t count = in_->count();
        in_->require_room(count, 1, 0);
        MeditNumbers& read = lists_.emplace_back(MeditNumbers{list, {}, in_->section_position()});
        read.numbers.resize(count);
        for (std::int64_t& number : read.numbers)
            if (!in_->try_integer(number))
                in_->fail_expected("a number of " + in_->section());
    }

    void finish()
    {
        MeshData& mesh = volume_.mesh;
        const std::vector<std::int64_t> references =
            join_faces(faces_, face_references_, in_->comments(), mesh.elements);
        const std::vector<NumberedName> names = read_names(in_->comments());
        mesh.groups = groups_from(references, names);
        mesh.markers = markers_from(edges_, edge_references_, names);
        read_medit_solutions_beside(file_, mesh);
        const bool marked = std::any_of(vertex_references_.begin(), vertex_references_.end(),
                                        [](std::int64_t reference) { return reference != 0; });
        if (marked)
            mesh.sections.push_back(vertex_reference_section(vertex_references_));
        for (const MeditNumbers& list : lists_)
            carry(list);
        if (!volume_.cells.empty())
            drop_carried();
    }

    void carry(const MeditNumbers& list)
    {
        MeshData& mesh = volume_.mesh;
        const std::size_t count = listed_medit_things(list.list.listed, edges_, mesh);
        for (const std::int64_t number : list.numbers)
            if (number < 1 || number > static_cast<std::int64_t>(count))
                in_->fail_at(list.position, std::string(list.list.keyword) + " lists number " +
                                                std::to_string(number) + ", but the mesh has " +
                                                std::to_string(count) + " of these");
        if (!list.numbers.empty())
            mesh.sections.push_back(list_section(list, edges_, mesh));
    }

    /// The boundary of a volume has other vertices and faces than the file.
    void drop_carried()
    {
        for (const OpaqueSection& carried : volume_.mesh.sections)
            file_.warn(carried.what + " of the volume mesh were left out");
        volume_.mesh.sections.clear();
    }

    const InputBytes& file_;
    std::unique_ptr<MeditSource> in_;
    VolumeFile volume_;
    bool has_vertices_ = false;
    std::vector<std::int64_t> vertex_references_;
    std::vector<std::array<Index, 2>> edges_;
    std::vector<std::int64_t> edge_references_;
    std::array<std::vector<Element>, 2> faces_; ///< triangles, quads
    std::array<std::vector<std::int64_t>, 2> face_references_;
    std::vector<MeditNumbers> lists_;
    std::int64_t largest_ = 0; ///< vertex that a line names, from 1
    std::size_t largest_position_ = 0;
    std::pair<const MeditShape*, std::size_t> largest_owner_{};
};

} // namespace

MeshData read_medit(const InputBytes& file)
{
    return MeditReader(file).read();
}

} // namespace morph
