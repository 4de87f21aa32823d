#pragma once

#include "libmorph/pipeline/comparison.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace morph::tools {

/// The rows of one move.
struct ComparedMove {
    double factor = 1; ///< of the displacements in the case
    std::vector<ComparisonRow> rows;
};

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
