#pragma once

#include "formats/format.h"
#include "libmorph/mesh/mesh_data.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace morph::tools {

/// What a mesh file holds: format and version, counts by type, bounding box, markers and groups with sizes,
/// fields with ranges, what other sections it has.
nlohmann::ordered_json file_info(const std::string& path, const Format& format, const MeshData& mesh,
                                 const ReadNotes& notes);

/// The same in lines for a person.
std::vector<std::string> info_lines(const nlohmann::ordered_json& info);

/// Every format with what it can hold, for --list: in two lines each, and as JSON.
std::vector<std::string> format_list();
nlohmann::ordered_json format_table();

} // namespace morph::tools
