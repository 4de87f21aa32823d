#pragma once

#include "tools/compare/table.h"

#include <string>
#include <vector>

namespace morph::tools {

/// What the page is about.
struct PageSubject {
    std::string case_file;
    std::string mesh;
};

/// A page of HTML that needs no other file: the table of each move, and for each method a picture of the
/// bodies and one of its worst element from near.
///
/// @param mesh  undeformed; its positions are changed while pictures are drawn and are as before at the end
std::string comparison_page(const PageSubject& subject, Mesh& mesh, const std::vector<ComparedMove>& moves);

} // namespace morph::tools
