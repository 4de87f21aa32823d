#pragma once

#include "libmorph/core/types.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace morph {

/// A table of numbers with a line of column names above it.
struct CsvTable {
    std::string path;                 ///< for messages
    std::vector<std::string> columns; ///< as in the header line
    Matrix rows;                      ///< one row per line, one column per name
    std::vector<int> lines;           ///< line of each row in the file, from 1
};

/// Read comma-separated numbers: the first line names the columns (quotes are taken off), empty lines
/// and lines that begin with # are skipped.
///
/// @throws InputError  "path:line: …": a row of another length, something that is no finite number, no
/// header,
///                     a name given twice
CsvTable read_csv_table(const std::string& path);

/// As read_csv_table(), from bytes in memory.
CsvTable parse_csv_table(std::string_view bytes, const std::string& path);

/// Number of the column of that name, letter case aside, if there is one.
std::optional<Eigen::Index> find_csv_column(const CsvTable& table, std::string_view name);

/// The named columns side by side.
/// @throws InputError  a name is not in the table; lists those that are
Matrix csv_columns(const CsvTable& table, const std::vector<std::string>& names);

} // namespace morph
