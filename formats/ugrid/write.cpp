#include "formats/ugrid/write.h"

#include "formats/mesh/element_groups.h"
#include "formats/text/number_text.h"
#include "formats/text/numbered_names.h"
#include "formats/text/surface_text.h"
#include "formats/ugrid/counts.h"
#include "formats/ugrid/layout.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <filesystem>

namespace morph {

namespace {

/// Writes rows of numbers as text or in a binary layout.
class UgridSink {
public:
    UgridSink(OutputFile& out, const UgridLayout& layout) : out_(out), layout_(layout) {}

    void integers(const std::int64_t* numbers, std::size_t count)
    {
        char* to = out_.room(count * kLongestNumber);
        for (std::size_t i = 0; i < count; ++i)
            if (!layout_.binary)
                to = number_text(to, numbers[i], i + 1 == count ? '\n' : ' ');
            else if (layout_.number_size == 8)
                to = raw(to, numbers[i]);
            else
                to = raw(to, static_cast<std::int32_t>(numbers[i]));
        out_.advance_to(to);
    }

    void reals(const double* numbers, std::size_t count)
    {
        char* to = out_.room(count * kLongestNumber);
        for (std::size_t i = 0; i < count; ++i)
            if (!layout_.binary)
                to = number_text(to, numbers[i], i + 1 == count ? '\n' : ' ');
            else if (layout_.real_size == 8)
                to = raw(to, numbers[i]);
            else
                to = raw(to, static_cast<float>(numbers[i]));
        out_.advance_to(to);
    }

    /// The length that Fortran puts before and behind a record.
    void record_length(std::uint64_t bytes)
    {
        if (!layout_.records)
            return;
        if (bytes > INT32_MAX)
            throw InputError(out_.path() +
                             ": a record of Fortran holds at most 2^31 - 1 bytes, but this mesh takes " +
                             std::to_string(bytes) + "; write it as .b8.ugrid or .lb8.ugrid");
        out_.advance_to(raw(out_.room(4), static_cast<std::int32_t>(bytes)));
    }

private:
    char* raw(char* to, auto number) const
    {
        std::memcpy(to, &number, sizeof number);
        if (layout_.little_endian != (std::endian::native == std::endian::little))
            std::reverse(to, to + sizeof number);
        return to + sizeof number;
    }

    OutputFile& out_;
    UgridLayout layout_;
};

UgridCounts counts_of(const MeshData& mesh)
{
    const auto triangles = std::count_if(mesh.elements.begin(), mesh.elements.end(),
                                         [](const Element& element) { return corner_count(element) == 3; });
    return {mesh.points.rows(),
            triangles,
            static_cast<std::int64_t>(mesh.elements.size()) - triangles,
            0,
            0,
            0,
            0};
}

void write_faces(const MeshData& mesh, int corners, UgridSink& sink)
{
    std::array<std::int64_t, 4> line{};
    for (const Element& element : mesh.elements) {
        if (corner_count(element) != corners)
            continue;
        for (std::size_t k = 0; k < static_cast<std::size_t>(corners); ++k)
            line.at(k) = element.at(k) + std::int64_t{1};
        sink.integers(line.data(), static_cast<std::size_t>(corners));
    }
}

void write_references(const MeshData& mesh, const std::vector<std::int32_t>& references, int corners,
                      UgridSink& sink)
{
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        if (const std::int64_t reference = references[e]; corner_count(mesh.elements[e]) == corners)
            sink.integers(&reference, 1);
}

UgridLayout layout_for(const std::string& path, bool binary)
{
    const UgridLayout named = ugrid_layout_of_name(path);
    if (named.binary || !binary || std::filesystem::path(path).extension() == ".ugrid")
        return named;
    return ugrid_layout_of_name("x.lb8.ugrid");
}

} // namespace

void write_ugrid(const MeshData& mesh, const WriteOptions& options, OutputFile& out)
{
    const UgridLayout layout = layout_for(out.path(), options.binary);
    UgridSink sink(out, layout);
    const UgridCounts counts = counts_of(mesh);
    const std::uint64_t head = counts.size() * layout.number_size;
    const std::uint64_t body = static_cast<std::uint64_t>(mesh.points.size()) * layout.real_size +
                               ugrid_whole_numbers(counts) * layout.number_size;
    sink.record_length(head);
    sink.integers(counts.data(), counts.size());
    sink.record_length(head);
    sink.record_length(body);
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
        sink.reals(mesh.points.data() + 3 * v, 3);
    const std::vector<std::int32_t> references = group_references(mesh).elements;
    for (const int corners : {3, 4})
        write_faces(mesh, corners, sink);
    for (const int corners : {3, 4})
        write_references(mesh, references, corners, sink);
    sink.record_length(body);
}

std::vector<std::string> ugrid_losses(const MeshData& mesh, const WriteOptions&)
{
    std::vector<std::string> lost = overlap_losses(mesh);
    for (const ElementGroup& group : mesh.groups)
        if (group.name.empty())
            lost.emplace_back("a group without a name, which is read back by its number");
    return lost;
}

} // namespace morph
