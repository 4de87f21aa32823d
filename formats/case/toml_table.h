#pragma once

#include "libmorph/core/names.h"
#include "libmorph/core/types.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace morph {

/// A table of a TOML file that checks what it is asked for: every error is "file:line: what was expected", every
/// number finite, and an unknown key an error that names the nearest.
class TomlTable {
public:
    /// The whole of a file.
    /// @param path  of the file, for messages and relative paths in it
    /// @param name  of the table as a person would write it, for messages
    /// @throws InputError  "file:line: ..." where it is no TOML
    static TomlTable parse(std::string_view bytes, const std::string& path, const std::string& name);

    /// @throws InputError  a key is not in @p known; names the nearest
    void require_known(const std::vector<std::string>& known) const;

    bool has(const std::string& key) const;
    int line() const;
    int line(const std::string& key) const;

    /// "file:line: " of the table, in front of messages about it.
    std::string where() const { return where(line()); }
    std::string where(int line) const;

    /// Whether the value is a text in quotes.
    bool is_text(const std::string& key) const;
    std::optional<std::string> string(const std::string& key) const;
    std::optional<bool> boolean(const std::string& key) const;
    std::optional<double> number(const std::string& key) const;
    /// A whole number in [least, most].
    std::optional<Index> integer(const std::string& key, Index least, Index most) const;
    std::optional<std::vector<double>> numbers(const std::string& key) const;
    std::optional<std::vector<std::string>> strings(const std::string& key) const;
    /// One of @p choices.
    std::optional<std::string> choice(const std::string& key, const std::vector<std::string>& choices) const;
    /// The value of an enum by its name.
    template <NamedEnum Enum>
    std::optional<Enum> choice(const std::string& key) const
    {
        const std::optional<std::string> name = choice(key, names_of<Enum>());
        return name ? std::optional(from_string<Enum>(*name)) : std::nullopt;
    }
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
    struct Node; ///< of the document, which it keeps alive
    explicit TomlTable(std::shared_ptr<const Node> node) : node_(std::move(node)) {}

    Matrix rows_from_array(const std::string& key, const std::vector<std::string>& columns) const;
    Matrix rows_from_file(const std::string& key, const std::vector<std::string>& columns) const;

    std::shared_ptr<const Node> node_;
};

/// A path that a file names, which is relative to the file's folder.
std::string relative_to(const std::string& file, const std::string& path);

} // namespace morph
