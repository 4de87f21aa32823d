#include "formats/cgns/fields.h"

#include "formats/cgns/file.h"
#include "formats/text/names_in_text.h"

#include <algorithm>
#include <sstream>

namespace morph {

namespace {

std::string component_ending(std::size_t component, std::size_t count)
{
    if (count == 1)
        return {};
    return count <= 3 ? std::string(1, "XYZ"[component]) : "_" + std::to_string(component + 1);
}

/// Takes arrays away as fields are made of them.
class ArrayJoiner {
public:
    explicit ArrayJoiner(std::vector<CgnsArray> arrays)
        : arrays_(std::move(arrays)), taken_(arrays_.size(), false)
    {
    }

    void join_by(const std::string& table)
    {
        std::istringstream lines(table);
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            std::string name;
            std::vector<std::size_t> columns;
            words >> name;
            for (std::string array; words >> array;)
                columns.push_back(find(cgns_decoded(array)));
            join(cgns_decoded(name), columns);
        }
    }

    void join_components()
    {
        for (std::size_t a = 0; a < arrays_.size(); ++a) {
            const std::string& name = arrays_[a].name;
            if (taken_[a])
                continue;
            std::vector<std::size_t> columns{a};
            const std::string stem =
                name.size() > 1 && name.back() == 'X' ? name.substr(0, name.size() - 1) : "";
            for (const char* ending : {"Y", "Z"})
                if (!stem.empty() && find(stem + ending) < arrays_.size())
                    columns.push_back(find(stem + ending));
                else
                    break;
            join(columns.size() > 1 ? stem : name, columns);
        }
    }

    /// In the order of the first component of each.
    std::vector<Field> fields()
    {
        std::sort(fields_.begin(), fields_.end(),
                  [](const auto& a, const auto& b) { return a.first < b.first; });
        std::vector<Field> fields;
        for (auto& [place, field] : fields_)
            fields.push_back(std::move(field));
        return fields;
    }

private:
    /// The array of that name that is left, or the number of arrays.
    std::size_t find(const std::string& name) const
    {
        for (std::size_t a = 0; a < arrays_.size(); ++a)
            if (!taken_[a] && arrays_[a].name == name)
                return a;
        return arrays_.size();
    }

    void join(const std::string& name, const std::vector<std::size_t>& columns)
    {
        const bool there = std::all_of(columns.begin(), columns.end(),
                                       [&](std::size_t a) { return a < arrays_.size() && !taken_[a]; });
        if (columns.empty() || columns.size() > 9 || !there)
            return;
        const auto rows = static_cast<Eigen::Index>(arrays_[columns[0]].values.size());
        Field field{name, FieldLocation::vertex, Matrix(rows, static_cast<Eigen::Index>(columns.size()))};
        for (std::size_t c = 0; c < columns.size(); ++c) {
            field.values.col(static_cast<Eigen::Index>(c)) =
                Eigen::Map<const Eigen::VectorXd>(arrays_[columns[c]].values.data(), rows);
            taken_[columns[c]] = true;
            arrays_[columns[c]].values = {};
        }
        fields_.emplace_back(columns[0], std::move(field));
    }

    std::vector<CgnsArray> arrays_;
    std::vector<bool> taken_;
    std::vector<std::pair<std::size_t, Field>> fields_; ///< with the place of the first component
};

} // namespace

std::vector<Field> fields_of_cgns_arrays(std::vector<CgnsArray> arrays, const std::string& table)
{
    ArrayJoiner joiner(std::move(arrays));
    joiner.join_by(table);
    joiner.join_components();
    return joiner.fields();
}

std::vector<std::vector<std::string>> cgns_array_names(const std::vector<const Field*>& fields)
{
    std::vector<std::string> taken;
    std::vector<std::vector<std::string>> names;
    for (const Field* field : fields) {
        const auto count = static_cast<std::size_t>(field->values.cols());
        auto& of_field = names.emplace_back();
        for (std::size_t c = 0; c < count; ++c) {
            const std::string ending = component_ending(c, count);
            of_field.push_back(
                cgns_node_name(field->name.substr(0, kCgnsNameLength - ending.size()) + ending, taken));
        }
    }
    return names;
}

std::string cgns_field_table(const std::vector<const Field*>& fields)
{
    const auto names = cgns_array_names(fields);
    std::string table;
    for (std::size_t f = 0; f < fields.size(); ++f) {
        table += cgns_encoded(fields[f]->name);
        for (const std::string& array : names[f])
            table += " " + cgns_encoded(array);
        table += "\n";
    }
    return table;
}

std::string cgns_node_name(const std::string& name, std::vector<std::string>& taken)
{
    std::string plain = name.substr(0, kCgnsNameLength);
    for (char& c : plain)
        if (c < ' ' || c > '~' || c == '/')
            c = '_';
    if (plain.find_first_not_of(" .") == std::string::npos)
        plain = "unnamed";
    // blanks at either end are lost in ADF
    plain.front() = plain.front() == ' ' ? '_' : plain.front();
    plain.back() = plain.back() == ' ' ? '_' : plain.back();
    std::string free = plain;
    for (int n = 2; std::find(taken.begin(), taken.end(), free) != taken.end(); ++n) {
        const std::string ending = "_" + std::to_string(n);
        free = plain.substr(0, kCgnsNameLength - ending.size()) + ending;
    }
    taken.push_back(free);
    return free;
}

// "%" alone, which encodes nothing else, stands for the empty name.
std::string cgns_encoded(const std::string& name)
{
    return name.empty() ? "%" : percent_encoded(name);
}

std::string cgns_decoded(const std::string& text)
{
    return text == "%" ? "" : percent_decoded(text);
}

} // namespace morph
