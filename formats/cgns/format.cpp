// CGNS files (.cgns) of HDF5 or ADF, read and written with libcgns. Of damaged files it and HDF5 crash, end
// the process or allocate what a broken count says. They are therefore called in a child process, which
// leaves the mesh in memory; what becomes of the child is an error of one line. The parent never calls
// libcgns, so that nothing of it (open files, handlers of errors and exits) stays and threads do not meet in
// it. Both work on paths instead of bytes, and HDF5 resolves links in them, so that a file in memory, which
// has but a link below /proc, will not do.
#include "formats/binary/mesh_bytes.h"
#include "formats/cgns/reader.h"
#include "formats/cgns/writer.h"
#include "formats/input_file.h"
#include "formats/process/child_process.h"
#include "formats/process/scratch_folder.h"
#include "formats/text/message_text.h"

namespace morph {

namespace {

/// A file may be compressed and hold a grid without any elements, hence the factor.
ChildLimits limits_for(std::size_t bytes)
{
    return {(std::size_t{128} << 20) + 32 * bytes, static_cast<unsigned>(1 + bytes / 10'000'000)};
}

MeshData read(const InputBytes& input)
{
    const ScratchFolder folder;
    const std::string copy = folder.write("copy.cgns", input.bytes);
    MemoryFile answer;
    run_in_child(input.path, limits_for(input.bytes.size()), [&] {
        ReadNotes notes;
        const InputBytes noted{input.path, input.bytes, input.options, &notes};
        const VolumeFile volume = read_cgns(noted, copy);
        append_mesh(answer, volume, notes);
    });
    ReadNotes notes;
    VolumeFile volume = mesh_from_bytes(answer.bytes(), input.path, notes);
    if (input.notes) {
        input.set_version(notes.version);
        input.notes->warnings.insert(input.notes->warnings.end(), notes.warnings.begin(),
                                     notes.warnings.end());
    }
    return surface_of(std::move(volume), input);
}

/// Of what is written, about.
std::size_t size_of(const MeshData& mesh)
{
    std::size_t numbers = static_cast<std::size_t>(mesh.points.size()) + 3 * mesh.elements.size();
    for (const Marker& marker : mesh.markers)
        numbers += 2 * marker.edges.size();
    for (const ElementGroup& group : mesh.groups)
        numbers += group.elements.size();
    for (const Field& field : mesh.fields)
        numbers += static_cast<std::size_t>(field.values.size());
    return numbers * sizeof(double);
}

void write(const MeshData& mesh, const WriteOptions&, OutputFile& file)
{
    const ScratchFolder folder;
    const std::string path = folder.file("written.cgns");
    run_in_child(file.path(), limits_for(size_of(mesh)), [&] { write_cgns(mesh, path); });
    file.append(InputFile(path).bytes());
}

std::vector<std::string> losses(const MeshData& mesh, const WriteOptions&)
{
    std::vector<std::string> lost;
    for (const ElementGroup& group : mesh.groups)
        if (group.elements.empty())
            lost.push_back("group " + quoted_text(group.name) + ", which is empty");
    if (mesh.points.rows() == 0)
        for (const Marker& marker : mesh.markers)
            lost.push_back("marker " + quoted_text(marker.name) + " without vertices");
    return lost;
}

} // namespace

extern const Format cgns_format;
const Format cgns_format{"cgns",
                         {".cgns"},
                         "CFD General Notation System (HDF5; ADF is read)",
                         {.surface = true,
                          .markers = true,
                          .groups = true,
                          .vertex_fields = true,
                          .element_fields = true,
                          .ascii = false,
                          .binary = true,
                          .volume = true},
                         read,
                         write,
                         losses};

} // namespace morph
