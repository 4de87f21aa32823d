#pragma once

#include "libmorph/core/types.h"

#include <toml++/toml.h>

#include <optional>
#include <string>
#include <vector>

namespace morph::tools {

/// A table of a TOML file that checks what it is asked for: every complaint is "file:line: what was
/// expected", every number finite, and a key that nobody knows an error that names the nearest.
class TomlTable {
public:
    /// @param name  as a person would write it, such as "[mesh]", for messages
    TomlTable(const toml::table& table, std::string path, std::string name);

    /// @throws InputError  a key is not in @p known; names the nearest
    void require_known(const std::vector<std::string>& known) const;

    bool has(const std::string& key) const { return table_.contains(key); }
    int line() const { return line_of(table_); }
    int line(const std::string& key) const;
    const std::string& path() const { return path_; }

    /// Whether the value is a text in quotes.
    bool is_text(const std::string& key) const
    {
        return table_.contains(key) && table_.get(key)->is_string();
    }
    std::optional<std::string> string(const std::string& key) const;
    std::optional<bool> boolean(const std::string& key) const;
    std::optional<double> number(const std::string& key) const;
    /// A whole number in [least, most].
    std::optional<Index> integer(const std::string& key, Index least, Index most) const;
    std::optional<std::vector<double>> numbers(const std::string& key) const;
    std::optional<std::vector<std::string>> strings(const std::string& key) const;
    /// One of @p choices.
    std::optional<std::string> choice(const std::string& key, const std::vector<std::string>& choices) const;
    /// [[x, y], ...], or { file = "points.csv", columns = ["x", "y"] } with the path relative to this file;
    /// @p columns are the defaults.
    std::optional<Points2> pairs(const std::string& key, const std::vector<std::string>& columns) const;
    /// [[a, b, ...], ...] with as many numbers in each row as there are @p columns, or a file as above.
    std::optional<Matrix> rows(const std::string& key, const std::vector<std::string>& columns) const;
    /// How many entries the first of the rows of a list has; 0 where there is none.
    std::size_t row_width(const std::string& key) const;
    std::optional<TomlTable> table(const std::string& key, const std::string& name) const;
    /// [[key]] entries, none when the key is missing.
    std::vector<TomlTable> tables(const std::string& key) const;
    struct TextsAndTables {
        std::vector<std::string> texts;
        std::vector<TomlTable> tables;
    };
    /// The entries of a list of texts and tables, none when the key is missing.
    TextsAndTables texts_and_tables(const std::string& key) const;

    /// @throws InputError  "file:line: what"
    [[noreturn]] void fail(int line, const std::string& what) const;
    [[noreturn]] void fail_missing(const std::string& key, const std::string& example) const;

private:
    static int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }
    /// "[mesh] file", for messages.
    std::string label(const std::string& key) const { return name_ + " " + key; }
    double finite(const toml::node& node, const std::string& what) const;
    const toml::array& array(const std::string& key, const std::string& expected) const;
    Matrix rows_from_array(const std::string& key, const std::vector<std::string>& columns) const;
    Matrix rows_from_file(const std::string& key, const std::vector<std::string>& columns) const;

    const toml::table& table_;
    std::string path_;
    std::string name_;
};

/// A path in a case file is relative to the file's folder.
std::string beside(const std::string& file, const std::string& path);

} // namespace morph::tools
