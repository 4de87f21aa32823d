#include "formats/cgns/file.h"

#include "formats/text/number_text.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <cgns_io.h>
#include <cgnslib.h>

namespace morph {

namespace {

/// The words of libcgns on one line.
std::string error_text(const std::string& opened, const std::string& path)
{
    std::string text = cg_get_error();
    if (const std::size_t at = text.find(opened); at != std::string::npos)
        text.replace(at, opened.size(), path);
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 32 || c > 126; }, ' ');
    return text.substr(0, 200);
}

/// "3.4", which is not a number of the computer.
std::string version_text(float version)
{
    return exact_text(std::round(100.0 * double{version}) / 100);
}

} // namespace

CgnsFile::CgnsFile(const InputBytes& input, const std::string& path) : input_(input), path_(path)
{
    int type = CG_FILE_NONE;
    if (cgio_check_file(path.c_str(), &type) != CGIO_ERR_NONE || type == CG_FILE_NONE)
        fail("not a CGNS file, which begins as one of HDF5 or ADF does");
    accept_newer_version(type);
    require(cg_open(path.c_str(), CG_MODE_READ, &number_), "the file");
    read_version(type);
}

// Version 3.4 of the library refuses files of 4.0 and later for their number alone: what they added does
// not touch what is read here. The copy is declared to be of version 3.4.
void CgnsFile::accept_newer_version(int type) const
{
    int file = 0;
    double root = 0;
    double node = 0;
    float version = 0;
    if (cgio_open_file(path_.c_str(), CGIO_MODE_MODIFY, type, &file) != CGIO_ERR_NONE)
        return; // cg_open() will say why
    if (cgio_get_root_id(file, &root) == CGIO_ERR_NONE &&
        cgio_get_node_id(file, root, "CGNSLibraryVersion", &node) == CGIO_ERR_NONE &&
        cgio_read_all_data(file, node, &version) == CGIO_ERR_NONE && version >= 4 && version < 5) {
        input_.set_version(version_text(version));
        version = static_cast<float>(CGNS_DOTVERS);
        cgio_write_all_data(file, node, &version);
    }
    cgio_close_file(file);
}

void CgnsFile::read_version(int type) const
{
    if (!input_.notes)
        return;
    float version = 0;
    if (input_.notes->version.empty() && cg_version(number_, &version) == CG_OK)
        input_.set_version(version_text(version));
    input_.set_version(input_.notes->version + (type == CG_FILE_HDF5 ? ", HDF5" : ", ADF"));
}

void CgnsFile::fail(const std::string& what) const
{
    throw InputError(input_.path + ": " + what);
}

void CgnsFile::require(int status, const std::string& what) const
{
    if (status != CG_OK)
        fail(what + " cannot be read: " + error_text(path_, input_.path));
}

// Small files may be compressed a lot: what memory holds anyway is not refused.
void CgnsFile::require_plausible(std::int64_t count, const std::string& of, const std::string& what) const
{
    constexpr std::size_t always = std::size_t{1} << 22;
    if (count > std::numeric_limits<Index>::max() ||
        static_cast<std::size_t>(count) > always + input_.bytes.size())
        fail(of + " has " + std::to_string(count) + " " + what + ", more than a file of " +
             std::to_string(input_.bytes.size()) + " bytes can hold");
}

std::string CgnsFile::descriptor(const std::string& name)
{
    int count = 0;
    if (cg_ndescriptors(&count) != CG_OK)
        return {};
    for (int d = 1; d <= count; ++d) {
        std::array<char, kCgnsNameRoom> found{};
        char* text = nullptr;
        if (cg_descriptor_read(d, found.data(), &text) != CG_OK)
            continue;
        std::string copy(text);
        cg_free(text);
        if (name == found.data())
            return copy;
    }
    return {};
}

} // namespace morph
