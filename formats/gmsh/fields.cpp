#include "formats/gmsh/fields.h"

#include "formats/text/text_scanner.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace morph {

namespace {

constexpr Index kMostComponents = 9;

/// Sections that give few values make whole fields all the same; past this many numbers for all of them, a
/// file is broken or meant to be harmful.
std::size_t most_numbers(std::size_t file_bytes)
{
    constexpr std::size_t kForAnyFile = std::size_t{1} << 24U;
    return kForAnyFile + 2 * file_bytes; // a complete field takes 2 bytes or more for each number
}

std::string_view without_quotes(std::string_view line)
{
    const bool quoted = line.size() >= 2 && line.front() == '"' && line.back() == '"';
    return quoted ? line.substr(1, line.size() - 2) : line;
}

std::string plural_of(FieldLocation location)
{
    return location == FieldLocation::vertex ? "vertices" : "elements";
}

} // namespace

GmshFields::Header GmshFields::read_header()
{
    Header header;
    TextScanner& text = in_.text();
    const auto count = [&](std::string_view what) {
        text.skip_white();
        return text.index(what);
    };
    const Index strings = count("the number of text tags");
    for (Index i = 0; i < strings; ++i) {
        text.skip_line();
        if (text.rest().starts_with("$End"))
            text.fail_expected("a text tag");
        const std::string_view line = without_quotes(text.rest_of_line());
        if (i == 0)
            header.name = line;
    }
    for (Index reals = count("the number of real tags"); reals > 0; --reals) {
        text.skip_white();
        text.real("a real tag");
    }
    const Index integers = count("the number of integer tags");
    if (integers < 3)
        text.fail("expected 3 or more integer tags: the time step, the number of components, the number of "
                  "values; found " +
                  std::to_string(integers));
    header.step = count("the time step");
    header.components = count("the number of components");
    if (header.components < 1 || header.components > kMostComponents)
        text.fail("data '" + header.name + "' has " + std::to_string(header.components) +
                  " components, expected 1 to 9");
    header.rows = count("the number of values");
    for (Index i = 3; i < integers; ++i)
        count("an integer tag");
    text.skip_line();
    in_.begin_numbers();
    header.kept = header.components;
    if (const GmshNames::FieldNote* note = long_names_.field(++sections_)) {
        header.name = note->name;
        header.kept = std::clamp<Index>(note->components, 1, header.components);
    }
    return header;
}

std::string GmshFields::free_name(const Header& header, FieldLocation location) const
{
    std::string name = header.name;
    if (find_field(mesh_.fields, name, location))
        name += "_step_" + std::to_string(header.step);
    return name;
}

std::size_t GmshFields::field_for(const Header& header, FieldLocation location)
{
    for (std::size_t f = 0; f < known_.size(); ++f)
        if (known_[f].name == header.name && known_[f].step == header.step &&
            mesh_.fields[f].location == location && mesh_.fields[f].values.cols() == header.kept)
            return f;
    const auto rows = location == FieldLocation::vertex ? mesh_.points.rows()
                                                        : static_cast<Eigen::Index>(mesh_.elements.size());
    numbers_ += static_cast<std::size_t>(rows * header.kept);
    if (numbers_ > most_numbers(file_.bytes.size()))
        in_.text().fail("data '" + header.name + "' would make " + std::to_string(numbers_) +
                        " numbers of fields, most of them not given, from a file of " +
                        std::to_string(file_.bytes.size()) + " bytes");
    mesh_.fields.push_back({free_name(header, location), location,
                            Matrix::Constant(rows, header.kept, std::numeric_limits<double>::quiet_NaN())});
    known_.push_back({header.name, header.step, std::vector<bool>(static_cast<std::size_t>(rows))});
    return known_.size() - 1;
}

double GmshFields::value()
{
    if (in_.binary())
        return in_.real("a value");
    one_.clear();
    if (!read_numbers(in_.text(), 1, one_) || one_.empty())
        in_.text().fail_expected("a value");
    return one_[0];
}

void GmshFields::read(FieldLocation location)
{
    const Header header = read_header();
    const std::size_t number = field_for(header, location);
    Matrix& values = mesh_.fields[number].values;
    const GmshTags& tags = location == FieldLocation::vertex ? nodes_ : elements_;
    for (Index i = 0; i < header.rows; ++i) {
        const Index row = tags.find(in_.integer("the tag of a node or element"));
        for (Index k = 0; k < header.components; ++k) {
            const double x = value();
            if (row >= 0 && k < header.kept)
                values(row, k) = x;
        }
        if (row >= 0)
            known_[number].seen[static_cast<std::size_t>(row)] = true;
    }
    in_.leave();
}

void GmshFields::finish()
{
    for (std::size_t f = known_.size(); f-- > 0;) {
        const Field& field = mesh_.fields[f];
        const auto missing = std::count(known_[f].seen.begin(), known_[f].seen.end(), false);
        if (missing == 0)
            continue;
        const bool none = missing == field.values.rows();
        file_.warn("data '" + field.name + "' has no values for " + (none ? "any" : std::to_string(missing)) +
                   " of the " + std::to_string(field.values.rows()) + " " + plural_of(field.location) + ": " +
                   (none ? "left out" : "they are NaN there"));
        if (none)
            mesh_.fields.erase(mesh_.fields.begin() + static_cast<std::ptrdiff_t>(f));
    }
}

} // namespace morph
