#include "formats/case/toml_table.h"

#include "formats/csv/table.h"
#include "libmorph/core/error.h"
#include "libmorph/core/names.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace morph {

namespace {

/// "a pair [x, y]", or "[i, j, dx, dy]".
std::string row_example(const std::vector<std::string>& columns)
{
    return (columns.size() == 2 ? "a pair [x, y]" : "[" + joined(columns) + "]");
}

int line_of(const toml::node& node)
{
    return static_cast<int>(node.source().begin.line);
}

} // namespace

struct TomlTable::Node {
    std::shared_ptr<const toml::table> document;
    const toml::table* table;
    std::string path;
    std::string name;

    std::shared_ptr<const Node> below(const toml::table& inner, std::string inner_name) const
    {
        return std::make_shared<const Node>(Node{document, &inner, path, std::move(inner_name)});
    }

    const toml::node* get(const std::string& key) const { return table->get(key); }

    /// "[mesh] file", for messages.
    std::string label(const std::string& key) const { return name + " " + key; }

    [[noreturn]] void fail(int line, const std::string& what) const
    {
        throw InputError(path + ":" + std::to_string(line) + ": " + what);
    }

    double finite(const toml::node& node, const std::string& what) const
    {
        const auto number = node.value<double>();
        if (!number || !(node.is_integer() || node.is_floating_point()))
            fail(line_of(node), what + " must be a number");
        if (!std::isfinite(*number))
            fail(line_of(node), what + " must be a finite number");
        return *number;
    }

    const toml::array& array(const std::string& key, const std::string& expected) const
    {
        const toml::node* node = get(key);
        const toml::array* items = node->as_array();
        if (!items)
            fail(line_of(*node), label(key) + " must be " + expected);
        return *items;
    }
};

TomlTable TomlTable::parse(std::string_view bytes, const std::string& path, const std::string& name)
{
    try {
        const auto document = std::make_shared<const toml::table>(toml::parse(bytes, path));
        return TomlTable(std::make_shared<const Node>(Node{document, document.get(), path, name}));
    } catch (const toml::parse_error& error) {
        throw InputError(path + ":" + std::to_string(error.source().begin.line) + ": " +
                         std::string(error.description()));
    }
}

bool TomlTable::has(const std::string& key) const
{
    return node_->get(key) != nullptr;
}

int TomlTable::line() const
{
    return line_of(*node_->table);
}

std::string TomlTable::where(int line) const
{
    return node_->path + ":" + std::to_string(line) + ": ";
}

bool TomlTable::is_text(const std::string& key) const
{
    const toml::node* node = node_->get(key);
    return node != nullptr && node->is_string();
}

void TomlTable::fail(int line, const std::string& what) const
{
    node_->fail(line, what);
}

void TomlTable::fail_missing(const std::string& key, const std::string& example) const
{
    fail(line(), node_->name + " needs " + key + ", such as " + example);
}

void TomlTable::require_known(const std::vector<std::string>& known) const
{
    for (const auto& [key, value] : *node_->table) {
        const std::string name(key.str());
        if (std::find(known.begin(), known.end(), name) == known.end())
            fail(static_cast<int>(key.source().begin.line), "unknown key '" + name + "' in " + node_->name +
                                                                did_you_mean(name, known) +
                                                                " (known: " + joined(known) + ")");
    }
}

int TomlTable::line(const std::string& key) const
{
    const toml::node* node = node_->get(key);
    return node ? line_of(*node) : line();
}

std::optional<std::string> TomlTable::string(const std::string& key) const
{
    const toml::node* node = node_->get(key);
    if (!node)
        return std::nullopt;
    const auto* text = node->as_string();
    if (!text)
        fail(line_of(*node), node_->label(key) + " must be a text in quotes");
    return text->get();
}

std::optional<bool> TomlTable::boolean(const std::string& key) const
{
    const toml::node* node = node_->get(key);
    if (!node)
        return std::nullopt;
    const auto* flag = node->as_boolean();
    if (!flag)
        fail(line_of(*node), node_->label(key) + " must be true or false");
    return flag->get();
}

std::optional<double> TomlTable::number(const std::string& key) const
{
    const toml::node* node = node_->get(key);
    return node ? std::optional(node_->finite(*node, node_->label(key))) : std::nullopt;
}

std::optional<Index> TomlTable::integer(const std::string& key, Index least, Index most) const
{
    const toml::node* node = node_->get(key);
    if (!node)
        return std::nullopt;
    const auto* value = node->as_integer();
    if (!value || value->get() < least || value->get() > most)
        fail(line_of(*node), node_->label(key) + " must be a whole number from " + std::to_string(least) +
                                 " to " + std::to_string(most));
    return static_cast<Index>(value->get());
}

std::optional<std::vector<double>> TomlTable::numbers(const std::string& key) const
{
    if (!has(key))
        return std::nullopt;
    std::vector<double> values;
    for (const toml::node& item : node_->array(key, "a list of numbers"))
        values.push_back(node_->finite(item, node_->label(key)));
    return values;
}

std::optional<std::vector<std::string>> TomlTable::strings(const std::string& key) const
{
    if (!has(key))
        return std::nullopt;
    std::vector<std::string> values;
    for (const toml::node& item : node_->array(key, "a list of names in quotes")) {
        const auto* text = item.as_string();
        if (!text)
            fail(line_of(item), node_->label(key) + " must be a list of names in quotes");
        values.push_back(text->get());
    }
    return values;
}

std::optional<std::string> TomlTable::choice(const std::string& key,
                                             const std::vector<std::string>& choices) const
{
    std::optional<std::string> value = string(key);
    if (value && std::find(choices.begin(), choices.end(), *value) == choices.end())
        fail(line(key), node_->label(key) + " is '" + *value + "', but it must be one of " + joined(choices) +
                            did_you_mean(*value, choices));
    return value;
}

std::optional<Points2> TomlTable::pairs(const std::string& key, const std::vector<std::string>& columns) const
{
    const std::optional<Matrix> found = rows(key, columns);
    return found ? std::optional<Points2>(*found) : std::nullopt;
}

std::optional<Matrix> TomlTable::rows(const std::string& key, const std::vector<std::string>& columns) const
{
    const toml::node* node = node_->get(key);
    if (!node)
        return std::nullopt;
    return node->is_table() ? rows_from_file(key, columns) : rows_from_array(key, columns);
}

std::size_t TomlTable::row_width(const std::string& key) const
{
    const toml::node* node = node_->get(key);
    const toml::array* items = node == nullptr ? nullptr : node->as_array();
    const toml::array* row = items == nullptr || items->empty() ? nullptr : items->get(0)->as_array();
    return row == nullptr ? 0 : row->size();
}

Matrix TomlTable::rows_from_array(const std::string& key, const std::vector<std::string>& columns) const
{
    const bool pairs = columns.size() == 2;
    const std::string expected = std::string(pairs ? "a list of pairs [[x, y], ...]"
                                                   : "a list of rows [[" + joined(columns) + "], ...]") +
                                 " or { file = \"points.csv\" }";
    const toml::array& items = node_->array(key, expected);
    Matrix found(static_cast<Eigen::Index>(items.size()), static_cast<Eigen::Index>(columns.size()));
    Eigen::Index row = 0;
    for (const toml::node& item : items) {
        const toml::array* numbers = item.as_array();
        const std::string what = node_->label(key) + ", entry " + std::to_string(row + 1) + ",";
        if (!numbers || numbers->size() != columns.size())
            fail(line_of(item), what + " must be " + row_example(columns));
        for (std::size_t c = 0; c < columns.size(); ++c)
            found(row, static_cast<Eigen::Index>(c)) = node_->finite((*numbers)[c], what);
        ++row;
    }
    return found;
}

Matrix TomlTable::rows_from_file(const std::string& key, const std::vector<std::string>& columns) const
{
    const TomlTable source(node_->below(*node_->get(key)->as_table(), node_->label(key)));
    source.require_known({"file", "columns"});
    const auto file = source.string("file");
    if (!file)
        source.fail_missing("file", "{ file = \"points.csv\", columns = [\"x\", \"y\"] }");
    const auto names = source.strings("columns").value_or(columns);
    if (names.size() != columns.size())
        source.fail(source.line("columns"),
                    node_->label(key) + " columns must be " +
                        (columns.size() == 2 ? "two" : std::to_string(columns.size())) + " names");
    return csv_columns(read_csv_table(relative_to(node_->path, *file)), names);
}

std::optional<TomlTable> TomlTable::table(const std::string& key, const std::string& name) const
{
    const toml::node* node = node_->get(key);
    if (!node)
        return std::nullopt;
    if (!node->is_table())
        fail(line_of(*node), name + " must be a table");
    return TomlTable(node_->below(*node->as_table(), name));
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) const
{
    std::vector<TomlTable> entries;
    if (!has(key))
        return entries;
    const std::string name = "[[" + key + "]]";
    const std::string expected = "written as " + name;
    for (const toml::node& item : node_->array(key, expected)) {
        if (!item.is_table())
            fail(line_of(item), node_->label(key) + " must be " + expected);
        entries.push_back(TomlTable(node_->below(*item.as_table(), name)));
    }
    return entries;
}

TomlTable::TextsAndTables TomlTable::texts_and_tables(const std::string& key) const
{
    TextsAndTables entries;
    if (!has(key))
        return entries;
    const std::string expected = "a list of texts in quotes and tables in braces";
    for (const toml::node& item : node_->array(key, expected)) {
        if (item.is_table())
            entries.tables.push_back(TomlTable(node_->below(*item.as_table(), node_->label(key))));
        else if (item.is_string())
            entries.texts.push_back(item.as_string()->get());
        else
            fail(line_of(item), node_->label(key) + " must be " + expected);
    }
    return entries;
}

std::string relative_to(const std::string& file, const std::string& path)
{
    return (std::filesystem::path(file).parent_path() / path).string();
}

} // namespace morph
