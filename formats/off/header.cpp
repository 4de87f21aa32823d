#include "formats/off/header.h"

#include "formats/off/files.h"

namespace morph {

namespace {

bool take(std::string_view& word, std::string_view prefix)
{
    if (!word.starts_with(prefix))
        return false;
    word.remove_prefix(prefix.size());
    return true;
}

} // namespace

OffHeader read_off_header(TextScanner& in)
{
    in.skip_white();
    const std::size_t position = in.position();
    std::string_view word = in.word("OFF");
    const std::size_t behind = in.position();
    OffHeader header;
    header.texture = take(word, "ST");
    header.color = take(word, "C");
    header.normal = take(word, "N");
    if (word != "OFF") {
        in.seek(position);
        in.fail_expected("OFF, or OFF after C, N or ST for what else vertices have");
    }
    header.binary = in.rest_of_line() == "BINARY";
    if (!header.binary)
        in.seek(behind);
    return header;
}

bool add_off_fields(const OffHeader& header, const std::vector<double>& numbers, std::size_t width,
                    MeshData& mesh)
{
    const std::size_t others = (header.normal ? 3U : 0U) + (header.texture ? 2U : 0U);
    const std::size_t color = width < others ? 0 : width - others;
    if (width < others || (header.color ? color != 3 && color != 4 : color != 0))
        return false;
    const Eigen::Map<const Matrix> all(numbers.data(), mesh.points.rows(), static_cast<Eigen::Index>(width));
    Eigen::Index first = 0;
    const auto add = [&](std::string_view name, std::size_t columns) {
        const auto count = static_cast<Eigen::Index>(columns);
        mesh.fields.push_back({std::string(name), FieldLocation::vertex,
                               all.rows() == 0 ? Matrix(0, count) : Matrix(all.middleCols(first, count))});
        first += count;
    };
    if (header.normal)
        add(kOffNormal, 3);
    if (header.color)
        add(kOffColor, color);
    if (header.texture)
        add(kOffTexture, 2);
    return true;
}

} // namespace morph
