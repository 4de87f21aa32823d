#include "formats/csv/table.h"

#include "formats/input_file.h"
#include "formats/text/text_scanner.h"
#include "libmorph/core/error.h"
#include "libmorph/core/names.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace morph {

namespace {

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kBlank = " \t\r\"";
    const auto first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::vector<std::string_view> cells_of(std::string_view line)
{
    std::vector<std::string_view> cells;
    for (;;) {
        const auto comma = line.find(',');
        cells.push_back(trimmed(line.substr(0, comma)));
        if (comma == std::string_view::npos)
            return cells;
        line.remove_prefix(comma + 1);
    }
}

std::string_view without_outer_blanks(std::string_view text)
{
    constexpr std::string_view kBlank = " \t\r";
    const auto first = text.find_first_not_of(kBlank);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// The cell without the quotes around it; quotes within are written twice.
std::string unquoted(std::string_view cell)
{
    cell = without_outer_blanks(cell);
    if (cell.size() < 2 || cell.front() != '"' || cell.back() != '"')
        return std::string(cell);
    cell = cell.substr(1, cell.size() - 2);
    std::string name;
    for (std::size_t i = 0; i < cell.size(); i += cell.substr(i, 2) == "\"\"" ? 2 : 1)
        name += cell[i];
    return name;
}

/// The names in a header line; in quotes they may hold commas.
std::vector<std::string> header_cells(std::string_view line)
{
    std::vector<std::string> names;
    bool quoted = false;
    std::size_t first = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        quoted = quoted != (line[i] == '"');
        if (line[i] == ',' && !quoted) {
            names.push_back(unquoted(line.substr(first, i - first)));
            first = i + 1;
        }
    }
    names.push_back(unquoted(line.substr(first)));
    return names;
}

/// For a message: on one line, and cut when long.
std::string printable(std::string_view text)
{
    constexpr std::size_t kLongest = 40;
    std::string plain(text.substr(0, kLongest));
    std::replace_if(
        plain.begin(), plain.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; }, '?');
    return plain;
}

const char* skip_blanks(const char* here, const char* end)
{
    while (here != end && (*here == ' ' || *here == '\t' || *here == '\r'))
        ++here;
    return here;
}

/// Takes the lines of a table one by one.
class CsvParser {
public:
    explicit CsvParser(const std::string& path) { table_.path = path; }

    void take(std::string_view line, int number)
    {
        const std::string_view content = trimmed(line);
        if (content.empty() || content.front() == '#')
            return;
        if (table_.columns.empty())
            return take_header(line, number);
        if (!take_plain_row(line)) {
            if (is_note(content))
                return;
            take_row(line, number);
        }
        table_.lines.push_back(number);
    }

    CsvTable finish()
    {
        if (table_.columns.empty())
            throw InputError(table_.path + ": is empty, but a line of column names was expected");
        const auto columns = static_cast<Eigen::Index>(table_.columns.size());
        table_.rows =
            Eigen::Map<const Matrix>(values_.data(), static_cast<Eigen::Index>(table_.lines.size()), columns);
        return std::move(table_);
    }

private:
    void take_header(std::string_view line, int number)
    {
        table_.header_line = number;
        for (const std::string& name : header_cells(line)) {
            if (std::find(table_.columns.begin(), table_.columns.end(), name) != table_.columns.end())
                fail(number, "names the column '" + printable(name) + "' twice");
            table_.columns.push_back(name);
        }
    }

    /// The fast way through a row of plain finite numbers; false, and nothing is taken, for any other row.
    bool take_plain_row(std::string_view line)
    {
        const std::size_t before = values_.size();
        const char* here = line.data();
        const char* const end = line.data() + line.size();
        for (std::size_t c = 0; c < table_.columns.size(); ++c) {
            double value = 0;
            const auto [after, error] = std::from_chars(skip_blanks(here, end), end, value);
            here = skip_blanks(after, end);
            const bool last = c + 1 == table_.columns.size();
            if (error != std::errc() || !std::isfinite(value) ||
                (last ? here != end : here == end || *here++ != ',')) {
                values_.resize(before);
                return false;
            }
            values_.push_back(value);
        }
        return true;
    }

    /// "AOA= 1.25" and the like, which SU2 before 7.1 puts at the end of a restart file.
    bool is_note(std::string_view content) const
    {
        return content.find('=') != std::string_view::npos && content.find(',') == std::string_view::npos &&
               table_.columns.front() == "PointID";
    }

    void take_row(std::string_view line, int number)
    {
        const auto cells = cells_of(line);
        if (cells.size() != table_.columns.size())
            fail(number, "has " + std::to_string(cells.size()) + " values, but the header names " +
                             std::to_string(table_.columns.size()) + " columns");
        for (std::size_t c = 0; c < cells.size(); ++c)
            values_.push_back(number_of(cells[c], c, number));
    }

    double number_of(std::string_view cell, std::size_t column, int line) const
    {
        TextScanner in(table_.path, cell);
        double value = 0;
        if (!in.try_real(value) || !in.at_line_end())
            fail(line, "column '" + printable(table_.columns[column]) + "' is '" + printable(cell) +
                           "', but a finite number was expected");
        return value;
    }

    [[noreturn]] void fail(int line, const std::string& what) const
    {
        throw InputError(table_.path + ":" + std::to_string(line) + ": " + what);
    }

    CsvTable table_;
    std::vector<double> values_;
};

} // namespace

bool equals_without_case(std::string_view a, std::string_view b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char one, unsigned char other) {
        return std::tolower(one) == std::tolower(other);
    });
}

CsvTable parse_csv_table(std::string_view bytes, const std::string& path)
{
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF"; // spreadsheets begin UTF-8 with it
    if (bytes.starts_with(kByteOrderMark))
        bytes.remove_prefix(kByteOrderMark.size());
    CsvParser parser(path);
    for (int number = 1; !bytes.empty(); ++number) {
        const auto end = std::min(bytes.find('\n'), bytes.size() - 1);
        const bool ended = bytes[end] == '\n';
        parser.take(bytes.substr(0, ended ? end : end + 1), number);
        bytes.remove_prefix(end + 1);
    }
    return parser.finish();
}

CsvTable read_csv_table(const std::string& path)
{
    const InputFile file(path);
    return parse_csv_table(file.bytes(), path);
}

std::optional<Eigen::Index> find_csv_column(const CsvTable& table, std::string_view name)
{
    std::optional<Eigen::Index> found;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        if (!equals_without_case(table.columns[c], name))
            continue;
        if (found)
            throw InputError(table.path + ":" + std::to_string(table.header_line) + ": has two columns '" +
                             table.columns[static_cast<std::size_t>(*found)] + "' and '" + table.columns[c] +
                             "', which are the same but for letter case");
        found = static_cast<Eigen::Index>(c);
    }
    return found;
}

Matrix csv_columns(const CsvTable& table, const std::vector<std::string>& names)
{
    Matrix chosen(table.rows.rows(), static_cast<Eigen::Index>(names.size()));
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto found = std::find(table.columns.begin(), table.columns.end(), names[i]);
        if (found == table.columns.end())
            throw InputError(table.path + ": has no column '" + names[i] + "', but " + joined(table.columns) +
                             did_you_mean(names[i], table.columns));
        for (Eigen::Index r = 0; r < chosen.rows(); ++r) // no blocks: without rows there is no first
            chosen(r, static_cast<Eigen::Index>(i)) = table.rows(r, found - table.columns.begin());
    }
    return chosen;
}

} // namespace morph
