#pragma once

#include "libmorph/quality/quality.h"
#include "tools/compare/method.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <string>
#include <vector>

namespace morph::tools {

/// One method's result for one move.
struct ComparisonRow {
    std::string method;
    MovedMesh moved;
    double boundary_error = 0; ///< largest distance of a boundary node to where the curve wants it, over the
                               ///  size of the curve
    double mean_boundary_error = 0; ///< root mean square of the same
    QualityReport quality;
    double energy = 0;        ///< Dirichlet energy of the displacement
    Index worst_element = -1; ///< the one of the smallest scaled Jacobian
};

/// The rows of one move.
struct ComparedMove {
    double factor = 1; ///< of the displacements in the case
    std::vector<ComparisonRow> rows;
};

/// Move the mesh by a method and measure what comes out.
ComparisonRow compare(const Mesh& mesh, const PlacedBoundaries& placed, const CaseFile& file,
                      const CompareMethod& method);

/// One column of the table: what it is called, and a row's entry.
struct ComparisonColumn {
    std::string title;
    std::string meaning;
    std::string (*text)(const ComparisonRow& row);
};
const std::vector<ComparisonColumn>& comparison_columns();

nlohmann::ordered_json comparison_json(const ComparedMove& move);

/// The table as lines of text with aligned columns.
std::vector<std::string> comparison_lines(const ComparedMove& move);

} // namespace morph::tools
