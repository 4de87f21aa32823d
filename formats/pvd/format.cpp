// ParaView's collections: the files of a series in time, in parts or whole.
#include "formats/formats.h"
#include "formats/mesh/merge_parts.h"
#include "formats/text/number_text.h"
#include "formats/text/xml.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>

namespace morph {

namespace {

/// Reads the files of one time step.
class PvdReader {
public:
    explicit PvdReader(const InputBytes& file) : file_(file), document_(read_xml(file, "AppendedData")) {}

    MeshData read()
    {
        list_steps();
        const auto& [time, parts] = *picked_step();
        std::vector<MeshPart> meshes;
        for (const XmlElement* part : parts)
            meshes.push_back({part_name(*part), read_part(*part)});
        const std::string* version = document_.root.attribute("version");
        file_.set_version((version ? *version : "no version") + ", time " + exact_text(time));
        if (meshes.size() == 1)
            return std::move(meshes[0].mesh);
        file_.warn("the " + std::to_string(meshes.size()) +
                   " parts of a time step were joined; vertices that they share stay double");
        return merge_parts(std::move(meshes), file_);
    }

private:
    using Steps = std::map<double, std::vector<const XmlElement*>>;

    [[noreturn]] void fail(const XmlElement& element, const std::string& what) const
    {
        throw xml_error(file_, element.offset, what);
    }

    void list_steps()
    {
        const XmlElement& root = document_.root;
        const std::string* type = root.attribute("type");
        const XmlElement* collection = root.child("Collection");
        if (root.name != "VTKFile" || !type || *type != "Collection" || !collection)
            fail(root, "expected <VTKFile type=\"Collection\"> with a <Collection>, found <" + root.name +
                           (type ? " type=\"" + *type + "\"" : "") + ">");
        for (const XmlElement& element : collection->children)
            if (element.name == "DataSet")
                steps_[time_of(element)].push_back(&element);
        if (steps_.empty())
            fail(*collection, "the collection has no <DataSet>");
    }

    double time_of(const XmlElement& element) const
    {
        const std::string* text = element.attribute("timestep");
        double time = 0;
        if (!text || text->empty())
            return time;
        const auto [stop, error] = std::from_chars(text->data(), text->data() + text->size(), time);
        if (error != std::errc() || stop != text->data() + text->size() || !std::isfinite(time))
            fail(element, "timestep is '" + *text + "', expected a number");
        return time;
    }

    /// The last, or what `zone` asks for.
    Steps::const_iterator picked_step() const
    {
        std::vector<std::string> times;
        for (const auto& [time, parts] : steps_)
            times.push_back(exact_text(time));
        const std::size_t picked = picked_part(times, "time step", file_);
        if (picked < times.size())
            return std::next(steps_.begin(), static_cast<std::ptrdiff_t>(picked));
        if (times.size() > 1)
            file_.warn("of its " + std::to_string(times.size()) + " time steps the last was read, " +
                       times.back());
        return std::prev(steps_.end());
    }

    const std::string& file_of(const XmlElement& part) const
    {
        const std::string* name = part.attribute("file");
        if (!name || name->empty())
            fail(part, "<DataSet> has no file");
        return *name;
    }

    /// As ParaView shows it: its name, else the number of the part.
    std::string part_name(const XmlElement& part) const
    {
        for (const char* attribute : {"name", "group"})
            if (const std::string* name = part.attribute(attribute); name && !name->empty())
                return *name;
        const std::string* number = part.attribute("part");
        return "part " + (number ? *number : file_of(part));
    }

    MeshData read_part(const XmlElement& part) const
    {
        const std::filesystem::path name = file_of(part);
        const std::string extension = name.extension().string();
        if (extension != ".vtu" && extension != ".vtp" && extension != ".vtk")
            fail(part, "the file '" + name.string() + "' is no .vtu, .vtp or .vtk, which alone are read");
        const std::string path = (std::filesystem::path(file_.path).parent_path() / name).string();
        try {
            return read_mesh_data(path, "", {.surface = file_.options.surface, .zone = ""}, file_.notes);
        } catch (const InputError& error) {
            fail(part, error.what());
        }
    }

    const InputBytes& file_;
    XmlDocument document_;
    Steps steps_; ///< by time
};

} // namespace

extern const Format pvd_format;
const Format pvd_format{"pvd",
                        {".pvd"},
                        "ParaView collection of .vtu, .vtp or .vtk files",
                        {.surface = true,
                         .markers = true,
                         .groups = true,
                         .vertex_fields = true,
                         .element_fields = true,
                         .ascii = false,
                         .volume = true},
                        [](const InputBytes& file) { return PvdReader(file).read(); },
                        nullptr};

} // namespace morph
