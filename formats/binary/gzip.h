#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace morph {

/// True for what begins as gzip (RFC 1952) does.
bool is_gzip(std::string_view bytes);

/// The path without a last ".gz", in whatever case.
std::string without_gz(const std::string& path);

/// What the members of a gzip file stand for, one after another.
/// @param path  for messages
/// @throws InputError  the file is cut short or damaged, or what it stands for needs more memory than is free
std::string gunzip(std::string_view bytes, const std::string& path);

/// Refuse what could not be held next to the mesh made from it, before the kernel does.
/// @param bytes  size of the text or numbers of a file
/// @throws InputError  more than the free memory of the machine; says both
void require_memory(const std::string& path, std::size_t bytes);

} // namespace morph
