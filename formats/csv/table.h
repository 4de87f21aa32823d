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
    int header_line = 1;              ///< in the file, from 1
    Matrix rows;                      ///< one row per line, one column per name
    std::vector<int> lines;           ///< line of each row in the file, from 1
};

/// Read comma-separated numbers: the first line names the columns; in quotes a name may hold commas.
///
/// Skipped are a byte order mark, empty lines, lines that begin with #, and the notes such as
/// `AOA= 1.25` that SU2 before 7.1 puts behind the rows of a restart file. Numbers may have a leading
/// plus, a Fortran exponent (`1.0D-3`) and quotes around them.
///
/// @throws InputError  "path:line: …": a row of another length, something that is no finite number, a name
///                     given twice, no header
CsvTable read_csv_table(const std::string& path);

/// As read_csv_table(), from bytes in memory.
CsvTable parse_csv_table(std::string_view bytes, const std::string& path);

/// True for names that are the same but for the case of ASCII letters.
bool equals_without_case(std::string_view a, std::string_view b);

/// Number of the column of that name, letter case aside, if there is one.
/// @throws InputError  there are two
std::optional<Eigen::Index> find_csv_column(const CsvTable& table, std::string_view name);

/// The named columns side by side.
/// @throws InputError  a name is not in the table; lists those that are
Matrix csv_columns(const CsvTable& table, const std::vector<std::string>& names);

} // namespace morph
