#include "formats/csv_table.h"

#include "formats/input_file.h"
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

/// The names in a header line; in quotes they may hold commas, and quotes twice.
std::vector<std::string> header_cells(std::string_view line)
{
    std::vector<std::string> names(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool doubled = quoted && line.substr(i, 2) == "\"\"";
        if (line[i] == '"' && !doubled)
            quoted = !quoted;
        else if (line[i] == ',' && !quoted)
            names.emplace_back();
        else
            names.back() += line[i];
        i += doubled ? 1 : 0;
    }
    for (std::string& name : names) {
        const auto first = name.find_first_not_of(" \t\r");
        const auto last = name.find_last_not_of(" \t\r");
        name = first == std::string::npos ? "" : name.substr(first, last - first + 1);
    }
    return names;
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
        for (const std::string& name : header_cells(line)) {
            if (std::find(table_.columns.begin(), table_.columns.end(), name) != table_.columns.end())
                fail(number, "names the column '" + name + "' twice");
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
        const std::string_view digits = cell.substr(cell.empty() || cell.front() != '+' ? 0 : 1);
        double value = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value))
            fail(line, "column '" + table_.columns[column] + "' is '" + std::string(cell.substr(0, 40)) +
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

std::string lower_case(std::string_view text)
{
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

} // namespace

CsvTable parse_csv_table(std::string_view bytes, const std::string& path)
{
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
    for (std::size_t c = 0; c < table.columns.size(); ++c)
        if (lower_case(table.columns[c]) == lower_case(name))
            return static_cast<Eigen::Index>(c);
    return std::nullopt;
}

Matrix csv_columns(const CsvTable& table, const std::vector<std::string>& names)
{
    Matrix chosen(table.rows.rows(), static_cast<Eigen::Index>(names.size()));
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto found = std::find(table.columns.begin(), table.columns.end(), names[i]);
        if (found == table.columns.end())
            throw InputError(table.path + ": has no column '" + names[i] + "', but " + joined(table.columns) +
                             did_you_mean(names[i], table.columns));
        chosen.col(static_cast<Eigen::Index>(i)) = table.rows.col(found - table.columns.begin());
    }
    return chosen;
}

} // namespace morph
