#include "formats/case/entry_numbers.h"

namespace morph {

std::vector<Index> whole_numbers(const TomlTable& table, const std::string& key, Index base)
{
    constexpr double kMost = 2147483647;
    std::vector<Index> numbers;
    for (const double value : table.numbers(key).value_or(std::vector<double>())) {
        if (!(value >= base && value <= kMost && value == static_cast<double>(static_cast<Index>(value))))
            table.fail(table.line(key), key + " must be whole numbers from " + std::to_string(base) + " on");
        numbers.push_back(static_cast<Index>(value) - base);
    }
    return numbers;
}

Matrix points_of(const TomlTable& table, const std::string& key, const std::vector<std::string>& columns)
{
    if (!table.has(key))
        return Matrix::Zero(0, 3);
    const std::size_t width = table.row_width(key) == 3 ? 3 : 2;
    const Matrix rows =
        *table.rows(key, {columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(width)});
    Matrix full = Matrix::Zero(rows.rows(), 3);
    full.leftCols(rows.cols()) = rows;
    return full;
}

} // namespace morph
