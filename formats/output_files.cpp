#include "formats/output_files.h"

namespace morph {

void OutputFiles::require_writable(const std::string& path)
{
    const OutputFile probe(path); // goes again without a trace
}

OutputFile& OutputFiles::open(const std::string& path)
{
    return *files_.emplace_back(std::make_unique<OutputFile>(path));
}

void OutputFiles::commit()
{
    for (const auto& file : files_) // a full disk shows here, before any file has its name
        file->close();
    for (const auto& file : files_)
        file->commit();
    files_.clear();
}

} // namespace morph
